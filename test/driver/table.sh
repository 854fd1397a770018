# Tables: layouts, options, scenes, grids, errors, files. What the numbers are worth is tested elsewhere; here a few known
# values show that the right one stands in the right place.
. "$2/test/driver/expect.sh"

# The plane pendulum from 90 degrees: T = 2 K(1/2) sqrt(l/g); K(1/2) = 1.8540746773013719...
cat >plane.nml <<'END'
&pendulum name='quarter circle', length=1, gravity=1, release_angle=90, release_speed=0 /
END
run table plane.nml
expect_status 0
expect_match '^  period of the height  *T  *3.7081493546027 s$'
expect_in_out ' T/4  0.92703733865069  -0.41421356237310'
run table plane.nml --kind single
expect_match ' T  *3.70815 s$'
run table plane.nml --digits 5
expect_match ' T  *3.7081 s$'
# To an accuracy: kind and digits from it; 1e-20 needs quad, and 21 digits show it.
run table plane.nml --accuracy 1e-6
expect_status 0
expect_match ' T  *3.708149 s$'
run table plane.nml --accuracy 1e-13
expect_match ' T  *3.7081493546027 s$'
if has_quad; then
   run table plane.nml --kind quad
   expect_match ' T  *3.7081493546027438368677006943905 s$'
   run table plane.nml --accuracy=1e-20
   expect_match ' T  *3.70814935460274383687 s$'
   run table plane.nml --accuracy 2e-32 --format csv
   expect_match '^# T = 3.7081493546027438368677006943905 s$'
   finest=1.2e-32
else
   finest=3.6e-15
fi
run table --upper 0 --lower -1:-0.5:2 --accuracy 1e-3
expect_status 0
fails 2 'options --accuracy and --kind exclude each other' table --accuracy 1e-6 --kind single
fails 2 'options --accuracy and --digits exclude each other' table --accuracy 1e-6 --digits 3
fails 2 "option --accuracy must lie between $finest and 0.1, got '1e-33'" table --accuracy 1e-33
fails 2 "option --accuracy must lie between $finest and 0.1, got '6'" table --accuracy 6
fails 2 "option --accuracy must be a number, got 'high'" table --accuracy high

# A pendulum by options; of a swing to and fro the precession is shown. For small angles it is three eighths of the area of the
# ellipse over l**2 (Airy), here to the next order in the amplitudes.
run table --release-angle 90 --gravity 1
expect_status 0
expect_match '^  full swing, to and fro  *2T  *7.4162987092055 s$'
expect_match '^  precession in a full swing  *2 lambda.T  *0 degrees$'
run table --release-angle 1 --release-speed 0.01 --gravity 1
expect_match '^  precession in a full swing  *2 lambda.T  *0.0235[0-9]* degrees$'
run table --release-angle -30 --format csv --data
expect_in_out 'released at -30 degrees,plane libration,1e+00,9.80665e+00,'
fails 2 "option --release-angle must be a number, got 'x'" table --release-angle x
fails 2 'option --release-speed needs --release-angle A too' table --release-speed 1
fails 2 'options:1: &pendulum: release_angle must lie between -180 and 180 degrees, got 200' table --release-angle 200
fails 2 'options:1: &pendulum: length must be positive, got -1' table --release-angle 20 --length -1
fails 2 'give a grid (--upper, --lower) or a pendulum (--release-angle), not both' table --release-angle 3 --upper 0
fails 2 'options --length and --gravity apply to a grid or a pendulum' table --length 1

# A generic orbit: mpmath, 40 digits, T and phi by quadrature of (5) and (17), z and dz/dt by sn, cn, dn, phi(T/10) by
# quadrature over time: T 1.08679328201239380701917, phi(T) 5.36839090529474055772109; at T/10 z 0.222528826378629109216,
# dz/dt -1.41981592225872192515, phi 0.421567100964424602791, B 0.513046541152909194711, dphi/dt 3.77154137219434127288,
# v 3.95487564527483388382; z(T/4) -0.162379267585047245074.
cat >generic.nml <<'END'
&pendulum name='generic', length=1, z_upper=0.3, z_lower=-0.8 /
END
run table generic.nml
expect_match '^ *T/4 *0.27169832050310 *-0.16237926758505 *0.83762073241495 *1.1623792675850$'
expect_match '^ *T *1.0867932820124 *3.6655257739793 *6.2831853071796 *5.3683909052947 *307.58614164980$'
run table generic.nml --divisions 10
expect_match ' 0.10867932820124 *0.22252882637863 *1.2225288263786 *0.77747117362137 *0.36655257739793 *0.51304654115291 *0.42156710096442 '
expect_match ' 24.154015666827 *-1.4198159222587 *3.7715413721943 *3.9548756452748$'

# cos(120 degrees) is -1/2: z1 = 1/2, z3 = 1, so z(T/4) is 0.
cat >exact.nml <<'END'
&pendulum length=1, release_angle=120, release_speed=0 /
&pendulum length=3, release_angle=60, release_speed=0 /
END
run table exact.nml
expect_match '^ *T/4 *0.34432002425687 *0 *1.0000000000000 *1.0000000000000$'
run table exact.nml --data --format csv
expect_in_out ',3e+00,9.80665e+00,-1.5e+00,-3e+00,3e+00,4.5e+00,'

# The conical pendulum: omega^2 = g/(-z).
cat >conical.nml <<'END'
&pendulum name='cone', length=1, gravity=2, z_upper=-0.5, z_lower=-0.5 /
END
run table conical.nml --format csv
expect_status 0
expect_in_out '# P = 3.141592653589793e+00 s'
expect_in_out 'cone,5e-01,1.5707963267948966e+00,-5e-01,'
run table conical.nml --format csv --data
expect_status 0
expect_in_out "pendulum,motion,l,g,z1,z2,z3,l-z1,l+z2,z1-z2,k,k',K,q,T,A,c1,c2,phi(T),lambda*T"
expect_in_out 'cone,conical,1e+00,2e+00,-5e-01,-5e-01,1.25e+00,1.5e+00,5e-01,0e+00,0e+00,1e+00,'

# Both equilibria, the separatrix, rotation.
cat >special.nml <<'END'
&pendulum name='rest', length=1, release_angle=0, release_speed=0 /
&pendulum name='upright', length=1, release_angle=180, release_speed=0 /
&pendulum name='never', length=1, gravity=1, energy_above_top=0, momentum=0 /
&pendulum name='over', length=1, energy_above_top=1, momentum=0 /
END
run table special.nml
expect_status 0
expect_in_out 'At rest at the lowest point.'
expect_in_out 'At rest at the highest point, in unstable equilibrium: T = Infinity.'
expect_in_out 'never arrives at the top, T = Infinity.'
expect_in_out 'the bob runs over the top.'
checks=$((checks + 1))
! grep -i -q nan out || complain 'no NaN may show'
run table special.nml --divisions 3 --format csv
expect_status 0
expect_in_out 'rest,0e+00,0e+00,-1e+00,'
expect_in_out 'upright,0e+00,0e+00,1e+00,'
# z = -1 + 2 tanh(4)^2
expect_in_out 'never,1e+00,4e+00,9.97318'

# A negative momentum mirrors the motion.
cat >sense.nml <<'END'
&pendulum length=1, energy=3, momentum=3 /
&pendulum length=1, energy=3, momentum=-3 /
END
run table sense.nml --format csv --data
cut -d , -f 19 out >phi
checks=$((checks + 1))
[ "-$(sed -n 2p phi)" = "$(sed -n 3p phi)" ] || complain 'phi(T) must change its sign with the momentum'

# From a state at a lower turning point: the momentum is x vy - y vx.
cat >state.nml <<'END'
&pendulum length=1, gravity=1, position=0.6, 0, -0.8, velocity=3*0 /
&pendulum length=1, gravity=1, position=0.6, 0, -0.8, velocity(1)=0, velocity(2)=-2, velocity(3)=0 /
END
run table state.nml --format csv --data
expect_status 0
expect_in_out 'pendulum 1,plane libration,'
expect_in_out ',-1.2e+00,'

# Divisions: N + 1 rows, the same fields in each; t(N) = T, z(N) = z1.
run table conical.nml plane.nml --divisions 10 --format csv
expect_status 0
checks=$((checks + 1))
[ "$(grep -v '^#' out | wc -l)" -eq 23 ] || complain '1 + 2 * 11 rows expected'
[ "$(grep -v '^#' out | awk -F, '{ print NF }' | sort -u)" = 13 ] || complain '13 fields in every row expected'
run table --divisions 300
expect_status 0
run table --format markdown
expect_status 0
expect_in_out '## laboratory pendulum of 1 m, wide swing'
expect_in_out '|  t/T |'

# Without a scene: five pendulums; every option together with them.
run table
expect_status 0
checks=$((checks + 1))
[ "$(grep -c '^=' out)" -eq 5 ] || complain 'five built-in pendulums expected'
for kind in $kinds; do
   for format in text csv markdown; do
      run table --kind $kind --format $format --divisions 7
      expect_status 0
      checks=$((checks + 1))
      [ ! -s err ] || complain 'nothing on standard error expected'
      ! grep -i -q nan out || complain 'no NaN may show'
   done
done

# The examples, and a scene from standard input.
for scene in "$top"/examples/scenes/*.nml; do
   ! grep -q '^&output' "$scene" || continue   # for `simulate`
   run table "$scene"
   expect_status 0
done
cp plane.nml in
run table -
expect_status 0
expect_in_out 'quarter circle'
: >in

# Grids: every admissible pair, others left out; both ends exact.
run table --upper -0.9:0.9:19 --lower -1:0:11 --format csv
expect_status 0
expect_in_out '9e-01,-1e+00,'
checks=$((checks + 1))
awk -F, 'NR > 1 && !/^#/ && !($1 >= $2 && $1 + $2 < 0 && $3 > 0) { exit 1 }' out || complain 'a pair is not admissible'
expect_match '^# 100 of 209 pairs belong to no orbit: 0 off the sphere, 45 with z1 below z2, 55 with z1 + z2 not below 0$'
# The points are those of the decimals, in every kind: the cones are among them.
for kind in $kinds; do
   run table --upper -0.9:0.9:19 --lower -0.9:-0.1:9 --format csv --kind $kind
   checks=$((checks + 1))
   for z in 1 2 3 4 5 6 7 8 9; do grep -q "^-${z}e-01,-${z}e-01,[^,]*,0e+00," out || echo $z; done >missing
   [ ! -s missing ] || complain "cones expected in kind $kind"
   checks=$((checks + 1))
   cut -d , -f 1 out | sort -u | grep -v -c '^-*[0-9]e[-+]0[01]$' >count
   [ "$(cat count)" -eq 2 ] || complain "only a head, a comment and heights of one figure expected in kind $kind"
done
run table --upper -1.5:-0.1:3 --lower -0.8 --format csv
expect_match '^# 1 of 3 pairs belong to no orbit: 1 off the sphere, 0 with z1 below z2, 0 with z1 + z2 not below 0$'
run table --upper 0 --lower -1:-0.5:2 --length 2 --gravity 1 --kind single
expect_status 0
checks=$((checks + 1))
[ "$(wc -l <out)" -eq 3 ] || complain 'a head and two rows expected'
fails 2 'no pair of the grid belongs to an orbit' table --upper 0.5:0.9:3 --lower 0:0.4:3
fails 2 'a grid needs both --upper A:B:N and --lower A:B:N' table --upper 0:1:2
fails 2 'give scenes, a grid' table plane.nml --upper 0:1:2 --lower -1:0:2
fails 2 'options --data and --divisions do not apply to a grid' table --data --upper 0:1:2 --lower -1:0:2
fails 2 '--upper and --lower, or --release-angle, too' table --length 2
fails 2 "option --upper must be A:B:N, got '0:1' (A:B:N has two colons)" table --upper 0:1 --lower 0
fails 2 "option --upper must be A:B:N, got '0:x:3' (not a number)" table --upper 0:x:3 --lower 0
fails 2 "option --upper must be A:B:N, got '0:1:0' (N must be" table --upper 0:1:0 --lower 0
fails 2 "option --upper must be A:B:N, got '0:1:1' (N = 1 needs A = B)" table --upper 0:1:1 --lower 0
fails 2 "option --upper must be A:B:N, got '0:1:-3'" table --upper 0:1:-3 --lower 0
fails 2 'option --length must be positive, got -1' table --upper 0 --lower -1 --length -1
fails 2 "option --gravity must be a number, got 'earth'" table --upper 0 --lower -1 --gravity earth

# Wrong options.
fails 2 'option --divisions must be a whole number' table --divisions 0
fails 2 'option --divisions must be a whole number' table --divisions 2.5
fails 2 'option --digits must be a whole number, 1 to 100' table --digits 101
fails 2 'option --format must be one of text|csv|markdown' table --format xml
fails 2 'options --data and --divisions exclude each other' table --data --divisions 3
fails 2 'option --output needs the name of a file' table --output ''

# Wrong scenes: file, line, rule, value.
bad() {
   printf '%b' "$2" >bad.nml
   fails 2 "$1" table bad.nml
}
fails 2 'cannot read nowhere.nml: No such file or directory' table nowhere.nml
fails 2 'cannot read .: Is a directory' table .
fails 2 'cannot read nowhere.nml' table plane.nml nowhere.nml
bad 'bad.nml: the file is empty' ''
bad 'bad.nml: no &pendulum group' '! only a comment\n'
bad 'bad.nml:1: not a text file (byte 0)' '\0000\0001\0002'
bad 'bad.nml:2: unknown group &pendulm' '\n&pendulm /'
bad 'bad.nml:2: &pendulum: unknown name z_uper' '&pendulum\nz_uper = 1 /'
bad 'bad.nml:2: &pendulum: length given twice, first on line 1' '&pendulum length=1\nlength=1 /'
bad 'bad.nml:1: &pendulum: no start' '&pendulum length=1 /'
bad 'bad.nml:1: &pendulum: two starts: z_upper, z_lower and upper_gap, lower_rise' \
   '&pendulum length=1 z_upper=0 z_lower=-1 upper_gap=1 lower_rise=0/'
bad 'bad.nml:2: &pendulum: length must be positive, got -1' '&pendulum\nlength=-1 z_upper=0 z_lower=-1/'
bad "bad.nml:1: &pendulum: length must be a finite number, got 'Infinity'" '&pendulum length=Infinity z_upper=0 z_lower=-1/'
bad "bad.nml:1: &pendulum: z_upper must be a finite number, got '1e400' (too large for the double kind)" \
   '&pendulum length=1 z_upper=1e400 z_lower=-1/'
for start in 'z_upper=-0.5 z_lower=0' 'z_upper=0.5 z_lower=-0.5' 'z_upper=0 z_lower=-1.5' 'z_upper=1 z_lower=-1' \
   'upper_gap=1 lower_rise=1' 'upper_gap=-1 lower_rise=1' 'upper_rise=1 lower_rise=2' 'energy=-20 momentum=0' \
   'energy_above_bottom=-1 momentum=0' 'energy=0 momentum=1e6' 'position=0,0,-1.1 velocity=3*0' \
   'position=0.6,0,-0.8 velocity=-0.6,0,0.8' 'position=3*0 velocity=3*0'; do
   bad "bad.nml:2: &pendulum 'pendulum 1': " "&pendulum length=1\\n$start /"
done

# Files appear whole or not at all.
run table plane.nml --output result.txt
expect_status 0
checks=$((checks + 1))
grep -q 'quarter circle' result.txt || complain 'result.txt must hold the table'
cp result.txt before.txt
printf '&pendulum length=1 /' >bad2.nml
fails 2 'no start' table bad2.nml --output result.txt
cmp -s result.txt before.txt || complain 'a failed run must leave the old file'
fails 2 'cannot write nowhere/result.txt: No such file or directory' table plane.nml --output nowhere/result.txt
fails 2 'cannot write .: Is a directory' table plane.nml --output .
checks=$((checks + 1))
[ -z "$(ls | grep part)" ] || complain 'no unfinished file may stay'
ln -s result.txt link.txt
run table plane.nml --format csv --output link.txt
expect_status 0
checks=$((checks + 1))
{ [ -h link.txt ] && grep -q t_over_T result.txt; } || complain 'a link is written through'
if [ -e /dev/full ]; then
   fails 2 'cannot write /dev/full: ' table --output /dev/full
fi
command_line='kyvadlo table | head'
"$program" table --divisions 100000 2>err | head -n 1 >out
checks=$((checks + 1))
[ ! -s err ] || complain 'a closed pipe must end quietly'

finish
