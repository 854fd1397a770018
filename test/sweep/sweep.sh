# `kyvadlo sweep`: the interface, the same bytes whoever computes, and whatever ends a run early. $3: mpirun, or empty.
. "$2/test/driver/expect.sh"
mpirun=${3-}
plans=$top/examples/sweeps
with_netcdf=yes
"$program" sweep "$plans/periods.nml" --output probe.nc 2>err || with_netcdf=
# mpirun waits for ever for ranks that were killed while they met for the first time.
patience=300
ranks() { count=$1; shift; timeout -k 2 "$patience" "$mpirun" --oversubscribe --allow-run-as-root -n "$count" "$program" sweep "$@"; }
same() {
   checks=$((checks + 1))
   cmp -s "$1" "$2" || complain "$2 must have the bytes of $1"
}

# Values are those of eval to 8 ulp, and masked is what eval refuses.
run sweep "$plans/periods.nml"
expect_status 0
tail -n +2 out | awk -F, 'NR % 7 == 1' >some
while IFS=, read -r upper lower values; do
   answer=$("$program" eval orbit 1 9.80665 "$upper" "$lower" 2>/dev/null)
   if [ -z "$answer" ]; then expected=,,,inadmissible; else
      expected=$(echo "$answer" | awk '{ print $1 "," $2 "," $8 ",computed" }'); fi
   echo "$upper,$lower,$values,$expected"
done <some >both
checks=$((checks + 1))
awk -F, 'function near(x, y) { return x == y || (x - y)^2 <= (1.8e-15*y)^2 && x != "" && y != "" }
   !(near($3, $7) && near($4, $8) && near($5, $9) && $6 == $10) { print }' both >found
{ [ ! -s found ] && [ "$(wc -l <both)" -gt 50 ]; } || complain "a sweep, and eval: $(head -n 3 found)"

# What is refused.
plan() { printf '%s\n' "&pendulum length=1, z_upper=0.3, z_lower=-0.8 /" "$@" >plan.nml; }
plan '&measure quantities="T" /'
fails 2 'a sweep needs from 1 to 64 &axis groups' sweep plan.nml
plan '&axis name="lenth", values=1 /' '&measure quantities="T" /'
fails 2 "plan.nml:2: &axis: 'lenth' is no setting of a scene" sweep plan.nml
plan '&axis name="length", from=1, to=2 /' '&measure quantities="T" /'
fails 2 'plan.nml:2: &axis: count is missing' sweep plan.nml
plan '&axis name="length", values=1 /' '&measure quantities="Q" /'
fails 2 "quantities: unknown word 'Q'" sweep plan.nml
plan '&axis name="length", values=1 /' '&axis name="length", values=2 /' '&measure quantities="T" /'
fails 2 'plan.nml:3: &axis: a second axis of length' sweep plan.nml
plan '&axis name="latitude", values=1 /' '&measure quantities="T" /'
fails 2 '&earth_rotation: the quantities of an orbit' sweep plan.nml
plan '&axis name="length", values=1 /' '&measure quantities="T" /' '&histogram quantity="T", from=0, to=1, count=3 /'
fails 2 'a plan with &histogram needs --output FILE.nc' sweep plan.nml
fails 2 'sweep needs one plan' sweep
fails 2 'options --resume, --part and --merge need --output FILE.nc' sweep plan.nml --resume

plan '&axis name="length", random="normal", count=2, covariance=1, deviation=1 /' '&measure quantities="T" /'
fails 2 'plan.nml:2: &axis: ' sweep plan.nml
plan '&axis name="length", values=1 /' '&measure quantities="T" /'
cp plan.nml same.nml
fails 2 'the plan and option --output are one file' sweep plan.nml --output plan.nml --force
checks=$((checks + 1))
cmp -s plan.nml same.nml || complain 'the plan must stay'

# Axes together run side by side; others multiply, the last the fastest.
plan '&axis name="length", values=1,2, together="a" /' '&axis name="gravity", values=9,10 /' \
   '&axis name="z_upper", values=0.1,0.2, together="a" /' '&measure quantities="heights" /'
run sweep plan.nml
expect_out 'length,gravity,z_upper,heights_1,heights_2,status
1e+00,9e+00,1e-01,1e-01,-8e-01,computed
1e+00,1e+01,1e-01,1e-01,-8e-01,computed
2e+00,9e+00,2e-01,2e-01,-8e-01,computed
2e+00,1e+01,2e-01,2e-01,-8e-01,computed'

# Between decimals as they were typed: circles are met, what is no orbit is none, 0 is 0.
printf '%s\n' "&pendulum length=1 / &axis name='z_upper' from=-0.9 to=0.9 count=19 / &axis name='z_lower' from=-1 to=0 count=11 /" \
   "&measure quantities='T' /" >grid.nml
run sweep grid.nml
expect_status 0
for height in 9 8 7 6 5 4 3 2 1; do expect_match "^-${height}e-01,-${height}e-01,.*,computed\$"; done
checks=$((checks + 2))
[ "$(grep -c computed out)" -eq 109 ] || complain "109 of 209 pairs are orbits, got $(grep -c computed out)"
[ "$(sed 1d out | cut -d , -f 1 | awk 'length > 6' | wc -l)" -eq 0 ] || complain 'a height is not the decimal'
printf '%s\n' "&pendulum length=1, z_upper=0, z_lower=-0.5 / &axis name='gravity' from=9.7 to=9.9 count=21 /" \
   "&axis name='z_upper' from=-0.3 to=0.6 count=10 together='g' / &measure quantities='T' /" | sed "s/count=21/count=10 together='g'/" >zero.nml
run sweep zero.nml
expect_match '^[^,]*,0e+00,'

# One pendulum of several, by name or number: as if the plan had it alone.
axis="&axis name='gravity', values=9,10 / &measure quantities='T heights' /"
printf '%s\n' "&pendulum name='low' length=2, z_upper=-1, z_lower=-1.8 / $axis" >low.nml
printf '%s\n' "&pendulum length=1, z_upper=0.3, z_lower=-0.8 / &pendulum name='low' length=2, z_upper=-1, z_lower=-1.8 /" \
   "$axis" >two.nml
run sweep low.nml
cp out low.csv
for name in low 2; do
   run sweep two.nml --pendulum $name
   same low.csv out
done
run sweep two.nml --pendulum 'pendulum 1'
expect_match '^9e+00,.*,3e-01,-8e-01,computed'
fails 2 "option --pendulum: none is named 'x'; give another name, or a number from 1 to 2" sweep two.nml --pendulum x
fails 2 'two.nml:1: a second &pendulum; choose it by --pendulum' sweep two.nml

# A sheet that is there stays, unless it is said to go.
echo mine >mine.csv
fails 2 'mine.csv is there already; replace it by --force' sweep two.nml --pendulum 2 --output mine.csv
grep -q mine mine.csv || complain 'a sheet was replaced without --force'
run sweep two.nml --pendulum 2 --output mine.csv --force
expect_status 0
same low.csv mine.csv
run sweep two.nml --pendulum 1 --output /dev/null
expect_status 0

[ -n "$with_netcdf" ] || { echo 'no NetCDF in this build: no file tested'; finish; exit; }
fails 2 'probe.nc is there already' sweep "$plans/periods.nml" --output probe.nc
cp probe.nc before.nc
if command -v ncgen >/dev/null; then
   echo 'netcdf somebody { dimensions: n = 2 ; variables: int n(n) ; data: n = 1, 2 ; }' | ncgen -5 -o theirs.nc
   cp theirs.nc kept.nc
   fails 2 'theirs.nc is no file of kyvadlo sweep' sweep "$plans/periods.nml" --output theirs.nc --resume
   checks=$((checks + 1))
   cmp -s theirs.nc kept.nc || complain 'the file of somebody else must stay'
fi
run sweep "$plans/periods.nml" --output probe.nc --resume
expect_status 0
same before.nc probe.nc
fails 2 'of another plan' sweep "$plans/thrown.nml" --output probe.nc --resume
same before.nc probe.nc
run sweep two.nml --pendulum low --output low.nc
expect_status 0
run sweep two.nml --pendulum low --output low.nc --resume
expect_status 0
fails 2 'of another plan' sweep two.nml --pendulum 1 --output low.nc --resume
: >empty.nc
run sweep "$plans/periods.nml" --output empty.nc --resume
expect_status 0
same before.nc empty.nc
head -c 500 probe.nc >cut.nc
run sweep "$plans/periods.nml" --output cut.nc --resume
expect_status 0
same before.nc cut.nc
echo precious >other.nc
fails 2 'other.nc is no file of kyvadlo sweep' sweep "$plans/periods.nml" --output other.nc --resume

# Threads, parts, ranks. Enough points for a hundred chunks, values and reductions in one.
cat >plan.nml <<'END'
&pendulum length = 1 /
&axis name = 'z_upper', from = -0.5, to = 1, count = 300 /
&axis name = 'z_lower', from = -1, to = -0.3, count = 300 /
&measure quantities = 'T advance turning' /
&histogram quantity = 'T', from = 0.9, to = 2, count = 20 /
END
run sweep plan.nml --output one.nc --threads 1
expect_status 0
run sweep plan.nml --output three.nc --threads 3
same one.nc three.nc
for part in 1 2 3; do run sweep plan.nml --output "part$part.nc" --part "$part/3"; expect_status 0; done
run sweep plan.nml --merge part3.nc part1.nc part2.nc --output merged.nc
expect_status 0
same one.nc merged.nc
fails 2 'the parts lack' sweep plan.nml --merge part3.nc part1.nc --output short.nc
run sweep plan.nml --output part2.nc --resume
same one.nc part2.nc
if [ -n "$mpirun" ]; then
   run sweep "$plans/periods.nml"
   cp out alone.csv
   ranks 3 "$plans/periods.nml" >shared.csv 2>err
   same alone.csv shared.csv
   for n in 1 2 3 5 8 16; do
      command_line="mpirun -n $n kyvadlo sweep"
      ranks "$n" plan.nml --output "ranks$n.nc" >out 2>err
      same one.nc "ranks$n.nc"
   done
   # The counter over a network: sockets in place of shared memory (Open MPI's names).
   if "$mpirun" --version 2>/dev/null | grep -q 'Open MPI'; then
      command_line='mpirun --mca btl tcp,self --mca osc ^sm -n 3 kyvadlo sweep'
      OMPI_MCA_btl=tcp,self OMPI_MCA_osc=^sm ranks 3 plan.nml --output tcp.nc >out 2>err
      same one.nc tcp.nc
   fi
fi

# Ended early at twenty moments by one signal or another, and gone on with by other numbers of ranks.
# Starts by energy take a set-up each: long enough to be ended.
cat >wide.nml <<'END'
&pendulum length = 1 /
&axis name = 'energy', from = -9.5, to = 8, count = 800 /
&axis name = 'momentum', from = 0, to = 2, count = 800 /
&measure quantities = 'T advance turning' /
&histogram quantity = 'T', from = 0.9, to = 2, count = 20 /
END
run sweep wide.nml --output wide.nc
expect_status 0
kills=0
unfinished=0
patience=10
rm -f killed-$$.nc
while [ "$kills" -lt 20 ]; do
   kills=$((kills + 1))
   if [ -n "$mpirun" ]; then
      ranks $((kills % 3 + 1)) wide.nml --output killed-$$.nc --resume >out 2>err &
   else
      "$program" sweep wide.nml --output killed-$$.nc --threads $((kills % 3 + 1)) --resume >out 2>err &
   fi
   pid=$!
   sleep "0.$((kills * 37 % 80 + 10))"
   signal=$([ $((kills % 2)) -eq 0 ] && echo TERM || echo KILL)
   # The ranks of this run, each by its number; the file has a name that no other test has.
   for process in $(ps -e -o pid= -o args= | awk '/killed-'$$'\.nc/ && !/awk/ && !/mpirun/ { print $1 }'); do
      kill -"$signal" "$process" 2>/dev/null
      [ "$signal" = KILL ] || break
   done
   wait "$pid" 2>/dev/null
   if cmp -s wide.nc killed-$$.nc; then rm -f killed-$$.nc; else unfinished=$((unfinished + 1)); fi
done
run sweep wide.nml --output killed-$$.nc --resume
expect_status 0
same wide.nc killed-$$.nc
checks=$((checks + 1))
[ "$unfinished" -gt 0 ] || complain 'no run was ended early'

# Killed while the header is written: what is left is the empty file and the header beside it, and the next run goes over both.
: >begun.nc
head -c 300 wide.nc >begun.nc.kyvadlo-part
fails 2 'begun.nc is there already' sweep plan.nml --output begun.nc
run sweep plan.nml --output begun.nc --resume
expect_status 0
same one.nc begun.nc
checks=$((checks + 1))
[ ! -e begun.nc.kyvadlo-part ] || complain 'the header beside the file must be gone'

# Not computed yet is what the status of an unfinished file says, and a part has no values where it computed none.
if command -v ncdump >/dev/null; then
   cat >few.nml <<'END'
&pendulum length = 1 /
&axis name = 'z_upper', from = 0, to = 0.1, count = 2048 /
&axis name = 'z_lower', values = -0.9 /
&measure quantities = 'T' /
END
   run sweep few.nml --output few.nc --part 1/2
   expect_status 0
   checks=$((checks + 1))
   ncdump -v status few.nc | sed '1,/^ status =/d' | grep -o '[0-9]' | sort | uniq -c | tr -s ' ' >found
   printf ' 1024 0\n 1024 1\n' >expected
   cmp -s expected found || complain 'half of the points are open'
fi

# A second run on the file of a first; interrupted, it says how to go on; a disk without room.
cat >long.nml <<'END'
&pendulum length = 1 /
&axis name = 'z_upper', from = -0.5, to = 1, count = 300000 /
&axis name = 'z_lower', from = -1, to = -0.3, count = 300000 /
&measure quantities = 'T' /
&histogram quantity = 'T', from = 0.9, to = 2, count = 20 /
END
"$program" sweep long.nml --output long.nc 2>long.err &
pid=$!
i=0
while [ ! -f long.nc ] && [ "$i" -lt 100 ]; do i=$((i + 1)); sleep 0.1; done
fails 2 'another run of kyvadlo sweep writes it' sweep long.nml --output long.nc --resume
kill -TERM "$pid"
wait "$pid" 2>/dev/null
checks=$((checks + 1))
grep -q 'go on with: kyvadlo sweep long.nml --output long.nc --resume' long.err || complain "the words: $(cat long.err)"
# On a terminal: the line of progress, and Ctrl-C typed.
if script --version 2>/dev/null | grep -q util-linux; then
   { sleep 4; printf '\003'; sleep 1; } | script -qec "'$program' sweep long.nml --output typed.nc" shown >out 2>err
   for text in 'points/s, ' 'interrupted; what is done is kept: go on with: kyvadlo sweep long.nml --output typed.nc --resume'; do
      checks=$((checks + 1))
      grep -q "$text" shown || complain "on a terminal '$text' must be seen: $(tail -n 3 shown)"
   done
fi
# MPI itself does not start under a small ulimit -f: a disk of its own, where one may mount it.
mkdir small
if mount -t tmpfs -o size=64k none small 2>/dev/null; then
   run sweep plan.nml --output small/full.nc
   expect_status 2
   checks=$((checks + 1))
   grep -q 'cannot write small/full.nc' err || complain 'the full disk must be told'
   mount -o remount,size=64m small
   run sweep plan.nml --output small/full.nc --resume
   expect_status 0
   same one.nc small/full.nc
   umount small
fi
finish
