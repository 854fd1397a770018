# NetCDF files of `simulate`: the numbers of the CSV, bit by bit, and what describes them. $3 prints such a file.
. "$2/test/driver/expect.sh"
reader=$3

scene=$top/examples/scenes/slack_string.nml
run simulate "$scene" --output swing.nc --plot swing.svg
expect_status 0
checks=$((checks + 1))
[ ! -s out ] || complain 'nothing on standard output expected'
run simulate "$scene" --events events.csv
command_line='reading swing.nc'
"$reader" swing.nc >samples || complain 'the file must be readable'
checks=$((checks + 1))
tail -n +2 out | cmp -s - samples || complain 'the samples of the CSV expected'
"$reader" swing.nc events | cut -d , -f 1-5 >events
checks=$((checks + 1))
tail -n +2 events.csv | cut -d , -f 1,3-6 | cmp -s - events || complain 'the events of the CSV expected'
"$reader" swing.nc attributes >out
expect_in_out 'CF-1.10'
expect_in_out 'slack string'
expect_in_out "   restitution = 0.2               ! part of the radial speed that comes back"
expect_in_out 'time s'
expect_in_out 'vx m s-1'
expect_in_out 'energy m2 s-2'
expect_in_out 'event_energy_lost m2 s-2'

# Derivatives are columns like others.
printf '%s\n' '&pendulum length=2, release_angle=60 / &air quadratic=0.1 / &output duration=4, samples=5,' \
   'quantities="inclination derivatives", derivatives="release_angle quadratic" /' >derived.nml
run simulate derived.nml --output derived.nc
expect_status 0
run simulate derived.nml
command_line='reading derived.nc'
expect_in_out 't,inclination,dinclination_drelease_angle,dinclination_dquadratic'
"$reader" derived.nc >samples
checks=$((checks + 1))
tail -n +2 out | cmp -s - samples || complain 'the samples of the CSV expected'
"$reader" derived.nc attributes >out
expect_in_out 'dinclination_drelease_angle rad/(degree)'
expect_in_out 'dinclination_dquadratic rad/(1/m)'

# Events asked for, one of which ends the run: of samples there are as many as there were.
printf '%s\n' '&pendulum length=1, release_angle=60 / &event quantity="vx" / &event quantity="z" value=-0.75 direction=-1 stop=T /' \
   '&air quadratic=0.01 / &output duration=10, samples=101, quantities="speed position" /' >ended.nml
run simulate ended.nml --output ended.nc
expect_status 0
run simulate ended.nml --events events.csv
command_line='reading ended.nc'
"$reader" ended.nc >samples
checks=$((checks + 2))
tail -n +2 out | cmp -s - samples || complain 'the samples of the CSV expected'
"$reader" ended.nc events | cut -d , -f 1-4 >events
tail -n +2 events.csv | cut -d , -f 1,3-5 | cmp -s - events || complain 'the events of the CSV expected'
"$reader" ended.nc attributes >out
expect_in_out 'slack taut rebound taut_after_rattling vx_rises_through_0 vx_falls_through_0 z_rises_through_-0.75'
expect_in_out 'event_speed m s-1'

# Many blocks; what does not exist; files whole or not at all.
printf '%s\n' '&pendulum length=1, z_upper=0.3, z_lower=-0.8 / &output duration=100, samples=20001, quantities="azimuth" /' >long.nml
run simulate long.nml --output long.nc
expect_status 0
run simulate long.nml
command_line='reading long.nc'
"$reader" long.nc >samples
checks=$((checks + 1))
tail -n +2 out | cmp -s - samples || complain 'the samples of the CSV expected'
cp swing.nc before.nc
fails 2 'option --events: a NetCDF file has the events in it' simulate "$scene" --output swing.nc --events e.csv
fails 2 'cannot write nowhere/swing.nc: No such file or directory' simulate "$scene" --output nowhere/swing.nc
printf '%s\n' '&pendulum length=1, z_upper=0.3, z_lower=-0.8 / &output duration=1e6, samples=100000000 /' >endless.nml
command_line="kyvadlo simulate endless.nml --output swing.nc, interrupted"
"$program" simulate endless.nml --output swing.nc >out 2>err &
pid=$!
i=0
while ! ls ./*part* >/dev/null 2>&1 && [ "$i" -lt 50 ]; do i=$((i + 1)); sleep 0.1; done
sleep 0.2
kill -TERM "$pid"
wait "$pid" 2>/dev/null
status=$?
checks=$((checks + 1))
{ [ "$status" -gt 128 ] && [ -z "$(find . -name '*part*')" ]; } || complain 'no unfinished file may stay'
checks=$((checks + 1))
cmp -s swing.nc before.nc || complain 'an interrupted run must leave the old file'

finish
