# One rule for the azimuth on every path: the angle of the bob's horizontal position, counted in turns, half a turn up at a
# passage through the axis; on the axis that of the direction in which the bob moves; empty only for a bob at rest for ever.
. "$2/test/driver/expect.sh"

# follows NAME: out has t, x, y, vx, vy, azimuth; the rule holds in every line, the first angle lies between -pi and pi, and no
# line is more than half a turn from the one before.
follows() {
   checks=$((checks + 1))
   grep -v '^#' out | awk -F, -v limit="${2:-1e-7}" '
      NR == 1 { pi = atan2(0, -1); next }
      $6 == "" { print "empty", $0; exit }
      # About to move: judged by the line that follows.
      $2*$2 + $3*$3 + $4*$4 + $5*$5 == 0 { before = $6; next }
      {
         angle = $2*$2 + $3*$3 > 1e-24 ? atan2($3, $2) : atan2($5, $4)
         d = $6 - angle
         d -= 2*pi*int(d/(2*pi) + (d < 0 ? -0.5 : 0.5))
         if (!(d*d < limit*limit)) { print "angle", $0; exit }
         if (NR == 2 && !($6*$6 < 9.87)) { print "first", $0; exit }
         if (NR > 2 && !($6 - before > -pi + 1e-7 && $6 - before < pi + 1e-7)) { print "jump", before, $0; exit }
         before = $6
         last = $6
      }' >wrong
   [ ! -s wrong ] || complain "$1: $(cat wrong)"
}

# climbs NAME: no azimuth below the one before, in the end at least half a turn above the first.
climbs() {
   checks=$((checks + 1))
   grep -v '^#' out | awk -F, 'NR == 2 { first = $6 } NR > 2 && !($6 > before - 1e-9) { print "down", before, $0; exit } NR > 1 { before = $6 }
      END { if (!(before > first + 3.1)) print "no half turn" }' >wrong
   [ ! -s wrong ] || complain "$1: $(cat wrong)"
}

# scene START GROUPS
scene() {
   cat >scene.nml <<END
&pendulum length=1, $1 /
&output duration=${duration:-3}, samples=${samples:-301}, quantities='position velocity azimuth' /
${2:-}
END
   run simulate scene.nml
   expect_status 0
   awk -F, '/^#/ { print; next } { print $1 "," $2 "," $3 "," $5 "," $6 "," $8 }' out >short
   mv short out
}

if "$program" --version | grep -q GSL; then paths='none string drag'; else paths='none string'; fi
for path in $paths; do
   case $path in
   none) group= ;;
   string) group='&string /' ;;
   drag) group='&air linear=1e-9 /' ;;
   esac
   # From the bottom, slow and fast, in every quarter; along the axes; from the side, through the axis and past it.
   for start in 'position=0,0,-1, velocity=3,4,0' 'position=0,0,-1, velocity=-1,2,0' 'position=0,0,-1, velocity=-3,-5,0' \
      'position=0,0,-1, velocity=0,-2,0' 'position=0,0,-1, velocity=-2,0,0' 'release_angle=0, release_speed=3' \
      'release_angle=60, release_speed=0' 'position=0,0.6,-0.8, velocity=0,0,0' 'position=-0.36,-0.48,-0.8, velocity=0,0,0' \
      'position=0.6,0,-0.8, velocity=0,0.01,0' 'position=0.6,0,-0.8, velocity=0,-0.01,0'; do
      scene "$start" "$group"
      follows "$start $group"
      case $start in
      *0.01*) ;;
      *) climbs "$start $group" ;;
      esac
   done
done

# On the axis at the time of a sample: the direction in which it moves on. The bob comes back to the bottom from the other side
# after half a period: 4 K(sin 30 degrees)/omega = 7.416/... of a quarter circle with g = l = 1 passes it at K(1/2).
cat >scene.nml <<'END'
&pendulum length=1, gravity=1, position=0,0,-1, velocity=1,0,0 /
&output samples=3, quantities='azimuth' /
END
run simulate scene.nml
expect_match '^0e+00,[^,]*\(0e+00\|e-1[5-9]\)$'
expect_match '^[^,]*,3.14159265358979[0-9]*e+00$'

# Towards the top for ever: from the bottom, on the way up, and coming down through the bottom first.
for start in 'energy_above_top=0, momentum=0' 'position=0.6,0.8,0, velocity=0,0,2, gravity=2' \
   'position=0.6,0.8,0, velocity=0,0,-2, gravity=2'; do
   scene "$start"
   follows "$start"
done
climbs "$start"
# The motion from such a start, not from the bottom: z = 1 - 2/cosh(omega (t + t0))**2 with omega = sqrt(2), tanh(omega t0) = 1/sqrt(2).
scene 'position=0,1,0, velocity=0,0,2, gravity=2'
checks=$((checks + 1))
awk -F, 'function cosh(u) { return (exp(u) + exp(-u))/2 }
   NR > 1 { w = sqrt(2); u = w*$1 + log(1 + w); d = $3 - 2*sqrt(1 - 1/cosh(u)^2)/cosh(u)
      if (!(d*d < 1e-20 && $2*$2 < 1e-20)) { print $0, d; exit } }' out >wrong
[ ! -s wrong ] || complain "the way to the top from the middle: $(cat wrong)"

# At rest for ever: empty.
for groups in '' '&string /'; do
   scene 'release_angle=0, release_speed=0' "$groups"
   checks=$((checks + 1))
   ! grep -q '^[^#t].*[^,]$' out || complain "at rest, $groups: no azimuth expected"
done

if "$program" --version | grep -q GSL; then
   scene 'release_angle=0, release_speed=0' '&earth_rotation latitude=50 /'
   checks=$((checks + 1))
   ! grep -q '^[^#t].*[^,]$' out || complain 'at rest beside the Earth: no azimuth expected'
   # At rest until the wind takes it along -y; until the pivot leaves the bob behind, which it does not at once.
   scene 'release_angle=0, release_speed=0' '&air linear=0.1 /
&wind velocity=0,-1,0 /'
   follows 'wind'
   expect_match '^0e+00,0e+00,0e+00,0e+00,0e+00,-1.57079632679489[0-9]*e+00$'
   duration=0.2 scene 'release_angle=0, release_speed=0' '&moving_pivot amplitude=0.1,0.1,0, frequency=1,1,0, phase=90,-90,0,
 relative=.true. /'
   follows 'pivot'
   expect_match '^0e+00,0e+00,0e+00,0e+00,0e+00,2.356194490192[0-9]*e+00$'
   # A zero with a sign is no half turn down.
   duration=0.2 scene 'position=0,0,-1, velocity=-1,-0,0' '&elastic stiffness=1000, mass=1 /'
   expect_match '^0e+00,0e+00,0e+00,-1e+00,0e+00,3.141592653589793e+00$'
   duration=0.2 scene 'position=-0.1,-0,-1, velocity=0,0,0' '&elastic stiffness=1000, mass=1 /'
   follows 'elastic'
   expect_match '^0e+00,-1e-01,0e+00,0e+00,0e+00,3.141592653589793e+00$'
fi
finish
