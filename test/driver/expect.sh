# Sourced by the tests of the program. $1 is the program, $2 the top of the sources; the work is done in a scratch folder.
set -u
program=$1
top=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
failures=0
checks=0

# Whether the build has quadruple precision: CMake says so.
has_quad() { [ -z "${KYVADLO_NO_REAL128-}" ]; }
kinds='single double'
! has_quad || kinds="$kinds quad"

# run ARGUMENT...: runs the program, input from ./in if there is one; leaves ./out, ./err and $status.
run() {
   command_line="kyvadlo $*"
   [ -f in ] || : >in
   "$program" "$@" <in >out 2>err
   status=$?
}

complain() {
   failures=$((failures + 1))
   printf 'FAILED: %s: %s\n' "$command_line" "$1"
   printf -- '--- out\n'; head -n 5 out; printf -- '--- err\n'; head -n 5 err
}

expect_status() {
   checks=$((checks + 1))
   [ "$status" -eq "$1" ] || complain "exit status $status, expected $1"
}

# The whole standard output.
expect_out() {
   checks=$((checks + 1))
   printf '%s\n' "$1" >expected
   cmp -s out expected || complain "expected the output: $1"
}

# A line of standard output that contains the text.
expect_in_out() {
   checks=$((checks + 1))
   grep -q -F -e "$1" out || complain "expected in the output: $1"
}

# A line of standard output that matches the basic regular expression.
expect_match() {
   checks=$((checks + 1))
   grep -q -e "$1" out || complain "expected in the output: $1"
}

# fails STATUS TEXT ARGUMENT...: the program ends with STATUS, one line on standard error that contains TEXT, no output.
fails() {
   expected_status=$1
   text=$2
   shift 2
   run "$@"
   expect_status "$expected_status"
   checks=$((checks + 1))
   [ "$(wc -l <err)" -eq 1 ] || complain "one line on standard error expected"
   grep -q -F -e "$text" err || complain "expected on standard error: $text"
   [ ! -s out ] || complain "no output expected"
}

finish() {
   [ "$failures" -eq 0 ] || { echo "$failures of $checks checks failed"; exit 1; }
   echo "$checks checks passed"
}
