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

# In a fluid gravity is a quotient that no double is.
cat >fluid.nml <<'END'
&pendulum length=1, release_angle=60, release_speed=0 /
&buoyancy density_ratio=0.3, added_mass=0.5 /
&output duration=1e9, samples=2 /
END
for options in '' '--accuracy 1e-12' '--accuracy 1e-15'; do
   run simulate fluid.nml $options
   expect_status 0
   last 0.088861554812791655937 '' -0.99604398701877279296 "a fluid, $options"
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
finish
