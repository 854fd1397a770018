#!/bin/sh
# Runs a program made of a .pf file and expects that exactly the tests whose name ends in _fails do fail, that it says so in
# its totals and by its exit status.
#
#   expect_failures.sh PROGRAM FILE.pf
set -u
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$1" --verbose >"$scratch/output" 2>&1
status=$?

# What must fail, by the file; a parameterised test counts once.
sed -n 's/^ *subroutine \([a-z_]*_fails\).*/\1/p' "$2" | sort >"$scratch/expected"
# What did: `FAIL  suite.name[parameters]` here, a name under ` in:` from pFUnit.
sed -n -e 's/^FAIL  [a-z_]*\.\([a-z_]*\).*/\1/p' -e 's/^ *\(in: *\)\{0,1\}[a-z_]*_suite\.\([a-z_]*\).*/\2/p' \
   "$scratch/output" | sort -u >"$scratch/failed"
complain() { echo "$1"; sed 's/^/> /' "$scratch/output"; exit 1; }

[ -s "$scratch/expected" ] || complain "$2 names no test that must fail"
diff "$scratch/expected" "$scratch/failed" || complain 'other tests failed than must (< must, > did)'
[ "$status" -eq 2 ] || complain "exit status $status, not 2"
grep -q -E 'not reached' "$scratch/output" && complain 'a test went on after its first failure'
if grep -q '^FAIL  ' "$scratch/output"; then
   lines=$(grep -c '^FAIL  ' "$scratch/output")
   last=$(tail -n 1 "$scratch/output")
   case $last in
      *" passed, $lines failed" | *" passed, $lines failed, "*" skipped") ;;
      *) complain "the last line is no honest total: $last" ;;
   esac
fi
echo "$(wc -l <"$scratch/failed") tests fail as they must"
