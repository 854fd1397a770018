#!/bin/sh
# Runs the commands of the ```console blocks of a page and compares what they print with what the page shows.
#
#   commands.sh TOP FOLDER_OF_PROGRAMS PAGE
#
# In a block, a line `$ command` is run by sh in TOP, with FOLDER_OF_PROGRAMS first in PATH; the lines up to the next `$` or the
# end of the block are its output, standard error included. Commands that begin with ./bootstrap are left to CI.
set -u
cd "$1" || exit 1
PATH=$2:$PATH; export PATH
page=$3
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
   case $command in ./bootstrap*) continue ;; esac
   run=$((run + 1))
   sh -c "$command" >"$scratch/got" 2>&1 </dev/null
   if ! diff "$scratch/$i.expected" "$scratch/got" >"$scratch/difference"; then
      echo "$page:$(cat "$scratch/$i.line"): $command"
      cat "$scratch/difference"
      bad=$((bad + 1))
   fi
done
[ "$bad" -eq 0 ] || exit 1
echo "$page: $run commands print what it shows"
