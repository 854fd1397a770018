# What `simulate --summary` says, against theory.
. "$2/test/driver/expect.sh"

# is KEY NUMBER TOLERANCE: a number of the JSON in `out`, to a part of it.
is() {
   checks=$((checks + 1))
   found=$(tr ',{}' '\n\n\n' <out | sed -n "s/^ *\"$1\": //p" | head -n 1)
   awk -v found="$found" -v wanted="$2" -v tolerance="$3" 'BEGIN {
      error = found - wanted; if (found == "" || !(error^2 <= (tolerance*wanted)^2)) exit 1 }' ||
      complain "$1 is $found instead of $2"
}

# One orbit: its constants, and its turning heights with their times.
cat >orbit.nml <<'END'
&pendulum name='"wide"' length=1 z_upper=0.3 z_lower=-0.8 /
&output duration=10 samples=50 quantities='speed' /
END
run simulate orbit.nml --summary
expect_status 0
expect_in_out 'pendulum:   "wide"'
expect_in_out 'period:     2.17359 s to and fro'
expect_in_out 'height:     -0.800000 to 0.300000 m, at 0.543397 and 0 s'
expect_in_out 'speed:      3.75787 to 5.97463 m/s, at 0 and 0.543397 s'
expect_in_out 'tension:    11.1796 to 43.5415 m/s2, at 0 and 0.543397 s'
checks=$((checks + 1))
[ "$(wc -l <out)" -le 12 ] || complain 'ten lines or so'
run simulate orbit.nml --summary json --output orbit.csv
expect_in_out '"pendulum": "\"wide\"",'
is period_to_and_fro_s 2.17358656402479 1e-12
# lambda T/T of doc/scene_format.md's table.
is area 2.048962 1e-6
checks=$((checks + 1))
[ "$(sed -n 1p orbit.csv; wc -l <orbit.csv | tr -d ' ')" = 't,speed
51' ] || complain 'the samples as without a summary'

# A circle, and a motion over the top, go round.
for number in 1 2; do
   run simulate "$top/examples/scenes/$([ "$number" = 1 ] && echo conical || echo plane).nml" --pendulum "$number" --summary
   expect_in_out ' s, a revolution'
done

run simulate "$top/examples/scenes/conical_drag.nml" --summary
expect_in_out 's, a revolution, mean of '

# Linear drag k: the amplitude falls to 1/e in 2/k, Q = omega/k.
cat >drag.nml <<'END'
&pendulum length=1 release_angle=0.5 /
&air linear=0.02 /
&output duration=100 samples=3 /
END
run simulate drag.nml --summary=json
is decay_time_s 100 1e-5
is quality "$(awk 'BEGIN { print sqrt(9.80665)/0.02 }')" 2e-5
checks=$((checks + 1))
awk -F'"left_over": ' 'NF > 1 { n++; if (!(($2 + 0)^2 < 1e-22)) exit 1 } END { exit n != 1 }' out || complain 'the account closes to 1e-11'

# The parts of the precession make up the whole: area, Earth, a support that is longer along x.
cat >parts.nml <<'END'
&pendulum length=1 position=0.02,0.015,-0.99968745 velocity=-0.009,0.012,0 /
&anisotropic_support extra_length_x=0.001 /
&earth_rotation latitude=50 /
&output duration=60 samples=2 /
END
run simulate parts.nml --summary json
is earth "$(awk 'BEGIN { print -7.292115e-5*sin(50*atan2(0, -1)/180) }')" 1e-5
checks=$((checks + 1))
tr ',{}' '\n\n\n' <out | awk -F': ' '/precession_rad_per_s/ { whole = $2 } /"(area|earth|support)"/ { sum += $2; n++ }
   END { exit !(n == 3 && (whole - sum)^2 < (0.003*whole)^2) }' || complain 'the parts make up the whole'

# Also where the ellipse passes near a circle and its plane turns by 60 degrees within some swings.
cat >circle.nml <<'END'
&pendulum length=2 position=0.05,0.03,-1.99914982 velocity=0,0,0 /
&anisotropic_support extra_length_x=0.02 /
&output duration=300 samples=2 /
END
run simulate circle.nml --summary json
checks=$((checks + 1))
tr ',{}' '\n\n\n' <out | awk -F': ' '/precession_rad_per_s/ { whole = $2 } /"(area|earth|support)"/ { sum += $2; n++ }
   END { exit !(n == 3 && (whole - sum)^2 < (0.002*whole)^2) }' || complain 'the parts make up the whole'

# The Pantheon: 11.3 degrees an hour.
cat >paris.nml <<'END'
&pendulum length=67 release_angle=2.6 /
&earth_rotation latitude=48.85 /
&output duration=3600 samples=2 /
END
run simulate paris.nml --summary
checks=$((checks + 1))
grep -q '^precession: -11\.3[0-9]* degrees/hour' out || complain '11.3 degrees an hour'

# A museum's: 10.359 degrees an hour of the Earth, and what else turns its plane, to a hundredth of a degree.
run simulate "$top/examples/scenes/museum_foucault.nml" --summary json --events tops.csv
is earth "$(awk 'BEGIN { print -10.359*atan2(0, -1)/180/3600 }')" 1e-4
checks=$((checks + 2))
tr ',{}' '\n\n\n' <out | awk -F': ' '/precession_rad_per_s/ { whole = $2 } /"(area|earth|support)"/ { sum += $2; n++ }
   END { exit !(n == 3 && (whole - sum)^2 < (0.01*atan2(0, -1)/180/3600)^2) }' || complain 'the parts make up the whole'
[ "$(wc -l <tops.csv)" -gt 790 ] || complain 'every highest point is an event'

# The account of every pendulum of every example closes to 1e-11 of g l.
# (With $3 those of many hours are left out.)
for scene in "$top"/examples/scenes/*.nml; do
   case ${3:+few}$scene in few*foucault_*) continue ;; esac
   number=0
   while [ "$number" -lt "$(grep -c '^&pendulum' "$scene")" ]; do
      number=$((number + 1))
      run simulate "$scene" --pendulum "$number" --summary json
      checks=$((checks + 1))
      tr ',{}' '\n\n\n' <out | awk -F': ' '/"left_over"/ { left = $2; n++ } /"g_l"/ { scale = $2; n++ }
         END { exit !(n == 2 && left^2 <= (1e-11*scale)^2) }' || complain "the account of ${scene##*/} closes"
   done
done

# A pivot that moves: the parts are those seen from it, and what has none of its own is named.
cat >shaken.nml <<'END'
&pendulum length=67 position=2.9,0,-66.9372093836405 velocity=0,0.02,0 /
&earth_rotation latitude=48.85 /
&moving_pivot amplitude=0.001,0,0 frequency=1,0,0 /
&output duration=600 samples=2 /
END
run simulate shaken.nml --summary json
is earth "$(awk 'BEGIN { print -7.292115e-5*sin(48.85*atan2(0, -1)/180) }')" 1e-5
# Airy: 3/8 sqrt(g/l) a b/l**2, b = 0.02/sqrt(g/l).
is area "$(awk 'BEGIN { print 0.375*2.9*0.02/67^2 }')" 0.01
run simulate shaken.nml --summary
expect_in_out '(&moving_pivot, higher orders)'

# A string: how long it is slack, what it loses.
run simulate "$top/examples/scenes/slack_string.nml" --summary json
is slack_phases 46 0
is lost_by_string 6.80855 1e-5

fails 2 'option --summary: standard output has it' simulate orbit.nml --summary --output -
fails 2 "option --summary must be one of" simulate orbit.nml --summary=xml
if has_quad; then
   # To more digits than doubles have, and for longer than they can tell: the same constants.
   run simulate orbit.nml --summary
   cp out plain
   run simulate orbit.nml --summary --accuracy 1e-20
   expect_status 0
   checks=$((checks + 1))
   sed 2d plain >wanted
   sed 2d out | cmp -s wanted - || complain 'the summary of the orbit'
   sed 's/duration=10/duration=1e17/' orbit.nml >long.nml
   run simulate long.nml --summary
   expect_in_out 'period:     2.17359 s to and fro'
   expect_in_out 'height:     -0.800000 to 0.300000 m, at 0.543397 and 0 s'
fi

finish
