#!/bin/sh
# Runs the commands of the ```console blocks of a page and compares what they print with what the page shows.
#
#   commands.sh TOP FOLDER_OF_PROGRAMS PAGE [--write]
#
# In a block, a line `$ command` is run by sh in TOP, with FOLDER_OF_PROGRAMS first in PATH; the lines up to the next `$` or
# the end of the block are its output, standard error included. Commands that begin with ./bootstrap are left to CI. With
# --write the page is given the output instead: read the difference before committing it.
set -u
cd "$1" || exit 1
PATH=$2:$PATH; export PATH
page=$3
write=${4-}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

awk -v dir="$scratch" '
   /^```console$/ { inside = 1; next }
   /^```/ { inside = 0; next }
   inside && /^\$ / {
      n++
      print substr($0, 3) > (dir "/" n ".command")
      print FNR > (dir "/" n ".line")
      printf "" > (dir "/" n ".expected")
      next
   }
   inside && n { print > (dir "/" n ".expected") }
   END { print n + 0 > (dir "/count") }' "$page"

count=$(cat "$scratch/count")
[ "$count" -gt 0 ] || { echo "$page: no command found"; exit 1; }
bad=0
run=0
i=0
while [ "$i" -lt "$count" ]; do
   i=$((i + 1))
   command=$(cat "$scratch/$i.command")
   case $command in ./bootstrap*) cp "$scratch/$i.expected" "$scratch/$i.got"; continue ;; esac
   # An example in C++ is not built where there is no such compiler; pictures and pages need their tools.
   for tool in orbit_cpp damped_swing gnuplot python3 pkg-config fpm; do
      case " $command" in
         *[\ \|]$tool*) command -v "$tool" >/dev/null 2>&1 && continue
            echo "$page:$(cat "$scratch/$i.line"): not run: $command ($tool is not here)"
            cp "$scratch/$i.expected" "$scratch/$i.got"
            continue 2 ;;
      esac
   done
   run=$((run + 1))
   sh -c "$command" >"$scratch/$i.got" 2>&1 </dev/null
   if ! diff "$scratch/$i.expected" "$scratch/$i.got" >"$scratch/difference"; then
      echo "$page:$(cat "$scratch/$i.line"): $command"
      cat "$scratch/difference"
      bad=$((bad + 1))
   fi
done

if [ "$write" = --write ]; then
   awk -v dir="$scratch" '
      /^```console$/ { inside = 1; print; next }
      /^```/ { inside = 0; print; next }
      inside && /^\$ / {
         n++
         print
         while ((getline line < (dir "/" n ".got")) > 0) print line
         next
      }
      inside && n { next }
      { print }' "$page" >"$scratch/page" && cp "$scratch/page" "$page"
   exit
fi
[ "$bad" -eq 0 ] || exit 1
[ "$run" -gt 0 ] || { echo "$page: what its commands need is not here"; exit 77; }
echo "$page: $run commands print what it shows"
