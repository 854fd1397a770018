# Where a pendulum may start: a spring anywhere at any velocity, a slack string anywhere inside its sphere, a suspension of two
# lengths on its own surface; what a string says of it, and integrations that would not come to an end.
. "$2/test/driver/expect.sh"

has_gsl() { "$program" --version | grep -q GSL; }

# holds WHAT AWK: the script must print nothing about ./out.
holds() {
   checks=$((checks + 1))
   awk -F, "$2" out >wrong 2>&1
   [ ! -s wrong ] || complain "$1: $(head -n 2 wrong)"
}

# A string from the pivot, thrown level: g = 2, l = 1, so t**2 + t**4 = 1 where it is taut. The start is its first event.
cat >inside.nml <<'END'
&pendulum length=1, gravity=2, position=0,0,0, velocity=1,0,0 /
&string /
&output duration=1, samples=11, quantities='position velocity azimuth' /
END
run simulate inside.nml
expect_status 0
expect_match '^# slack: t = 0e+00 s, x = 0e+00 m, y = 0e+00 m, z = 0e+00 m, energy lost = 0e+00 m2/s2$'
expect_match '^# taut: t = 7.861513777574[0-9]*e-01 s'
expect_match '^5e-01,5e-01,0e+00,-2.5e-01,1e+00,0e+00,-1e+00,0e+00$'
# Down the axis: no azimuth, caught at the bottom, at rest from then on.
sed 's/velocity=1,0,0/velocity=0,0,0/' inside.nml >axis.nml
run simulate axis.nml
expect_match '^# taut: t = [19][0-9.]*e[+-]0[01] s, x = 0e+00 m, y = 0e+00 m, z = -1e+00 m, energy lost = [12][0-9.]*e+00 m2/s2$'
expect_match '^5e-01,0e+00,0e+00,-2.5e-01,0e+00,0e+00,-1e+00,$'
# Next to the sphere: towards it or away from it the bob flies from where it is, at rest it counts as on it; to the thousandth.
for radial in '-0.9995 1 -9.995e-01' '-0.9999 -1 -9.999e-01' '-0.9995 0 -1e+00' '-0.999 0 -9.99e-01'; do
   # shellcheck disable=SC2086
   set -- "$1" "$2" $radial
   for air in '' '&air linear=0.1 /'; do
      has_gsl || [ -z "$air" ] || continue
      echo "&pendulum length=1, position=0,0,$3 velocity=0,0,$4 / &string / $air &output duration=1, samples=2, quantities='position' /" >next.nml
      run simulate next.nml
      expect_match "^0e+00,0e+00,0e+00,$5\$"
   done
done
if has_gsl; then
   echo "&pendulum length=1, position=0,0,-1.5 velocity=0,0,1 / &string / &air linear=0.1 / &output duration=1 /" >beyond.nml
   fails 2 'beyond.nml:1: &pendulum: the position must not lie outside what the string lets the bob reach, 1.000000 m, got' simulate beyond.nml
fi
# A swing whose squares leave the range would stand still for ever.
for start in 'position=1e-170,2e-170,-1 velocity=0,0,0' 'position=0,0,-1 velocity=1e-200,1e-200,0' 'release_angle=1e-160' \
   'release_angle=-1e-155' 'release_angle=180 release_speed=-1e-170'; do
   echo "&pendulum length=1 $start / &output duration=1, samples=2 /" >still.nml
   fails 2 'so close to rest that squares leave the range' simulate still.nml
done
echo "&pendulum length=1 release_angle=1e-130 / &output duration=1, samples=2, quantities='position' /" >small.nml
run simulate small.nml
expect_match '^1e+00,-1.745241365001[0-9]*e-132,0e+00,-1e+00$'
# From the sphere inwards; along a chord through the pivot without much time to fall.
cat >inwards.nml <<'END'
&pendulum length=1, gravity=1e-6, position=0.6,0,-0.8, velocity=-6,0,8 /
&string restitution=1 /
&output duration=0.3, samples=4 /
END
run simulate inwards.nml
expect_status 0
expect_match '^# rebound: t = 2.00000[0-9]*e-01 s, x = -[56][0-9.]*e-01 m, y = 0e+00 m, z = [78][0-9.]*e-01 m'
sed 's/position=0.6,0,-0.8/position=1.6,0,-0.8/' inwards.nml >outside.nml
fails 2 'outside.nml:1: &pendulum: the position must not lie outside' simulate outside.nml
sed 's/velocity=-6,0,8/velocity=6,0,-8/' inwards.nml >outwards.nml
fails 2 'radial speed' simulate outwards.nml
# No accuracy is promised from event to event.
fails 2 'slack.nml:2: &string: the string goes slack' simulate "$(cp inside.nml slack.nml; echo slack.nml)" --accuracy 1e-9
sed 's/position=0,0,0/position=0,0,-1/' inside.nml >taut.nml
run simulate taut.nml --accuracy 1e-9
expect_status 0

has_gsl || { finish; exit; }

# The same with as good as no air, integrated: the same events within 1e-9 sqrt(l/g), rebounds and the end of rattling included.
events() {
   run simulate "$1" --events "$2" --output /dev/null
   expect_status 0
}
for scene in 'inside.nml' 'inwards.nml' 'rattle.nml' 'rattle_in_fluid.nml'; do
   case $scene in
   rattle*) cat >$scene <<'END' ;;
&pendulum length=1, position=0.5649950979662323,0,0.8250942608418311, velocity=-2.320519621336121,0.4057838,1.5890090054095016 /
&string restitution=0.5 /
&output duration=1.5, samples=2 /
END
   esac
   # Half the gravity, half the square of the speed.
   [ $scene != rattle_in_fluid.nml ] || {
      sed -i 's/velocity=[-0-9.,]*/velocity=-1.6408550881,0.2869325,1.1236033176/' $scene
      echo '&buoyancy density_ratio=0.5 /' >>$scene
   }
   events $scene exact
   echo '&air linear=1e-30 /' >>$scene
   events $scene integrated
   checks=$((checks + 1))
   paste -d , exact integrated | awk -F, 'NR > 1 { d = $1 - $7; if ($2 != $8 || !(d*d < 9e-20)) { print NR, $1, $2, $7, $8; exit } }
      END { if (NR < 2) print "no event" }' >wrong
   [ ! -s wrong ] || complain "events of $scene differ: $(cat wrong)"
done

# A spring that hangs still hangs still; let go below that it swings harmonically about it, from above the same with speed.
# Mass 1, stiffness 100, gravity 10, length 1: at rest at -1.1, 10 rad/s.
cat >spring.nml <<'END'
&pendulum length=1, gravity=10, position=0,0,-1.1, velocity=3*0 /
&elastic stiffness=100, mass=1 /
&output duration=2, samples=41, quantities='position velocity tension' /
END
run simulate spring.nml
expect_status 0
holds 'hanging still' 'NR > 1 && !(($4 + 1.1)^2 + $7^2 < 1e-22 && $2 == 0 && ($8 - 10)^2 < 1e-20)'
sed 's/-1.1/-1.4/' spring.nml >stretched.nml
run simulate stretched.nml
holds 'stretched' 'NR > 1 && !(($4 + 1.1 + 0.3*cos(10*$1))^2 < 1e-20)'
sed 's/velocity=3\*0/velocity=0,0,2/' spring.nml >pushed.nml
run simulate pushed.nml
holds 'radial speed' 'NR > 1 && !(($4 + 1.1 - 0.2*sin(10*$1))^2 < 1e-20)'
sed 's/0,0,-1.1/0,0,0/' spring.nml >at_pivot.nml
fails 2 'at_pivot.nml:1: &pendulum: the start must not be at the pivot' simulate at_pivot.nml
# On a string it flies until its rest length.
echo '&string /' >>at_pivot.nml
run simulate at_pivot.nml
expect_match '^# slack: t = 0e+00 s'
expect_match '^# taut: t = 4.472135954999[0-9]*e-01 s'

# No event at a start at the rest length, whatever rounding makes of it: 30, 45, ... degrees.
for angle in 10 30 45 60 77; do
   cat >rest_length.nml <<END
&pendulum length=1, release_angle=$angle, release_speed=0 /
&string /
&elastic stiffness=1000, mass=1 /
&output duration=0.05, samples=3 /
END
   run simulate rest_length.nml
   expect_status 0
   checks=$((checks + 1))
   ! grep -q '#' out || complain "no event expected at $angle degrees"
done

# What an elastic string does where it becomes taut follows from its stiffness.
sed 's/&string/\&string restitution=0.5/' rest_length.nml >bouncing.nml
fails 2 'bouncing.nml:2: &string: restitution and &elastic exclude each other' simulate bouncing.nml

# P. Lynch's swinging spring in resonance (Int. J. Non-Linear Mech. 37 (2002) 345): mass 1 kg, 1 m at rest, gravity pi**2, stiffness
# 4 pi**2. Against the classical method of Runge and Kutta with steps of 1/4000 s, whose error is below 1e-11 here.
cat >lynch.nml <<'END'
&pendulum length=0.75, gravity=9.869604401089358, position=0.04,0,-0.92, velocity=0,0.03427,0 /
&elastic stiffness=39.47841760435743, mass=1 /
&output duration=20, samples=21 /
END
run simulate lynch.nml
expect_status 0
holds 'the swinging spring' '
   function rate(p, v, a,    r, pull, i) {
      r = sqrt(p[1]^2 + p[2]^2 + p[3]^2)
      pull = 39.47841760435743*(r - 0.75)/r
      for (i = 1; i <= 3; i++) a[i] = -pull*p[i]
      a[3] -= 9.869604401089358
   }
   function add(from, way, part, to,    i) { for (i = 1; i <= 3; i++) to[i] = from[i] + part*way[i] }
   function step(h,    i) {
      rate(p, v, a1)
      add(p, v, h/2, p2); add(v, a1, h/2, v2); rate(p2, v2, a2)
      add(p, v2, h/2, p3); add(v, a2, h/2, v3); rate(p3, v3, a3)
      add(p, v3, h, p4); add(v, a3, h, v4); rate(p4, v4, a4)
      for (i = 1; i <= 3; i++) {
         p[i] += h/6*(v[i] + 2*v2[i] + 2*v3[i] + v4[i])
         v[i] += h/6*(a1[i] + 2*a2[i] + 2*a3[i] + a4[i])
      }
   }
   NR == 1 { p[1] = 0.04; p[2] = 0; p[3] = -0.92; v[1] = 0; v[2] = 0.03427; v[3] = 0; next }
   NR > 2 { for (n = 0; n < 4000; n++) step(1/4000) }
   { d = ($2 - p[1])^2 + ($3 - p[2])^2 + ($4 - p[3])^2; if (!(d < 1e-20)) { print $0, p[1], p[2], p[3]; exit } }'

# A suspension of two lengths starts exactly where it is told.
cat >hinges.nml <<'END'
&pendulum length=1, position=1.5,0,0.5, velocity=3*0 /
&anisotropic_support extra_length_x=0.5 /
&output duration=1, samples=3, quantities='position' /
END
run simulate hinges.nml
expect_status 0
expect_match '^0e+00,1.5e+00,0e+00,5e-01$'
sed 's/1.5,0,0.5/1,0,0/' hinges.nml >off.nml
fails 2 'off.nml:1: &pendulum: the position must lie on the surface' simulate off.nml
expect_in_message() { checks=$((checks + 1)); grep -q -e "$1" err || complain "expected on standard error: $1"; }
expect_in_message '0.618034.* 1.000000'
sed 's/velocity=3\*0/velocity=1,0,0.1/' hinges.nml >away.nml
fails 2 'the radial speed must be' simulate away.nml

# Integrations that would not come to an end are refused at once, each with the line that asks for the most.
plain='&pendulum length=1, release_angle=30, release_speed=0 /'
endless() {
   printf '%s\n' "$2" >endless.nml
   fails 2 "endless.nml:$1" simulate endless.nml
}
endless '2: &elastic: the integration over 2.041 s would take about' "$plain
&elastic stiffness=1e12, mass=1 /"
# The bound is printed and can be moved.
sed 's/1e12/1e6/' endless.nml >stiff.nml
run simulate stiff.nml --explain
expect_status 0
expect_in_message '^steps:    about 1.0e+04 of at most 1.0e+07 (--most-steps)$'
run simulate stiff.nml --explain --most-steps 2e4
expect_status 0
expect_in_message '^steps:    about 1.0e+04 of at most 2.0e+04 (--most-steps)$'
fails 2 'stiff.nml:2: &elastic: the integration over 2.041 s would take about 1.0e+04 steps, more than 9.0e+03' \
   simulate stiff.nml --most-steps 9e3
fails 2 'option --most-steps must be a number above 0' simulate stiff.nml --most-steps 0
endless '1: &pendulum: the integration' '&pendulum length=1, release_angle=30, release_speed=1e9 /
&air linear=0.1 /
&output duration=10 /'
endless '1: &pendulum: the integration' '&pendulum length=1, gravity=1e300, release_angle=30, release_speed=0 /
&air linear=0.1 /
&output duration=10 /'
endless '2: &moving_pivot: the integration' "$plain
&moving_pivot amplitude=3*1e300, frequency=3*1 /"
endless '2: &moving_pivot: the integration' "$plain
&moving_pivot amplitude=3*1, frequency=3*1e150 /"
endless '3: &wind: the integration' "$plain
&air quadratic=0.1 /
&wind velocity=1e300,0,0 /"
endless '1: &pendulum: the integration' "$plain
&air linear=0.1 /
&output duration=1e300 /"
endless '2: &air: the integration' "$plain
&air linear=1e300 /"
endless '2: &earth_rotation: the integration' "$plain
&earth_rotation latitude=50, rate=1e300 /"
# Values as they were typed, and by the name that was typed.
echo '&pendulum length=1.0D0 z_upper=0.90D0 z_lower=-0.30D0 /' >typed.nml
fails 2 'their sum must be negative, got z_upper = 0.90D0, z_lower = -0.30D0' table typed.nml
echo '&pendulum length=1 energy_above_top=-30.0D0 momentum=1 /' >typed.nml
fails 2 'got energy_above_top = -30.0D0, gravity = 9.80665, length = 1' simulate typed.nml
finish
