# Every name of eval against mpmath (eval_answers.txt by make_eval_answers.py), in every kind: the right function, its
# arguments and results in the right order. The last digits are the business of test/unit.
. "$2/test/driver/expect.sh"

answers=$top/test/driver/eval_answers.txt
grep -v '^#' "$answers" | cut -d = -f 1 >in
grep -v '^#' "$answers" | cut -d = -f 2 >expected
for kind in $kinds; do
   case $kind in
      single) bound=2e-6 ;;
      *) bound=4e-15 ;;
   esac
   run eval --kind $kind
   expect_status 0
   checks=$((checks + 1))
   [ "$(wc -l <out)" -eq "$(wc -l <in)" ] || complain 'one answer a request expected'
   paste -d = in out expected | awk -F= -v bound=$bound '
      {
         n = split($2, got, " "); m = split($3, want, " ")
         bad = n != m || m == 0
         for (i = 1; i <= m && !bad; i++) {
            off = got[i] - want[i]; if (off < 0) off = -off
            size = want[i] < 0 ? -want[i] : want[i]; if (size < 0.1) size = 0.1
            if (!(off <= bound*size)) bad = 1
         }
         if (bad) { print; failed = 1 }
      }
      END { exit failed }' >worse || { complain "not within $bound:"; cat worse; }
done

# No name is left out.
run eval --list
cut -d ' ' -f 1 out | sort >listed
cut -d ' ' -f 1 in | sort -u >asked
checks=$((checks + 1))
cmp -s listed asked || { complain 'these names have no reference, or are not listed:'; comm -3 listed asked; }

finish
