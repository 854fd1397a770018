# Simulated scenes: columns, defaults, effects, files, messages. What the numbers are worth is tested in test/unit; here a few
# known values show that the right one stands in the right place.
. "$2/test/driver/expect.sh"

# A quarter circle in a plane with l = g = 1: 4 K(1/2) = 7.4162987092054877 is the period.
cat >plane.nml <<'END'
&pendulum name='quarter circle', length=1, gravity=1, release_angle=90, release_speed=0 /
&output samples=5 /
END
run simulate plane.nml
expect_status 0
expect_in_out 't,x,y,z,vx,vy,vz'
expect_match '^7.41629870920548[0-9]*e+00,'
checks=$((checks + 1))
[ "$(wc -l <out)" -eq 6 ] || complain 'a head and five samples expected'
checks=$((checks + 1))
[ ! -s err ] || complain 'nothing on standard error expected'
cp plane.nml in
run simulate -
expect_status 0
expect_match '^7.41629870920548[0-9]*e+00,'
: >in

# Times are parts of the decimal that was typed.
cat >sevenths.nml <<'END'
&pendulum length=1, release_angle=90, release_speed=0 /
&output duration=0.7, samples=8 /
END
run simulate sevenths.nml
checks=$((checks + 1))
cut -d , -f 1 out | tr '\n' ' ' >ticks
[ "$(cat ticks)" = 't 0e+00 1e-01 2e-01 3e-01 4e-01 5e-01 6e-01 7e-01 ' ] || complain "tenths expected: $(cat ticks)"

# Columns as asked, in that order; what does not exist is empty.
cat >rest.nml <<'END'
&pendulum length=2, gravity=5, release_angle=0, release_speed=0 /
&output duration=1, samples=3, quantities='tension, azimuth position' /
END
run simulate rest.nml
expect_out 't,tension,azimuth,x,y,z
0e+00,5e+00,,0e+00,0e+00,-2e+00
5e-01,5e+00,,0e+00,0e+00,-2e+00
1e+00,5e+00,,0e+00,0e+00,-2e+00'

# The cone: omega^2 = g/(-z) = 4; after a quarter turn x is y. From a frame that turns along it stands still.
cat >cone.nml <<'END'
&pendulum length=1, gravity=2, z_upper=-0.5, z_lower=-0.5 /
&output duration=10, samples=11, quantities='position azimuth energy' /
END
run simulate cone.nml
expect_match '^1e+00,-3.60[0-9]*e-01,7.87[0-9]*e-01,-5e-01,2e+00,5e-01$'
echo '&turning_frame rate=2 /' >>cone.nml
run simulate cone.nml
expect_match '^1e+00,8.660254037844[0-9]*e-01,[^,]*e-1[5-9],-5e-01,[^,]*,5e-01$'

# A string released at rest above the pivot falls by 2 z0 in sqrt(4 z0/g) and is caught at -z0.
cat >string.nml <<'END'
&pendulum length=1, gravity=2, position=0.6,0,0.8, velocity=3*0 /
&string /
&output duration=2, samples=21, quantities='position tension' /
END
run simulate string.nml
expect_status 0
expect_match '^# taut: t = 1.26491106406735[0-9]* *e*+*00* s, x = 6e-01 m, y = 0e+00 m, z = -8e-01 m, energy lost = 2.04[0-9e+]* m2/s2$'
expect_match '^1e-01,6e-01,0e+00,7.9e-01,0e+00$'
run simulate string.nml --events events.csv
expect_status 0
checks=$((checks + 1))
! grep -q '#' out || complain 'no comment expected beside --events'
checks=$((checks + 1))
[ "$(head -n 1 events.csv)" = t,event,x,y,z,energy_lost ] || complain 'a head expected in events.csv'
checks=$((checks + 1))
grep -q '^1.26491106406735[0-9]*e+00,taut,6e-01,0e+00,-8e-01,2.04' events.csv || complain 'the re-tension expected in events.csv'

# In a fluid of half the density gravity is halved.
cat >fluid.nml <<'END'
&pendulum length=1, gravity=2, release_angle=90, release_speed=0 /
&buoyancy density_ratio=0.5 /
END
run simulate fluid.nml
expect_match '^7.41629870920548[0-9]*e+00,'

# The same samples, whatever the number of threads.
cat >long.nml <<'END'
&pendulum length=1, z_upper=0.3, z_lower=-0.8 /
&output duration=1000, samples=100000 /
END
run simulate long.nml
mv out one
run simulate long.nml --threads 4 --output four
checks=$((checks + 1))
cmp -s one four || complain 'the number of threads must not matter'
checks=$((checks + 1))
[ "$(wc -l <four)" -eq 100001 ] || complain '100001 lines expected'

# To an accuracy: places within it of those with all digits, and a word about how. Quadruple precision takes its time, and the
# numbers as they are typed, from which the doubles of the other runs are off by up to 1e-16 (1e-12 after 1000 s).
sed 's/samples=100000/samples=200/' long.nml >short.nml
run simulate short.nml
mv out fine
finest=1.0e-29
! has_quad || finest=1.2e-32
for accuracy in 1e-3 1e-6 1e-10 1e-25; do
   run simulate short.nml --accuracy $accuracy --output coarse --explain
   expect_status 0
   checks=$((checks + 1))
   grep -q '^path: .*(real\|^path: .*(double-double' err || complain 'the kind expected'
   checks=$((checks + 1))
   paste -d , fine coarse | awk -F, -v a=$accuracy 'NR > 1 { d = ($2 - $9)^2 + ($3 - $10)^2 + ($4 - $11)^2
      if (!(d <= a*a + 1e-24)) { print d; exit 1 } }' >out || complain "places off by more than $accuracy"
done
fails 2 "option --accuracy must be at least $finest for a scene in closed form" simulate plane.nml --accuracy 1e-40

# Every scene that is shipped for it. Some need an integrator; a build without one says so.
if "$program" --version | grep -q GSL; then with_gsl=yes; else with_gsl=no; fi
for scene in "$top"/examples/scenes/*.nml; do
   grep -q '^&output' "$scene" || continue
   run simulate "$scene" --explain
   if [ $with_gsl = no ] && grep -q 'no integrator' err; then continue; fi
   expect_status 0
   checks=$((checks + 1))
   ! grep -i -q nan out || complain 'no NaN may show'
   checks=$((checks + 1))
   grep -q '^cost: .* ns a sample' err || complain 'a cost expected'
   cp out "$(basename "$scene" .nml).csv"
done

# holds WHAT FILE AWK: the script must print nothing.
holds() {
   checks=$((checks + 1))
   command_line="$2"
   awk -F, "$3" "$2" >out 2>err
   [ ! -s out ] && [ ! -s err ] || complain "$1"
}

# The string: energy changes at events only, and by what they say; without tension no swing.
holds 'energy is what the events leave' slack_string.csv '
   /^#/ { sub(/.*energy lost = /, ""); sub(/ .*/, ""); lost += $0; next }
   $1 == "t" { next }
   !start { start = $8 }
   { d = start - lost - $8; if (!(d*d < 1e-24) || !($9 >= 0)) print }
   END { if (!(lost > 1)) print "no loss" }'

if [ $with_gsl = yes ]; then
   # Foucault: the major axis turns by -rate sin(latitude), against the sun. Its direction from second moments of the last
   # 20 minutes, 73 swings; their ripple is below 1/73/2. Airy: 3/8 omega a b/l^2 counter-clockwise (his term of higher order:
   # (a/l)^2 of it, 0.2 %).
   axis='
      NR > 1 { x = $2; y = $3; if ($1 > 20400) { xx += x*x; xy += x*y; yy += y*y; t += $1; n++ } }
      END {
         pi = atan2(0, -1); omega = sqrt(9.80665/67); a = 67*sin(2.5663*pi/180)
         rate = -7.292115e-5*sin(48.85*pi/180)
         b = (v - rate*a)/omega
         expected = (rate + 3/8*omega*a*b/67^2)*t/n
         d = atan2(2*xy, xx - yy)/2 - expected
         d -= pi*int(d/pi + (d < 0 ? -0.5 : 0.5))
         if (!(d*d < limit^2)) print "axis off by", d, "of", expected
      }'
   holds 'Foucault precession' foucault_six_hours.csv "BEGIN { limit = 2e-3; v = 0 } $axis"
   holds 'Airy precession' foucault_ellipse.csv "BEGIN { limit = 4e-3; v = 0.05 } $axis"
   # 1e-8 of the energy of the swing, 0.66 m2/s2, over 1300 swings.
   holds 'Coriolis does no work' foucault_six_hours.csv '
      NR == 2 { start = $5 } NR > 1 { d = $5 - start; if (!(d*d < 4.4e-17)) print }'
   # What drag takes is missing, to 1e-9 of g l.
   holds 'energy balance' laboratory_air.csv '
      NR == 2 { start = $8 } NR > 1 { d = $8 - $9 - start; if (!(d*d < 1e-16)) print } NR > 2 && !($9 < 0) { print }'
   holds 'energy balance of the crane' crane.csv '
      NR == 2 { start = $5 } NR > 1 { d = $5 - $6 - $7 - start; if (!(d*d < 1e-14)) print }
      END { if (!($2 > 5 && $2 < 15 && $7 > 1)) print "the trolley has not moved" }'
   # To 1e-11 of g l.
   holds 'energy balance of the hoisted load' hoisting_crane.csv '
      NR == 2 { start = $5 } NR > 1 { d = $5 - $6 - start; if (!(d*d < 1.4e-18)) print }
      END { if (!($6 > 50)) print "the winch has not lifted" }'
   # dL/dt = -linear L about the vertical, whatever the swing.
   holds 'momentum decays exponentially' conical_drag.csv '
      NR == 2 { start = $5 } NR > 1 { d = $5 - start*exp(-0.05*$1); if (!(d*d < 1e-20)) print }
      NR == 2 { if (!($8 > 1.04)) print } END { if (!($8 < 0.3)) print "not sunk" }'
   # Two pendulums of l + extra along x and of l along y: after half a beat of their frequencies the line lies across.
   holds 'the line turns across' anisotropic.csv '
      NR == 2 { pi = atan2(0, -1); beat = pi/(sqrt(9.80665/2) - sqrt(9.80665/2.02)) }
      # Five swings each; by the beat the two have parted by 0.06 radians at the ends of the window.
      NR > 1 && $1 < 14.2 { early += $2*$3; n++ }
      NR > 1 && $1 > beat - 7.1 && $1 < beat + 7.1 { late += $2*$3; m++ }
      END { r = -late*n/(early*m); if (!(m > 280 && r > 0.99 && r < 1.01)) print "ratio", r }'

   # Every effect alone reaches the bob; with all coefficients zero the closed form answers.
   for effect in '&air linear=0.1' '&air quadratic=0.1' '&air diameter=0.1 mass=0.1' '&earth_rotation latitude=90 rate=0.1' \
      '&moving_pivot amplitude=0.1,0,0 frequency=3*0.5' '&elastic stiffness=1000 mass=1' \
      '&anisotropic_support extra_length_y=0.1' '&hoist rate=0.1' '&air linear=0.1 / &wind velocity=3,0,0'; do
      printf '%s\n' '&pendulum length=1, z_upper=-0.2, z_lower=-0.8 / &output duration=3, samples=4 /' >still.nml
      run simulate still.nml
      mv out still
      { cat still.nml; echo "$effect /"; } >effect.nml
      run simulate effect.nml --explain
      expect_status 0
      checks=$((checks + 1))
      grep -q '^because:  &[a-z_, &]*: no closed form$' err || complain 'integration expected'
      checks=$((checks + 1))
      [ "$(tail -n 1 out)" != "$(tail -n 1 still)" ] || complain 'the effect must show'
   done
   printf '%s\n' '&pendulum length=1, z_upper=-0.2, z_lower=-0.8 / &output duration=3, samples=4 /' \
      '&air linear=0 / &wind velocity=1,2,3 / &anisotropic_support extra_length_x=0 / &hoist rate=0 /' >zero.nml
   run simulate zero.nml --explain --check
   checks=$((checks + 1))
   cmp -s out still || complain 'coefficients of zero are the closed form'
   checks=$((checks + 1))
   grep -q 'nothing there that acts' err && grep -q '^check: nothing was integrated' err || complain 'the reason expected'

   # The accuracy, and the check that it is reached.
   printf '%s\n' '&pendulum length=1, z_upper=-0.2, z_lower=-0.8 / &output duration=30, samples=31 /&air linear=0.1 /' >air.nml
   run simulate air.nml --accuracy 1e-6 --check
   expect_status 0
   checks=$((checks + 1))
   grep -q '^check: at a tenth of the accuracy, 1.0e-07, places differ by [1-9].*e-0[4-7] m at most' err || complain 'a check expected'
   fails 2 'accuracy must be at least 1e-14 beside --check' simulate air.nml --accuracy 2e-15 --check

   # What the end of a long conservative scene is worth is told before it runs, to a factor of ten; of air nothing is said.
   for effect in '&earth_rotation latitude=45' '&elastic stiffness=1000 mass=1' '&anisotropic_support extra_length_y=0.1'; do
      printf '%s\n' '&pendulum length=1, position=0.6,0,-0.8, velocity=0,1.5,0 / &output duration=400, samples=2 /' "$effect /" >long.nml
      run simulate long.nml --accuracy 1e-13
      tail -n 1 out >exactly
      run simulate long.nml --accuracy 1e-8 --explain
      expect_status 0
      checks=$((checks + 1))
      tail -n 1 out | cat - exactly err | awk -F '[, ]+' '
         NR == 1 { for (i = 2; i <= 4; i++) place[i] = $i }
         NR == 2 { for (i = 2; i <= 4; i++) square += ($i - place[i])^2 }
         /^error: / { told = $3 }
         END { exit !(told > 0 && sqrt(square) < 10*told && sqrt(square) > told/10) }' || complain "$effect: $(grep '^error' err)"
   done
   run simulate air.nml --explain
   checks=$((checks + 1))
   ! grep -q '^error: ' err || complain 'no error is told of a scene with air'
   fails 2 'accuracy must be at least 1e-15 for a scene that is integrated' simulate air.nml --accuracy 1e-16
   run simulate air.nml --accuracy 1e-14 --check
   expect_status 0
   run simulate air.nml --check
   checks=$((checks + 1))
   grep -q '^check: at a tenth of the accuracy, 1.0e-13, places differ by [1-9].*e-1[0-3] m at most' err || complain 'a check expected'

   # The pivot: a table, and the two frames.
   printf '0 0 0 0\n1,0.5,0,0\n2 1 0 0 # end\n\n' >pivot.txt
   printf '%s\n' '&pendulum length=1, release_angle=0, release_speed=0 / &output duration=2, samples=3 /' \
      "&moving_pivot table='pivot.txt' /" >pivot.nml
   run simulate pivot.nml
   expect_status 0
   # A straight table moves evenly: the bob keeps behind by the relative swing, which the other frame shows.
   cut -d , -f 2 out >x
   sed 's/pivot.txt./& relative=.true./' pivot.nml >relative.nml
   run simulate relative.nml
   checks=$((checks + 1))
   cut -d , -f 2 out | paste -d , x - | awk -F, 'NR > 1 { d = $1 - $2 - (NR - 2)*0.5; if (!(d*d < 1e-28)) exit 1 }' ||
      complain 'the frames must differ by the displacement'
   # Along straight lines: at rest, then a jerk aside. A bob that hangs is left behind at first.
   printf '0 0 0 0\n1 0 0 0\n3 4 0 0\n' >pivot.txt
   sed "s/pivot.txt./& between='linear'/" pivot.nml >lines.nml
   run simulate lines.nml
   expect_status 0
   checks=$((checks + 1))
   sed -n 3p out | awk -F, '{ exit !($1 == 1 && $2^2 < 1e-30 && $5^2 < 1e-30) }' || complain 'still hanging at rest'
   printf '0 0 0 0\n1 0.5 0\n' >pivot.txt
   fails 2 'pivot.txt:2: a line of the table has 4 numbers, t x y z, got 1 0.5 0' simulate pivot.nml
   printf '0 0 0 0\n1 0.5 0 a\n' >pivot.txt
   fails 2 'pivot.txt:2: a number is expected, got a (not a number)' simulate pivot.nml
   printf '0 0 0 0\n1 0.5 0 0\n1 1 0 0\n3 0 0 0\n' >pivot.txt
   fails 2 'pivot.txt:3: the times of the table must ascend, got 1e+00 after 1e+00' simulate pivot.nml
   printf '0 0 0 0\n' >pivot.txt
   fails 2 'pivot.txt: pivot table: at least 2 times are needed, got 1' simulate pivot.nml
   # As scene files and kyvadlo's own CSV: byte order mark, comments, a head, more columns, two rows; a step is told.
   printf '\357\273\277! comment\n# slack\nt,x,y,z,vx\n0,0,0,0,\n10,0.5,0,0,7\n' >pivot.txt
   run simulate pivot.nml
   expect_status 0
   expect_match '^0e+00,'
   printf '0 0 0 0\n1 0 0 0\n1.000001 1 0 0\n10 1 0 0\n' >pivot.txt
   run simulate pivot.nml
   expect_status 0
   checks=$((checks + 1))
   grep -q 'pivot.txt: a step: the pivot moves 1.00 m from t = 1e+00 to 1.000001e+00 s' err || complain 'a warning of the step expected'
   printf 'time x y z\n0 0 0 0\n9 0 0 0\n' >pivot.txt
   fails 2 'pivot.txt:1: a line of the table has 4 numbers, t x y z, or is a head t,x,y,z, got time x y z' simulate pivot.nml
   printf '0 0 0 0\n1 0.5 0 0\n1.5 1 0 0\n' >pivot.txt
   fails 2 'pivot.nml:2: &moving_pivot: the table must cover the duration, 0 to 2e+00 s; it goes from 0e+00 to 1.5e+00 s' simulate pivot.nml
   rm pivot.txt
   fails 2 'pivot.nml:2: &moving_pivot: cannot read pivot.txt: No such file or directory' simulate pivot.nml
   mkdir folder
   printf '0 0 0 0\n1 0.5 0 0\n3 1 0 0\n' >folder/pivot.txt
   cp pivot.nml folder
   run simulate folder/pivot.nml
   expect_status 0
fi

# Pictures: script and data always, the picture where there is gnuplot; names with quotation marks and blanks.
mkdir "it's a folder"
for picture in swing.svg "it's a folder/it's a swing.svg" cone.png; do
   case $picture in cone*) run simulate cone.nml --plot "$picture" ;; *) run simulate plane.nml --plot "$picture" ;; esac
   if command -v gnuplot >/dev/null 2>&1; then expect_status 0; else expect_status 2; fi
   stem=${picture%.*}
   checks=$((checks + 1))
   { [ "$(sed -n 2p "$stem.dat")" = t,x,y,z,slack ] && grep -q 'set multiplot' "$stem.gp"; } || complain 'data and script expected'
   if command -v gnuplot >/dev/null 2>&1; then
      checks=$((checks + 1))
      [ ! -s err ] || complain 'no complaint of gnuplot expected'
      checks=$((checks + 1))
      case $picture in
      *.svg) [ "$(grep -c '</svg>' "$picture")" -eq 1 ] || complain 'a whole picture expected' ;;
      *) [ "$(dd if="$picture" bs=1 skip=1 count=3 2>/dev/null)" = PNG ] || complain 'a picture expected' ;;
      esac
      rm "$picture"
      (cd "$(dirname "$picture")" && gnuplot "$(basename "$stem").gp" 2>"$scratch/err")
      checks=$((checks + 1))
      { [ -s "$picture" ] && [ ! -s err ]; } || complain 'the script must draw by itself'
   fi
done
# Numbers at an axis that are told apart, of a height that does not change but for micrometres too.
run simulate "$top/examples/scenes/extremes.nml" --pendulum 2 --plot small.svg
checks=$((checks + 1))
grep -q '^set xtics 1.00e-06; set ytics 1.00e-06$' small.gp && grep -q 'set format y "%.9g"' small.gp ||
   complain 'steps and figures of the axes'
# Asked for or not, places are drawn; of many samples some.
run simulate plane.nml --plot swing.svg
cp out all
printf '%s\n' '&pendulum length=1, z_upper=0.3, z_lower=-0.8 / &output duration=9, samples=50001, quantities="energy" /' >energy.nml
run simulate energy.nml --plot energy.svg
checks=$((checks + 1))
[ "$(head -n 1 out)" = t,energy ] || complain 'the columns are those asked for'
checks=$((checks + 1))
{ [ "$(wc -l <energy.dat)" -gt 5000 ] && [ "$(wc -l <energy.dat)" -le 10002 ]; } || complain 'up to 10000 points expected'
env PATH=/nowhere "$program" simulate plane.nml --plot bare.svg >out 2>err
status=$?
expect_status 2
checks=$((checks + 1))
{ [ -s bare.gp ] && [ -s bare.dat ] && [ ! -e bare.svg ] && grep -q 'no gnuplot' err; } || complain 'a script without gnuplot expected'
fails 2 "option --plot needs the name of a file that ends in .svg or .png, got 'swing.pdf'" simulate plane.nml --plot swing.pdf
fails 2 'cannot write nowhere/swing.dat' simulate plane.nml --plot nowhere/swing.svg

# One pendulum of several, by name or number.
printf '%s\n' "&pendulum name='wide' length=1, z_upper=0.3, z_lower=-0.8 / &pendulum name='low' length=2, z_upper=-1, z_lower=-1.8 /" >two.nml
run simulate two.nml --pendulum wide
expect_match '^0e+00,9.5393920141694[0-9]*e-01,'
for name in low 2; do
   run simulate two.nml --pendulum $name
   expect_match '^0e+00,1.7320508075688[0-9]*e+00,'
   run table two.nml --pendulum $name --data --format csv
   expect_match '^low,'
   checks=$((checks + 1))
   ! grep -q '^wide,' out || complain 'only the one asked for'
done
fails 2 "option --pendulum: none is named '3'" simulate two.nml --pendulum 3
fails 2 "option --pendulum: none is named 'x'" table two.nml --pendulum x
fails 2 'choose it by --pendulum' simulate two.nml
# Wrong use and wrong scenes.
fails 2 'simulate needs one scene file, or - for standard input' simulate
fails 2 'simulate needs one scene file' simulate plane.nml cone.nml
fails 2 'cannot read nowhere.nml: No such file or directory' simulate nowhere.nml
if "$program" simulate plane.nml --output plane.nc 2>/dev/null; then
   checks=$((checks + 1))
   [ -s plane.nc ] || complain 'plane.nc expected'
else
   fails 2 'cannot write plane.nc: this build has no NetCDF-Fortran' simulate plane.nml --output plane.nc
fi
fails 2 "option --accuracy must be a number above 0, at most 0.1, got '1'" simulate plane.nml --accuracy 1
fails 2 'option --output needs the name of a file' simulate plane.nml --output ''
fails 2 'option --events needs the name of a file' simulate plane.nml --events -
fails 2 "unknown option '--divisions'" simulate plane.nml --divisions 3
bad() {
   printf '%b' "&pendulum length=1 z_upper=0.3 z_lower=-0.8 /\n$2" >bad.nml
   fails 2 "$1" simulate bad.nml
}
bad 'bad.nml:2: unknown group &aire' '&aire /'
bad 'bad.nml:3: &air: unknown name cubic' '&air\ncubic=1/'
bad 'bad.nml:2: &air: linear must not be negative, got -1' '&air linear=-1/'
bad 'bad.nml:3: &air given twice, first on line 2' '&air linear=1/\n&air linear=1/'
bad 'bad.nml:3: &rod and &elastic exclude each other' '&elastic stiffness=1 mass=1/\n&rod/'
bad 'bad.nml:2: &output: unknown quantity colour' "&output quantities='colour'/"
bad "bad.nml:2: &output: duration must be a finite number, got '1e400'" '&output duration=1e400/'
bad 'bad.nml:2: a second &pendulum' '&pendulum length=1 z_upper=0 z_lower=-1/'
printf '&pendulum length=1\nz_upper=0.9 z_lower=0/' >bad.nml
fails 2 "bad.nml:2: &pendulum 'pendulum 1': " simulate bad.nml
printf '&output samples=3/' >bad.nml
fails 2 'bad.nml: no &pendulum group' simulate bad.nml
run table cone.nml
expect_status 0
expect_in_out 'Conical: a level circle'
checks=$((checks + 1))
[ "$(cat err)" = 'kyvadlo: cone.nml:3: &turning_frame is computed by kyvadlo simulate; a table is of the motion without it' ] ||
   complain 'a note about &turning_frame expected'

# Every row of the page's tables of names is that of the program.
run simulate --list
expect_status 0
expect_in_out '| name of `&elastic` | meaning | unit | default |'
checks=$((checks + 1))
grep -v '^$' out | grep -v -x -F -f "$top/doc/scene_format.md" >missing
[ ! -s missing ] || { cat missing; complain 'doc/scene_format.md lacks these rows'; }
run table plane.nml
expect_status 0

# Files appear whole or not at all, interrupted runs leave nothing.
run simulate plane.nml --output result.csv
cp result.csv before.csv
fails 2 'cannot write nowhere/result.csv' simulate plane.nml --output nowhere/result.csv
fails 2 'cannot write nowhere/events.csv' simulate plane.nml --output result.csv --events nowhere/events.csv
cmp -s result.csv before.csv || complain 'a failed run must leave the old file'
if [ -e /dev/full ]; then
   fails 2 'cannot write /dev/full: ' simulate plane.nml --output /dev/full
fi
cat >endless.nml <<'END'
&pendulum length=1, z_upper=0.3, z_lower=-0.8 /
&output duration=1e6, samples=100000000 /
END
# (Started by & in a script INT and QUIT are to be ignored: those are sent by test/attacks.)
for signal in TERM HUP USR1 XCPU; do
   command_line="kyvadlo simulate endless.nml --output result.csv, then signal $signal"
   "$program" simulate endless.nml --output result.csv --events events.csv >out 2>err &
   pid=$!
   i=0
   while ! ls -A | grep -q '[.]part$' && [ "$i" -lt 50 ]; do i=$((i + 1)); sleep 0.1; done
   sleep 0.2
   kill -$signal "$pid"
   wait "$pid" 2>/dev/null
   status=$?
   checks=$((checks + 1))
   [ "$status" -gt 128 ] || complain "ended by the signal expected, got status $status"
   checks=$((checks + 1))
   ! ls -A | grep '[.]part$' || complain 'no unfinished file may stay'
   checks=$((checks + 1))
   cmp -s result.csv before.csv || complain 'an interrupted run must leave the old file'
done
command_line='kyvadlo simulate endless.nml --explain'
"$program" simulate endless.nml --explain >/dev/null 2>err &
pid=$!
i=0
while ! grep -q '^output: ' err && [ "$i" -lt 50 ]; do i=$((i + 1)); sleep 0.1; done
checks=$((checks + 1))
{ kill -0 "$pid" && grep -q '^output: ' err; } || complain 'what is explained must be said before the run'
kill "$pid"
wait "$pid" 2>/dev/null
command_line='kyvadlo simulate endless.nml | head'
"$program" simulate endless.nml 2>err | head -n 2 >out
checks=$((checks + 1))
[ ! -s err ] || complain 'a closed pipe must end quietly'

finish
