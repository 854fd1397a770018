# The calculator: one answer a line, its form, its errors, its exit status. What the answers are worth is tested elsewhere.
. "$2/test/driver/expect.sh"

# K(1/2) = Gamma(1/4)^2 / (4 sqrt(pi)) = 1.85407467730137191843385034719526004621759882352...
run eval K 0.5
expect_status 0
expect_out 1.8540746773013719e+00
run eval --kind single K 0.5
expect_out 1.8540747e+00
if has_quad; then
   run eval --kind=quad K 0.5
   expect_out 1.85407467730137191843385034719526e+00
   run eval --kind quad K -1e400
   expect_status 0
else
   fails 2 'option --kind: this build has no quadruple precision' eval --kind=quad K 0.5
fi
run eval 'K 0.5'
expect_out 1.8540746773013719e+00
run eval K -- -1e300
expect_status 0
run eval K -1
expect_out 1.3110287771460598e+00
run eval K 1
expect_out Infinity
run eval E 1
expect_out 1e+00
run eval K 0.5d0
expect_status 0

fails 1 "error: unknown name 'k'" eval k 0.5
fails 1 'error: K: needs the arguments m, got 0 of 1' eval K
fails 1 'error: K: needs the arguments m, got 2 of 1' eval K 0 0
fails 1 'error: K: outside the domain (m <= 1), got 2.0' eval K 2.0
fails 1 "error: K: argument 1: '0x1p3': not a number" eval K 0x1p3
fails 1 "error: K: argument 1: '1,5': not a number" eval K 1,5
fails 1 "error: K: argument 1: 'nan': not a number" eval K nan
fails 1 'error: K: outside the domain (m <= 1), got inf' eval K inf
run eval K -INF
expect_out 0e+00
fails 1 "error: K: argument 1: '1e400': too large for the double kind" eval K 1e400
fails 1 "error: K: argument 1: '-1e40': too large for the single kind" eval --kind single K -1e40
run eval K 1e-400
expect_status 0

# Set-ups say what is wrong.
fails 1 'error: orbit: turning heights: ' eval orbit 1 1 -0.5 0.5
fails 1 'error: turning_top: energy and momentum: the momentum is too large' eval turning_top 1 1 2e-5 -1e200
fails 1 'error: turning: energy and momentum: the energy is below' eval turning 1 1 -2 0
fails 1 'error: cubic: the coefficients must not all be zero' eval cubic 0 0 0 0
fails 1 'error: passage_height: outside the domain (z2 <= z <= z1), got ' eval passage_height 1 1 0 -1 0.5
fails 1 'error: theta: outside the domain (i = 1, 2, 3 or 4' eval theta 2.5 0 0.5
fails 1 'error: rf: outside the domain (x, y, z >= 0), got -1 2 3' eval rf -1 2 3
fails 1 'error: jacobi: overflow' eval jacobi 1e200 -1e250
fails 1 'error: zetac: overflow' eval zetac 1e200 1e250
fails 1 'error: el3: overflow, x**2 or kc**2 leaves the range' eval el3 -3e140 -2.7e173 1.7e-300
# (A build in which overflow traps ends here, as it should.)
case $("$program" eval orbit 1e300 1e-300 0 -0.1 2>&1) in
   *SIGFPE*) ;;
   *) fails 1 'error: orbit: overflow, a constant of the motion' eval orbit 1e300 1e-300 0 -0.1 ;;
esac
fails 1 'error: position: overflow, the kind cannot tell the phase' eval position 1 9.8 0 -0.5 1e40
fails 1 'error: azimuth: overflow, the kind cannot tell the phase' eval azimuth 1 9.8 0 -0.5 1e40
fails 1 'error: azimuth: outside the domain (a bob at rest' eval azimuth 1 9.8 -1 -1 1e40
fails 1 'error: passage_azimuth: outside the domain' eval passage_azimuth 1 9.8 0 -0.5 -1
fails 1 'error: zeta: outside the domain (m <= 1), got' eval zeta 1 2
# Infinities, and words that look like options behind the name.
run eval rf Infinity 1 2
expect_out '0e+00'
run eval K -Infinity
expect_out '0e+00'
run eval nome -Infinity
expect_out '-1e+00'
run eval el1 -Infinity 0
expect_out -Infinity
fails 1 "error: K: argument 1: '-x': not a number" eval K -x
fails 1 "error: cubic: the coefficients must not all be zero, and be finite" eval cubic 1 Infinity 0 1
# --modulus: k for m, k' for mc; next to 1 by 1 - m = (1 - k)(1 + k).
run eval --modulus K 0.5
mv out by_modulus
run eval K 0.25
cmp -s out by_modulus || complain 'eval --modulus K 0.5 is not eval K 0.25'
run eval --modulus Kc 0.5
expect_out 2.1565156474996434e+00
run eval --modulus Pi 0.5 0.9999999999999999
mv out by_modulus
run eval Pic 0.5 2.220446049250313e-16
cmp -s out by_modulus || complain 'eval --modulus Pi next to k = 1 loses digits'
# A release gives the constants of its orbit.
run eval orbit_release 1 1 90 0
mv out released
run eval orbit 1 1 0 -1
cmp -s out released || complain 'eval orbit_release 1 1 90 0 is not eval orbit 1 1 0 -1'
run eval orbit 1 1 0 0
expect_status 1

# Exactly one answer a line: bad lines, empty lines, carriage returns, no last line end.
printf 'K 1\n\nnonsense\nK x\n  E\t1  \r\nK 1' >in
run eval
expect_status 1
checks=$((checks + 1))
[ "$(wc -l <out)" -eq 6 ] || complain '6 answers expected'
[ "$(grep -c '^error: ' out)" -eq 3 ] || complain '3 errors expected'
[ "$(sed -n 5p out)" = 1e+00 ] || complain 'line 5 must be 1e+00'
[ "$(sed -n 6p out)" = Infinity ] || complain 'line 6 must be Infinity'
[ ! -s err ] || complain 'nothing on standard error expected'
: >in
run eval
expect_status 0
[ ! -s out ] || complain 'no requests, no answers'
printf 'K 0\nE 0\n' >in
run eval
expect_status 0
head -c 300000 /dev/zero | tr '\0' '1' >in
run eval
expect_status 1
checks=$((checks + 1))
[ "$(wc -l <out)" -eq 1 ] || complain 'one answer to one long line expected'

# Every request of --list takes as many arguments as it says, and is known.
run eval --list
expect_status 0
cut -d ' ' -f 1 out >names
while read -r name; do
   run eval "$name" 1 2 3 4 5 6 7 8 9 10 11
   checks=$((checks + 1))
   grep -q "error: $name: needs the arguments .*, got 11 of" err || complain "$name is listed but not known"
done <names
checks=$((checks + 1))
[ "$(sort names | uniq -d | wc -l)" -eq 0 ] || complain 'a name is listed twice'

# A partner that waits for each answer before the next request gets it.
rm -f to from
mkfifo to from
"$program" eval <to >from &
exec 3>to 4<from
echo 'K 1' >&3
read -r answer <&4
echo 'E 1' >&3
read -r second <&4
exec 3>&- 4<&-
wait
command_line='kyvadlo eval, with a waiting partner'
checks=$((checks + 1))
[ "$answer $second" = 'Infinity 1e+00' ] || complain "answers $answer $second"

# A closed pipe ends quietly, a full disk does not.
yes 'K 0.5' | head -n 100000 >in
command_line='kyvadlo eval | head'
"$program" eval <in 2>err | head -n 1 >out
checks=$((checks + 1))
[ ! -s err ] || complain 'a closed pipe must end quietly'
if [ -e /dev/full ]; then
   "$program" eval <in >/dev/full 2>err
   status=$?
   command_line='kyvadlo eval >/dev/full'
   expect_status 2
   grep -q 'cannot write to standard output: ' err || complain 'a full disk must be reported'
fi

finish
