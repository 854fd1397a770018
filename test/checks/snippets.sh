#!/bin/sh
# Runs the fenced blocks of README.md and doc/*.md as a reader would who copies them. The ```console blocks are left to
# commands.sh; a block of a language not known here fails.
#
#   snippets.sh TOP session BUILD
#      every page in a scratch copy of the tree with a home of its own, block after block: `sh` is run, in one go; a block
#      behind a line that ends in "`NAME`:" becomes the file NAME, or must equal it where the tree has one; a namelist is a scene.
#   snippets.sh TOP programs PREFIX FORTRAN_FLAGS C_FLAGS [--static]
#      every program (fortran, c, cpp, python) of every page, built against the kyvadlo installed in PREFIX, and run.
set -u
cd "$1" || exit 1
top=$PWD
mode=$2
place=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
bad=0
run=0
complain() { echo "$page:$line: $*"; bad=$((bad + 1)); }

# Why a command is not run here; nothing for one that is.
reason_against() {
   case $1 in
      './bootstrap install '*) ;;      # of what is built
      './bootstrap '* | './bootstrap' | 'git clone '* | 'cd kyvadlo') echo 'CI runs it, on a fresh clone' ;;
      'cmake --workflow --preset '* | 'bash .ci/run'*) echo 'CI runs it' ;;
      'cmake '*' part'* | 'part/'* | 'cmake -S fetched'*) echo 'the test part_of_another_project does it' ;;
      'fpm test' | 'fpm build '*) echo 'the test fpm_builds_and_tests_the_core does it' ;;
      'cpack '*) echo 'the test consumer_of_debian_package does it' ;;
      'cmake --preset '* | 'cmake --build '*' --target kyvadlo_to_install' | 'cmake --build '*' --target site') echo 'it is built; the test site_is_written does the site' ;;
      'cmake --build '*' --target '*_page) echo 'takes minutes; the tests accuracy_keeps_its_promises, hard_cases_keep_their_promises do it' ;;
      'cmake --build '*' --target pictures') echo 'the test pictures_are_drawn does it' ;;
      'sudo apt-get install '* | 'apt-get install '* | 'pip install '*) echo 'CI installs' ;;
      *' --write') echo 'it would change the sources' ;;
      'python '*) echo 'the tests in python/tests do it' ;;
      'kyvadlo-bench'*) echo 'takes a minute; the test bench_prints_its_tables does it, shorter' ;;
   esac
}

# The tool in a command that is not installed here, and that ./bootstrap does not install.
absent_tool() {
   for tool in fpm gnuplot python3 pkg-config c++ g++ f2py ford dot; do
      case " $1" in
         *[\ \(]$tool\ *) command -v "$tool" >/dev/null 2>&1 || { echo "$tool"; return; } ;;
      esac
   done
   case $1 in
      *checks/style.sh*) command -v findent || command -v fortitude || command -v shellcheck || echo findent ;;
      'cmake -S mine '*) ! grep -q 'LANGUAGES CXX' "$scratch/session/mine/CMakeLists.txt" || command -v c++ || echo c++ ;;
   esac | sed '/\//d'
}

# The blocks, as files $scratch/blocks/N, and a list of them: N page line language name.
mkdir "$scratch/blocks"
awk -v dir="$scratch/blocks" '
   FNR == 1 { inside = 0; before = "" }
   !inside && /^```/ {
      inside = 1; n++
      language = substr($0, 4); if (language == "") language = "none"
      name = "-"
      if (before ~ /^<!-- lines of /) name = "lines"      # tree.sh compares them
      if (match(before, /`[^` ]+`:$/)) name = substr(before, RSTART + 1, RLENGTH - 3)
      print n, FILENAME, FNR, language, name
      printf "" > (dir "/" n)
      next
   }
   inside && /^```$/ { inside = 0; close(dir "/" n); before = ""; next }
   inside { print > (dir "/" n); next }
   /[^ ]/ { before = $0 }' README.md doc/*.md > "$scratch/list"
[ "$(wc -l <"$scratch/list")" -gt 10 ] || { echo 'only a few blocks found: this check reads the pages wrongly'; exit 1; }

# A program in capitals is Fortran 77.
is_fixed_form() { grep -q '^      PROGRAM ' "$1"; }

if [ "$mode" = programs ]; then
   flags=$4
   c_flags=$5
   static=${6-}
   pc=$(find "$place" -name kyvadlo.pc)
   libraries=${pc%/pkgconfig/*}
   PKG_CONFIG_PATH=${pc%/*} LD_LIBRARY_PATH=$libraries
   export PKG_CONFIG_PATH LD_LIBRARY_PATH
   found=$(pkg-config --cflags --libs $static kyvadlo) || exit 1
   while read -r n page line language name <&3; do
      block=$scratch/blocks/$n
      case $language in
         fortran) if is_fixed_form "$block"; then source=program.f; option=-std=legacy; else source=program.f90; option=-std=f2018; fi
            compile="gfortran $option $flags" ;;
         c) source=program.c; compile="${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror $c_flags" ;;
         cpp) source=program.cpp; compile="${CXX:-c++} -std=c++11 -pedantic -Wall -Wextra -Werror $c_flags" ;;
         python) [ "$page" != doc/python.md ] || continue     # python/tests/test_pages.py runs them
            source=program.py; compile= ;;
         *) continue ;;
      esac
      # A build without GSL has no integrator and no fits.
      if grep -q -e 'use kyvadlo_integrator' -e 'use kyvadlo_fit' -e 'gsl' "$block"; then
         [ -n "$(find "$place" -name kyvadlo_integrator.mod)" ] || continue
      fi
      gsl=
      if grep -q '<gsl/' "$block"; then gsl=$(pkg-config --cflags --libs gsl) || continue; fi
      cp "$block" "$scratch/$source"
      cd "$scratch" || exit 1
      if [ "$language" = python ]; then
         [ -z "$static" ] || continue          # ctypes needs the shared library
         python3 program.py >out 2>&1 || { complain "this $language fails:"; cat out; }
      elif $compile -o program "$source" $found $gsl -lm >out 2>&1; then
         ./program >out 2>&1 </dev/null || { complain "this $language fails:"; cat out; }
      else
         complain "this $language does not compile:"; cat out
      fi
      run=$((run + 1))
      cd "$top" || exit 1
   done 3<"$scratch/list"
   [ "$run" -gt 3 ] || { echo "only $run programs found"; exit 1; }
   [ "$bad" -eq 0 ] || exit 1
   echo "$run programs of the pages compile and run"
   exit
fi

# --- session ---
PATH=$place/bin:$place/examples:$PATH HOME=$scratch/home
export PATH HOME
unset DESTDIR CMAKE_PREFIX_PATH PKG_CONFIG_PATH CMAKE_GENERATOR
page=
while read -r n name_of_page line language name <&3; do
   if [ "$name_of_page" != "$page" ]; then
      page=$name_of_page
      rm -rf "$scratch/session" "$HOME"
      mkdir -p "$scratch/session/build" "$HOME"
      if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then git ls-files -z
      else find . \( -path ./build -o -path ./.git \) -prune -o \( -type f -o -type l \) -print0
      fi | tar --null -T - -cf - | tar -xf - -C "$scratch/session"
      ln -s "$place" "$scratch/session/build/release"
   fi
   block=$scratch/blocks/$n
   case $language in
      console) continue ;;
      text) [ "$page" = doc/speed.md ] || [ "$page" = doc/python.md ] || [ "$page" = doc/accuracy_tables.md ] || [ "$name" = lines ] ||
            complain 'text is for measurements that differ from run to run: doc/speed.md, doc/accuracy_tables.md, or lines of them'
         continue ;;
      sh | namelist | fortran | c | cpp | python | cmake | toml) ;;
      *) complain "no test knows the language '$language'"; continue ;;
   esac
   if [ "$name" != - ]; then
      if [ -e "$name" ]; then
         diff "$block" "$name" >"$scratch/out" || { complain "not as in $name"; cat "$scratch/out"; }
      else
         mkdir -p "$(dirname "$scratch/session/$name")"
         cp "$block" "$scratch/session/$name"
      fi
      run=$((run + 1))
   fi
   case $language in
      cmake | toml) [ "$name" != - ] || complain "say which file this is: a line before it that ends in \`NAME\`:" ;;
      namelist)
         "$place/bin/kyvadlo" table "$block" >"$scratch/out" 2>&1 || { complain 'no scene:'; cat "$scratch/out"; }
         run=$((run + 1)) ;;
      sh)
         : >"$scratch/script"
         absent=
         while IFS= read -r command <&4; do
            command=$(printf '%s\n' "$command" | sed 's/  *#.*//')
            [ -n "$command" ] || continue
            why=$(reason_against "$command")
            absent=${absent:-$(absent_tool "$command")}      # what follows in the block needs it too
            [ -z "$absent" ] || why="$absent is not here"
            if [ -n "$why" ]; then echo "$page:$line: not run: $command ($why)"; continue; fi
            case $command in
               './bootstrap install '*) command="cmake --install build/release --prefix ${command##* }" ;;
            esac
            printf '%s\n' "$command" >>"$scratch/script"
            run=$((run + 1))
         done 4<"$block"
         (cd "$scratch/session" && sh -e -x "$scratch/script") >"$scratch/out" 2>&1 </dev/null ||
            { complain 'fails:'; tail -n 30 "$scratch/out"; } ;;
   esac
done 3<"$scratch/list"
[ "$run" -gt 5 ] || { echo "only $run blocks were run"; exit 1; }
[ "$bad" -eq 0 ] || exit 1
echo "$run commands and files of the pages work"
