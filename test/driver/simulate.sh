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
OMP_NUM_THREADS=1 run simulate long.nml
mv out one
OMP_NUM_THREADS=4 run simulate long.nml --output four
checks=$((checks + 1))
cmp -s one four || complain 'the number of threads must not matter'
checks=$((checks + 1))
[ "$(wc -l <four)" -eq 100001 ] || complain '100001 lines expected'

# Every scene that is shipped for it.
for scene in "$top"/examples/scenes/*.nml; do
   grep -q '^&output' "$scene" || continue
   run simulate "$scene"
   expect_status 0
   checks=$((checks + 1))
   ! grep -i -q nan out || complain 'no NaN may show'
done

# Wrong use and wrong scenes.
fails 2 'simulate needs one scene file, or - for standard input' simulate
fails 2 'simulate needs one scene file' simulate plane.nml cone.nml
fails 2 'cannot read nowhere.nml: No such file or directory' simulate nowhere.nml
fails 2 'option --output needs the name of a file' simulate plane.nml --output ''
fails 2 'option --events needs the name of a file' simulate plane.nml --events -
fails 2 "unknown option '--divisions'" simulate plane.nml --divisions 3
bad() {
   printf '%b' "&pendulum length=1 z_upper=0.3 z_lower=-0.8 /\n$2" >bad.nml
   fails 2 "$1" simulate bad.nml
}
bad 'bad.nml:2: unknown group &aire' '&aire /'
bad 'bad.nml:3: &air: unknown name cubic' '&air\ncubic=1/'
bad 'bad.nml:2: &air: linear must not be negative, got -1e+00' '&air linear=-1/'
bad 'bad.nml:3: &air given twice, first on line 2' '&air linear=1/\n&air linear=1/'
bad 'bad.nml:3: &rod and &elastic exclude each other' '&elastic stiffness=1 mass=1/\n&rod/'
bad 'bad.nml:2: &output: unknown quantity colour' "&output quantities='colour'/"
bad "bad.nml:2: &output: duration must be a finite number, got '1e400'" '&output duration=1e400/'
bad 'bad.nml:2: a second &pendulum' '&pendulum length=1 z_upper=0 z_lower=-1/'
printf '&pendulum length=1\nz_upper=0.9 z_lower=0/' >bad.nml
fails 2 "bad.nml:2: &pendulum 'pendulum 1': " simulate bad.nml
printf '&output samples=3/' >bad.nml
fails 2 'bad.nml: no &pendulum group' simulate bad.nml
fails 2 'cone.nml:3: &turning_frame is computed by kyvadlo simulate; here is the motion without it' table cone.nml
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
for signal in INT TERM HUP; do
   command_line="kyvadlo simulate endless.nml --output result.csv, then signal $signal"
   "$program" simulate endless.nml --output result.csv --events events.csv >out 2>err &
   pid=$!
   i=0
   while ! ls ./*part* >/dev/null 2>&1 && [ "$i" -lt 50 ]; do i=$((i + 1)); sleep 0.1; done
   sleep 0.2
   kill -$signal "$pid"
   wait "$pid" 2>/dev/null
   status=$?
   checks=$((checks + 1))
   [ "$status" -gt 128 ] || complain "ended by the signal expected, got status $status"
   checks=$((checks + 1))
   [ -z "$(ls | grep part)" ] || complain 'no unfinished file may stay'
   checks=$((checks + 1))
   cmp -s result.csv before.csv || complain 'an interrupted run must leave the old file'
done
command_line='kyvadlo simulate endless.nml | head'
"$program" simulate endless.nml 2>err | head -n 2 >out
checks=$((checks + 1))
[ ! -s err ] || complain 'a closed pipe must end quietly'

finish
