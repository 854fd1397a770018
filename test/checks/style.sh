#!/bin/sh
# Indentation by findent, lint by fortitude and of the shell scripts by shellcheck, each where it is installed; exit status 77
# where none is.
#
#   style.sh TOP             says what differs
#   style.sh TOP --write     indents the sources
#
# findent: apt-get install findent, or pip install findent; fortitude: pip install fortitude-lint; apt-get install shellcheck.
set -u
cd "$1" || exit 1
write=${2-}
breaches=0
tools=0

if command -v findent >/dev/null 2>&1; then
   tools=1
   scratch=$(mktemp)
   trap 'rm -f "$scratch"' EXIT
   count=0
   # Templates (.inc) are pieces of modules: findent cannot know how deep they begin.
   for source in $(find src examples fpm/test test/consumer test/support test/study -name '*.f90' -o -name '*.F90'); do
      count=$((count + 1))
      findent -ifree -i3 -k- -c3 -C3 <"$source" >"$scratch"
      if ! diff "$source" "$scratch" >/dev/null; then
         if [ "$write" = --write ]; then
            cat "$scratch" >"$source"
            echo "$source: indented"
         else
            echo "$source: not as findent indents it"
            diff "$source" "$scratch" | head -n 6
            breaches=$((breaches + 1))
         fi
      fi
   done
   [ "$count" -gt 20 ] || { echo "only $count sources found"; exit 1; }
   echo "findent: $count sources"
fi

if command -v fortitude >/dev/null 2>&1; then
   tools=1
   # Not for us: C001, C002, C131 (implicit none and private stand in the included templates), C121 (generic names are
   # merged by use without only), C003, S061, S231, S241 (taste), C071 and C072 (arrays and texts from Fortran 77 and C),
   # C092 (external procedures), C152, C011 (taste), E000 (it does not preprocess).
   fortitude check --ignore C001,C002,C003,C011,C071,C072,C092,C121,C131,C152,E000,S061,S231,S241 --line-length 140 \
      --output-format concise src examples 2>&1 || breaches=$((breaches + 1))
fi

if command -v shellcheck >/dev/null 2>&1; then
   tools=1
   # Not for us: SC2044 and SC2010 (no name here holds a blank); expect.sh is sourced, and sets variables for who does so (SC2034), and it sets some (SC2154).
   shellcheck --shell=sh --severity=warning --exclude=SC2010,SC2034,SC2044,SC2154 bootstrap test/*.sh test/*/*.sh && echo 'shellcheck: done' ||
      breaches=$((breaches + 1))
   shellcheck --severity=warning .ci/run || breaches=$((breaches + 1))
fi

[ "$tools" -ne 0 ] || { echo 'none of findent, fortitude, shellcheck is installed: nothing checked'; exit 77; }
[ "$breaches" -eq 0 ]
