#!/bin/sh
# Rules of the tree that no compiler checks. Prints every breach and fails if there is one.
#
#   tree.sh TOP
set -u
cd "$1" || exit 1
if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
   files() { git ls-files -- "$@"; }
else
   files() { for name in "$@"; do [ ! -e "$name" ] || find "$name" -name .git -prune -o -path ./build -prune -o -type f -print; done; }
fi
breaches=0

# refuse WHAT EXTENDED_REGEX PATH...: no file under these paths may have such a line. `[x]` keeps this script clean itself.
refuse() {
   what=$1; pattern=$2; shift 2
   found=$(files "$@" | tr '\n' '\0' | xargs -0 -r grep -s -n -I -i -E -e "$pattern" /dev/null)
   if [ -n "$found" ]; then
      printf '%s:\n%s\n' "$what" "$found"
      breaches=$((breaches + 1))
   fi
}

count=$(files . | wc -l)
[ "$count" -gt 20 ] || { echo "only $count files found: this check looks in the wrong place"; exit 1; }

refuse 'path of one machine' '(^|[^A-Za-z0-9_.)])/(wor[k]|tm[p]/build|roo[t]|home)/[a-z.]' .
refuse 'unfinished mark' '\b(TOD[O]|FIXM[E]|XX[X])\b' src test examples doc cmake bootstrap README.md CMakeLists.txt
refuse 'fast-math' '^[^#].*(-[O]fast|-ffast-mat[h]|-funsafe-mat[h])' bootstrap .ci cmake/compiler_flags.cmake CMakeLists.txt CMakePresets.json src bench examples

# Only the program prints or stops.
refuse 'the library prints or stops' '^[^!'"'"'"]*\b((error )?stop\b|print *(\*|'"'"')|write *\( *\*)' \
   src/kinds.f90 src/status.f90 src/kyvadlo.F90 src/arithmetic src/arithmetic src/elliptic src/pendulum src/numeric src/scene src/interfaces

# State lives in arguments.
refuse 'saved state' '^[^!]*(\bsave\b *(::|$)|, *save\b)' src/arithmetic src/elliptic src/pendulum src/numeric src/scene src/interfaces

long=$(files src | xargs wc -l | awk '$2 != "total" && $1 > 500 { print $2 ": " $1 " lines" }')
[ -z "$long" ] || { printf 'longer than 500 lines:\n%s\n' "$long"; breaches=$((breaches + 1)); }
wide=$(files src test examples | grep -E '\.(f90|F90|inc|pf|c|h)$' | tr '\n' '\0' |
   xargs -0 -r awk 'length($0) > 140 { print FILENAME ":" FNR ": " length($0) " columns" }')
[ -z "$wide" ] || { printf 'lines over 140 columns:\n%s\n' "$wide"; breaches=$((breaches + 1)); }
wide=$(files src bench | grep -E '\.(f90|F90|inc)$' | tr '\n' '\0' |
   xargs -0 -r awk 'length($0) > 120 { print FILENAME ":" FNR ": " length($0) " columns" }')
[ -z "$wide" ] || { printf 'Fortran lines of src and bench over 120 columns:\n%s\n' "$wide"; breaches=$((breaches + 1)); }

# fpm finds the modules that a source uses in the source only, not in what it includes: they must be named there too.
unnamed=$(for source in src/arithmetic/*.F90 src/elliptic/*.F90 src/pendulum/*.F90; do
   folder=${source%/*}
   included=$(sed -n 's/^#include "\(.*\)"/\1/p' "$source" | sort -u)
   while :; do   # what the included files include
      more=$(for name in $included; do echo "$name"; [ ! -f "$folder/$name" ] || sed -n 's/^#include "\(.*\)"/\1/p' "$folder/$name"; done | sort -u)
      [ "$more" != "$included" ] || break
      included=$more
   done
   for name in $included; do
      [ -f "$folder/$name" ] || continue
      sed -n 's/^ *use \(kyvadlo_[a-z0-9_]*\).*/\1/p' "$folder/$name" | while read -r module; do
         grep -E -q "^ *(use|module) $module\\b" "$source" || echo "$source: use $module, only:"
      done
   done | sort -u
done)
[ -z "$unnamed" ] || { printf 'modules used by included files only:\n%s\n' "$unnamed"; breaches=$((breaches + 1)); }

# What a page quotes behind <!-- lines of FILE --> stands in FILE, and every page is named in the README.
quoted=$(awk '
   /^<!-- lines of [^ ]+ -->$/ {
      file = $4; from = FNR; count = 0
      delete line; while ((getline text < file) > 0) line[text] = 1
      close(file); inside = 1; next
   }
   inside && /^```/ { fenced = !fenced; if (!fenced) inside = 0; next }
   inside && /^$/ && !fenced { if (!count) print FILENAME ":" from ": quotes nothing of " file; inside = 0; next }
   inside && !/^$/ { count++; if (!($0 in line)) print FILENAME ":" FNR ": not in " file ": " $0 }' README.md doc/*.md)
[ -z "$quoted" ] || { printf 'quoted wrongly:\n%s\n' "$quoted"; breaches=$((breaches + 1)); }
for page in README.md doc/*.md; do
   for link in $(grep -o '](\([^)#]*\)' "$page" | sed 's/^](//' | grep -v '^https*:'); do
      [ -e "$(dirname "$page")/$link" ] || { echo "$page: a link to $link, which is not there"; breaches=$((breaches + 1)); }
   done
done
for page in doc/*.md; do
   grep -q -F "($page)" README.md || { echo "README.md does not name $page"; breaches=$((breaches + 1)); }
done

# One version: these cannot read it from CMake.
version=$(sed -n 's/^project(kyvadlo VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
states() { grep -q "$2" "$1" || { echo "$1 is not of version $version"; breaches=$((breaches + 1)); }; }
states fpm.toml "^version = \"$version\"$"
states CITATION.cff "^version: $version$"
states CHANGELOG.md "^## $version\( \|$\)"
states src/release.f90 "kyvadlo_version_number = '$version'$"
states src/interfaces/kyvadlo.h "^#define KYVADLO_VERSION \"$version\"$"

[ "$breaches" -eq 0 ] || exit 1
echo "$count files, no breach"
