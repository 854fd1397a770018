# Events that a scene asks for: in a file, between the samples, ending the run; what is refused.
. "$2/test/driver/expect.sh"

cat >swing.nml <<'END'
&pendulum length=1 release_angle=60 /
&event quantity='vx' direction=1 /
&event quantity='Z' value=-0.75 direction=-1 stop=.true. /
&output duration=10 samples=11 quantities='speed plane position' /
END
run simulate swing.nml --events events.csv
expect_status 0
expect_in_out '2.814523956033765e-01,2.21434'
checks=$((checks + 2))
[ "$(cut -d , -f 1,2,6 events.csv | sed 's/\(\.[0-9]\{4\}\)[0-9]*/\1/g')" = 't,event,energy_lost
2.8145e-01,z falls through -0.75,' ] || complain 'one event, which ends the run'
[ "$(sed -n '1p' events.csv)" = 't,event,x,y,z,energy_lost,speed,plane' ] || complain 'the quantities asked for'
sed -i.old 's/stop=.true. //' swing.nml
run simulate swing.nml
expect_status 0
expect_in_out '# vx rises through 0: t = 1.076'
expect_in_out '# z falls through -0.75: t = 2.8145'
checks=$((checks + 1))
[ "$(grep -c '^#' out)" = 15 ] || complain 'five turning points and ten passages'

# A Poincare section of a driven pendulum, in air: whenever it passes the vertical to the right.
cat >section.nml <<'END'
&pendulum length=1 release_angle=30 /
&air linear=0.5 /
&moving_pivot amplitude=0.05,0,0 frequency=0.5,0,0 relative=.true. /
&event quantity='x' direction=1 /
&output duration=60 samples=2 quantities='velocity' /
END
run simulate section.nml --events section.csv
expect_status 0
checks=$((checks + 1))
# In the end the motion has the period of the pivot, two seconds, and the section is one point.
awk -F, 'NR > 1 { before = t; old = $7; t = $1; v = $7 }
   END { exit !(NR > 25 && (t - before - 2)^2 < 1e-8 && (v/old - 1)^2 < 1e-8) }' section.csv || complain 'a section of one point'

# What is refused.
refuses() {
   printf '%s\n' '&pendulum length=1 release_angle=60 /' "$1" >bad.nml
   fails 2 "bad.nml:2: $2" simulate bad.nml
}
refuses "&event value=1 /" '&event: quantity is missing'
refuses "&event quantity='height' /" '&event: quantity must be a column, got height; known are x, y, z, vx,'
refuses "&event quantity='position' /" '&event: quantity must be a column, got position'
refuses "&event quantity=z /" '&event: quantity must be a text in quotation marks, got z'
refuses "&event quantity='z' direction=2 /" '&event: direction must be -1, 0 or 1, got 2'
refuses "&event quantity='z' direction=0.5 /" '&event: direction must be -1, 0 or 1, got 0.5'
refuses "&event quantity='z' stop=1 /" '&event: stop must be .true. or .false., got 1'
refuses "&event quantity='z' values=1 /" '&event: unknown name values; known are quantity, value, direction, stop'
refuses "&event quantity='z' value=1 value=2 /" '&event: value given twice, first on line 2'
if has_quad; then
   # To more digits than doubles have: mpmath's K/sqrt(g) and (K + F(asin(2 sqrt(0.2))))/sqrt(g), m = 1/4, with 50 digits.
   printf '%s\n' '&pendulum length=1 release_angle=60 /' "&event quantity='x' /" \
      "&event quantity='z' value=-0.6 direction=1 stop=T /" "&output duration=3 samples=4 quantities='speed' /" >fine.nml
   run simulate fine.nml --accuracy 1e-25 --events fine.csv
   expect_status 0
   expect_out 't,speed
0e+00,0
0.907558755296781028177199136,1.40047491944697103168907836'
   checks=$((checks + 1))
   [ "$(cat fine.csv)" = 't,event,x,y,z,energy_lost,speed
0.538310587945960681847506879,x falls through 0,0,0,-1.00000000000000000000000000,,3.13155712066696940842566394
0.907558755296781028177199136,z rises through -0.6,-0.800000000000000000000000000,0,-0.600000000000000000000000000,,1.40047491944697103168907836' ] ||
      complain 'events with all their digits'
   run simulate fine.nml --accuracy 1e-25
   expect_in_out '# x falls through 0: t = 0.538310587945960681847506879 s, x = 0 m, y = 0 m, z = -1.00'
   sed 's/plane //' swing.nml | sed "s/'Z'/'plane'/" >fine.nml
   fails 2 'option --accuracy below 1e-16: major, minor, plane' simulate fine.nml --accuracy 1e-20
   sed "s/duration=10/duration=1e17/; s/plane //" swing.nml >fine.nml
   fails 2 'fine.nml:2: &event: over so long double precision cannot tell one swing from the next' simulate fine.nml
fi

# A zero has no sign, in comments and in rows; a sheet is no NetCDF.
sed "s/quantity='vx' direction=1/quantity='x'/; /value=-0.75/d; /^&output/d" swing.nml >zero.nml
run simulate zero.nml --events zero.csv
checks=$((checks + 1))
grep -q 'x falls through 0,' zero.csv || complain 'a passage expected'
! grep -q -e '-0e+00' zero.csv || complain 'a zero has a sign in the events'
run simulate zero.nml
checks=$((checks + 1))
! grep -q -e '-0e+00' out || complain 'a zero has a sign in the samples or comments'
fails 2 'option --events writes CSV' simulate swing.nml --events events.nc

finish
