#!/bin/sh
# Attacks on the program: what a hostile file, name, terminal, disk or signal can do. Prints a table and fails if anything
# crashed, hung, or was wrong or lost.
#
#   run.sh PROGRAM [FUZZER [INPUTS]] [--into PAGE]
#
# FUZZER is the program attacks_fuzz of the same build; INPUTS (default 20000) how many it makes of each kind. --into writes
# the table into a page, between the lines <!-- attacks --> and <!-- end of attacks -->.
set -u
LC_ALL=C.UTF-8
export LC_ALL
umask 022
here=$(cd "$(dirname "$0")" && pwd)
absolute() { case $1 in /*) echo "$1" ;; *) echo "$PWD/$1" ;; esac; }
program=$(absolute "$1")
shift
fuzzer='' inputs_of_fuzzer=20000 page=''
while [ $# -gt 0 ]; do
   case $1 in
   --into) page=$(absolute "$2"); shift ;;
   [0-9]*) inputs_of_fuzzer=$1 ;;
   *) fuzzer=$(absolute "$1") ;;
   esac
   shift
done
scratch=$(mktemp -d)
trap 'chmod -R u+w "$scratch" 2>/dev/null; rm -rf "$scratch"' EXIT
table=$scratch/table
total=0
: >"$table"
if "$program" --version | grep -q GSL; then with_gsl=yes; else with_gsl=no; fi
if command -v gnuplot >/dev/null; then with_gnuplot=yes; else with_gnuplot=no; fi

# attack NAME: ends the one before, begins another in a folder of its own.
name=''
attack() {
   if [ -n "$name" ]; then
      printf '| %s | %d | %d | %d | %d |\n' "$name" "$inputs" "$crashes" "$hangs" "$wrong" >>"$table"
      total=$((total + crashes + hangs + wrong))
   fi
   name=$1 inputs=0 crashes=0 hangs=0 wrong=0
   [ -n "$name" ] || return 0
   folder=$(mktemp -d "$scratch/XXXXXX")
   cd "$folder" || exit 1
   printf '%s\n' '&pendulum name="swing", length=1, z_upper=0.3, z_lower=-0.8 /' '&output duration=2, samples=5 /' >scene.nml
   printf '%s\n' '&pendulum length=1, z_upper=0.3, z_lower=-0.8 /' '&output duration=1e6, samples=100000000 /' >endless.nml
   : >empty
}

# count STATUS: an input more; a signal is a crash, the end of patience a hang.
count() {
   inputs=$((inputs + 1))
   status=$1
   case $status in
   124) hangs=$((hangs + 1)); echo "HANG: $name: $line" ;;
   13[0-9] | 14[0-9] | 15[0-9] | 16[0-9]) crashes=$((crashes + 1)); echo "CRASH ($status): $name: $line"; cat err ;;
   esac
}

# go ARGUMENT...: runs the program, input from ./in if there is one, for $patience seconds at most.
patience=20
go() {
   line=$*
   if [ -f in ]; then source=in; else source=/dev/null; fi
   timeout "$patience" "$program" "$@" <"$source" >out 2>err
   count $?
}

# want WHAT COMMAND...: the command must succeed.
want() {
   what=$1
   shift
   "$@" >/dev/null 2>&1 && return
   wrong=$((wrong + 1))
   echo "WRONG: $name: $what: $line (status $status)"
   head -c 300 err
}

# refused WORDS: status 2, and the words on standard error.
refused() {
   want "status 2" [ "$status" -eq 2 ]
   want "a message with '$1'" grep -q -F -e "$1" err
}

no_part() {
   ! find "$folder" -name '*.part*' | grep -q .
}

same() {
   cmp -s "$1" "$2"
}

for file in "$here"/attack_*.sh; do
   # shellcheck source=/dev/null
   . "$file"
done
if [ -n "$fuzzer" ]; then
   for kind in scene simulation table request options; do
      attack "random changes: $kind"
      line="$fuzzer $kind $inputs_of_fuzzer"
      timeout $((60 + inputs_of_fuzzer/20)) "$fuzzer" $kind "$inputs_of_fuzzer" >out 2>err
      count $?
      want 'the fuzzer must come to its end' [ "$status" -eq 0 ]
      inputs=$inputs_of_fuzzer
   done
fi
attack ''

{
   echo '| attack | inputs | crashes | hangs | wrong or lost |'
   echo '|---|--:|--:|--:|--:|'
   cat "$table"
} >"$scratch/page"
cat "$scratch/page"
if [ -n "$page" ]; then
   awk -v table="$scratch/page" '
      /^<!-- attacks -->$/ { print; print ""; while ((getline line < table) > 0) print line; print ""; skip = 1; next }
      /^<!-- end of attacks -->$/ { skip = 0 }
      !skip { print }' "$page" >"$scratch/new" && cat "$scratch/new" >"$page"
fi
[ "$total" -eq 0 ]
