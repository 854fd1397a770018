# The ellipse of a swing on every path: the plane turns as theory says.
. "$2/test/driver/expect.sh"

# turns NAME RATE TOLERANCE: the slope of the column `plane` (the second) of `out` in radians a second.
turns() {
   checks=$((checks + 1))
   awk -F, -v rate="$2" -v tolerance="$3" '
      NR == 2 { t = $1; first = $2 } NR > 2 { slope = ($2 - first)/($1 - t) }
      END { error = slope/rate - 1; if (!(error*error <= tolerance*tolerance)) { print slope " instead of " rate; exit 1 } }' out ||
      complain "$1"
}

# Foucault: 7.2921150e-5 sin(latitude) clockwise; the Pantheon, and 43.53 N (10.359 degrees an hour).
for latitude in 48.85 43.53; do
   cat >foucault.nml <<END
&pendulum length=67 release_angle=1 /
&earth_rotation latitude=$latitude /
&output duration=3600 samples=61 quantities='plane major minor' /
END
   run simulate foucault.nml
   expect_status 0
   # (Within a swing the plane of the moment varies by the turn of a quarter swing.)
   turns "Foucault at $latitude" "$(awk -v d=$latitude 'BEGIN { print -7.292115e-5*sin(d*atan2(0, -1)/180) }')" 1e-3
done
turns 'degrees an hour at 43.53' "$(awk 'BEGIN { print -10.359*atan2(0, -1)/180/3600 }')" 1e-3

# Airy: a small ellipse of radii a, b turns by 3 a b/(8 l**2) of its angular rate.
cat >airy.nml <<'END'
&pendulum length=1 gravity=1 position=0.03,0,-0.99954989 velocity=0,0.01,0 /
&output duration=600 samples=101 quantities='plane handedness' /
END
run simulate airy.nml
expect_status 0
turns 'Airy' "$(awk 'BEGIN { print 3/8*0.03*0.01 }')" 1e-3
checks=$((checks + 1))
awk -F, 'NR > 1 && $3 != 1 { exit 1 }' out || complain 'anticlockwise'

# The same with a drag too weak to matter, integrated; and far away in time, in quadruple precision, where it is a closed form.
sed 's/^&output/\&air linear=1e-12 \/\n\&output/' airy.nml >integrated.nml
run simulate integrated.nml
expect_status 0
turns 'Airy, integrated' "$(awk 'BEGIN { print 3/8*0.03*0.01 }')" 1e-3
sed 's/duration=600/duration=1e16/' airy.nml >late.nml
if has_quad; then
   run simulate late.nml
   expect_status 0
   turns 'Airy, late' "$(awk 'BEGIN { print 3/8*0.03*0.01 }')" 1e-3
   fails 2 'option --accuracy below 1e-16: major, minor, plane, handedness' simulate airy.nml --accuracy 1e-20
fi

# A frame that turns is seen against the plane; a string in flight has none; a circle neither.
sed 's/^&output/\&turning_frame rate=0.01 \/\n\&output/' airy.nml >frame.nml
run simulate frame.nml
expect_status 0
turns 'from a turning frame' "$(awk 'BEGIN { print 3/8*0.03*0.01 - 0.01 }')" 1e-3
cat >string.nml <<'END'
&pendulum length=1 position=0,0,-1 velocity=6,0.3,0 /
&string /
&output duration=0.6 samples=61 quantities='major tension' /
END
run simulate string.nml
expect_status 0
checks=$((checks + 2))
awk -F, 'NR > 1 && ($3 == 0) != ($2 == "") { exit 1 }' out || complain 'radii where the string is taut, and only there'
awk -F, 'NR > 1 && $2 == "" { n++ } END { exit !(n > 5) }' out || complain 'the string goes slack'
cat >circle.nml <<'END'
&pendulum length=1 z_upper=-0.6 z_lower=-0.6 /
&output samples=50 quantities='plane handedness major' /
END
run simulate circle.nml
expect_status 0
checks=$((checks + 1))
awk -F, 'NR > 1 && ($2 != "" || $3 != 1) { exit 1 }' out || complain 'a circle has no plane, and a sense'

# The swinging spring of P. Lynch (Int. J. Nonlinear Mech. 37 (2002) 345; P. Lynch and C. Houghton, Physica D 190 (2004) 38), whose
# vertical oscillation is twice as fast as its swing: the plane stands still while the swing is wide, and steps by 30 degrees, for this
# start, each time that the swing dies away.
cat >spring.nml <<'END'
&pendulum length=0.75 gravity=9.8696044 position=0.04,0,-0.92 velocity=0,0.03427,0 /
&elastic stiffness=39.4784176 mass=1 /
&output duration=150 samples=15001 quantities='plane major' /
END
run simulate spring.nml
expect_status 0
checks=$((checks + 1))
awk -F, 'BEGIN { degree = atan2(0, -1)/180 }
   NR > 1 && $3 > 0.13 { if (!wide) { wide = 1; if (steps++ && (($2 - first)/degree - 30)^2 > 0.04) bad = 1; first = $2 }
      last = $2; if (((last - first)/degree)^2 > 0.25) bad = 1 }
   NR > 1 && $3 < 0.1 { wide = 0 }
   END { exit !(steps == 6 && !bad) }' out || complain 'five steps of 30 degrees, and rest between them'

finish
