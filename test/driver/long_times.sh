# Long times: what was rounded once at the set-up must not grow with them. Values from test/reference/make_long_times.py.
. "$2/test/driver/expect.sh"

# last X Y Z NAME: columns 2 to 4 of the last line are these to 1e-15 (nothing: not looked at).
last() {
   checks=$((checks + 1))
   tail -n 1 out | awk -F, -v x="$1" -v y="$2" -v z="$3" '
      function off(value, expected) { return expected != "" && !((value - expected)^2 < 1e-30) }
      off($2, x) || off($3, y) || off($4, z) { print }' >wrong
   [ ! -s wrong ] || complain "$4: $(cat wrong)"
}

# keeps_its_digits NAME: start.nml ends where it ends with more digits.
keeps_its_digits() {
   run simulate start.nml --accuracy 1e-17
   expect_status 0
   # shellcheck disable=SC2046
   set -- "$1" $(tail -n 1 out | tr , ' ')
   run simulate start.nml
   last "$3" "$4" "$5" "$1"
}

# In a fluid gravity is a quotient that no double is.
cat >fluid.nml <<'END'
&pendulum length=1, release_angle=60, release_speed=0 /
&buoyancy density_ratio=0.3, added_mass=0.5 /
&output duration=1e9, samples=2 /
END
finest=3.6e-15
! has_quad || finest=1e-15
for options in '' '--accuracy 1e-12' "--accuracy $finest"; do
   run simulate fluid.nml $options
   expect_status 0
   last 0.088861554812791655937 '' -0.99604398701877279296 "a fluid, $options"
done

# From every start alike: energy and momentum were 4.4e-8 l off. (Numbers that doubles hold: quadruple precision means the same.)
starts='length=1,z_upper=0.25,z_lower=-0.75
length=1,upper_gap=0.75,lower_rise=0.25
length=1,upper_rise=1.25,lower_rise=0.25
length=1,energy=0.5,momentum=1.125
length=1,energy_above_bottom=10,momentum=1.125
length=1,energy_above_top=0.5,momentum=1.125
length=1,release_angle=60,release_speed=1.125
length=5,position=3,0,-4,velocity=0,1.125,0'
for start in $starts; do
   has_quad || break
   echo "&pendulum gravity=9.8125, $start / &buoyancy density_ratio=0.3 / &output duration=1e9, samples=2 /" >start.nml
   keeps_its_digits "in a fluid, $start"
done

# Of a body the length is a quotient that no double is: 1.4e-7 l off.
echo '&pendulum gravity=9.80665, release_angle=60, release_speed=0 / &body inertia=1, distance=0.75, mass=1 / &output duration=1e9, samples=2 /' >body.nml
for options in '' '--accuracy 1e-12' "--accuracy $finest"; do
   run simulate body.nml $options
   last -1.1394852429226013729 '' -0.69235190397614847284 "a body, $options"
done
for body in 'inertia=1, distance=0.75, mass=1' 'bob_diameter=0.125, mass=1, wire_mass=0.25'; do
   for start in $starts; do
      has_quad || break
      case $body in inertia*) start=${start#*,} ;; esac
      # The sphere of a body is another.
      case $body-$start in
         inertia*position*) start='position=0.8046875,0,-1.0625,velocity=0,1.125,0' ;;
         *position*) start='length=1,position=0.578125,0,-0.76953125,velocity=0,1.125,0' ;;
      esac
      echo "&pendulum gravity=9.8125, $start / &body $body / &output duration=1e9, samples=2 /" >start.nml
      keeps_its_digits "$body, $start"
   done
done

# Seen from a turning frame: an angle of 3e8 rad.
cat >frame.nml <<'END'
&pendulum length=1, gravity=2, z_upper=-0.5, z_lower=-0.5 /
&turning_frame rate=0.3 /
&output duration=1e9, samples=2 /
END
run simulate frame.nml
last -0.033848150189358143077 0.86536368234907955045 -0.5 'a turning frame'
# One that turns along: what is left of the azimuth is a small difference.
sed 's/rate=0.3/rate=2/; s/samples=2/samples=2, quantities="azimuth"/' frame.nml >along.nml
run simulate along.nml
checks=$((checks + 1))
tail -n 1 out | awk -F, '!($2*$2 < 1e-30) { exit 1 }' || complain 'no azimuth expected in a frame that turns along'

# A release angle is in two parts too: 50 degrees were 3.5e-8 l off.
cat >release.nml <<'END'
&pendulum length=1, release_angle=50, release_speed=0 /
&output duration=1e9, samples=2 /
END
run simulate release.nml
last -0.26376881558684936633 '' -0.96458592770364976478 'a release'

# Where double precision cannot tell the phase more digits are taken, with or without an accuracy.
cat >phase.nml <<'END'
&pendulum length=1, release_angle=30, release_speed=0 /
&output duration=6e15, samples=4, quantities='position velocity energy tension azimuth inclination speed momentum' /
END
# (A build without them says so.)
has_quad || fails 2 'no precision of this build can tell the phase' simulate phase.nml
for options in '' '--accuracy 1e-6'; do
   has_quad || break
   run simulate phase.nml --explain $options
   expect_status 0
   checks=$((checks + 1))
   grep -q '^path: .*(real128)$' err || complain 'real128 expected'
   last 0.234865943064057988 0 -0.972027771613872497 "6e15 s, $options"
   checks=$((checks + 1))
   # z and the rest agree: energy, inclination; the azimuth is that of x, half a turn up every half period.
   awk -F, 'NR > 1 { v = ($5^2 + $7^2)/2 + 9.80665*$4; if (!((v - $8)^2 < 1e-24) || !((sin($11) - ($2 < 0 ? -$2 : $2))^2 < 1e-24) ||
      !(($9 - $12^2 + 9.80665*$4)^2 < 1e-24)) print }' out >wrong
   [ ! -s wrong ] || complain "the columns contradict each other: $(cat wrong)"
done
if has_quad; then
   sed 's/6e15/6e17/' phase.nml >later.nml
   run simulate later.nml
   last -0.469551419408600156 0 -0.882905127707031087 '6e17 s'
fi
for duration in 1e300 1e36; do
   sed "s/6e15/$duration/" phase.nml >lost.nml
   fails 2 'lost.nml:2: &output: over ' simulate lost.nml
done
# The gravity in a fluid is known to two parts of a double.
sed 's/6e15/1e30/' phase.nml >fluid_later.nml
echo '&buoyancy density_ratio=0.1 /' >>fluid_later.nml
fails 2 'can tell the phase of the motion' simulate fluid_later.nml
fails 2 'an accuracy of 1e-12 cannot be kept' simulate fluid_later.nml --accuracy 1e-12

# Below 1e-16 the figures that are kept are written: l = g = 1 from 90 degrees.
cat >figures.nml <<'END'
&pendulum length=1, gravity=1, release_angle=90, release_speed=0 /
&output duration=2, samples=3 /
END
if has_quad; then
   run simulate figures.nml --accuracy 1e-20
   expect_status 0
   expect_match '^1e+00,0.87954813241188915462[0-9]*,0,-0.47580992294272079709[0-9]*,'
   expect_match '^2e+00,-0.20419321478828042252[0-9]*,0,-0.97893060583190838214[0-9]*,'
   run simulate figures.nml --accuracy 1e-30
   expect_match '^2e+00,-0.204193214788280422521119048027'
   run simulate figures.nml --accuracy 1e-15
   expect_match '^1e+00,8.79548132411889[0-9]*e-01,'
   # 0.1 is the decimal, not the double next to it, which is 5e-18 off; and the times are, as `eval --kind quad position` reads them.
   cat >decimals.nml <<'END'
&pendulum length=0.1, gravity=9.81, z_upper=-0.02, z_lower=-0.07 /
&output duration=0.6, samples=3 /
END
   run simulate decimals.nml --accuracy 1e-30
   expect_status 0
   expect_match '^3e-01,-0.0353426244927007547121416295508[0-9]*,-0.0896645058701241312200631917880[0-9]*,'
   echo '&buoyancy density_ratio=0.5, added_mass=0 /' >>decimals.nml
   run simulate decimals.nml --accuracy 1e-30
   expect_status 0
   expect_match '^3e-01,-0.0778868909772754338022127919006[0-9]*,-0.0024566955111624188067521341862[0-9]*,'
   # What quadruple precision takes off a decimal grows with the time; what a double holds it keeps.
   sed '/buoyancy/d; s/duration=0.6, samples=3/duration=1e15, samples=2/' decimals.nml >decimals_later.nml
   fails 2 'the decimals of the scene, rounded to quadruple precision, lose the phase by more' simulate decimals_later.nml \
      --accuracy 1e-20
   run simulate decimals_later.nml --accuracy 1e-15
   expect_status 0
   sed 's/duration=2, samples=3/duration=1e15, samples=2/; s/release_angle=90, release_speed=0/z_upper=0.25, z_lower=-0.75/' \
      figures.nml >figures_later.nml
   run simulate figures_later.nml --accuracy 1e-18
   expect_status 0
   fails 2 'option --accuracy must be at least 1.2e-32' simulate figures.nml --accuracy 1.1e-32
   run simulate figures.nml --accuracy 1.2e-32
   expect_status 0
   fails 2 '.nc' simulate figures.nml --accuracy 1e-20 --output figures.nc
else
   fails 2 'option --accuracy must be at least 3.6e-15' simulate figures.nml --accuracy 1e-20
fi
fails 2 'option --accuracy must be at least ' simulate figures.nml --accuracy 1e-40
finish
