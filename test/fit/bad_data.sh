#!/bin/sh
# What bad data and scenes are answered with: one message, with file, line and rule; never an answer without a minimum.
#
#   bad_data.sh KYVADLO FOLDER
set -u
kyvadlo=$1
cd "$2" || exit 1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
bad=0
complain() { echo "$*"; bad=$((bad + 1)); }
# refused STATUS PATTERN SCENE DATA
refused() {
   printf "$3" >"$scratch/scene.nml"
   printf "$4" >"$scratch/data.csv"
   "$kyvadlo" fit "$scratch/scene.nml" "$scratch/data.csv" >"$scratch/out" 2>"$scratch/error"
   status=$?
   [ "$status" = "$1" ] || complain "status $status, not $1: $4"
   grep -q "$2" "$scratch/error" || complain "'$2' is not in: $(cat "$scratch/error")"
   [ "$1" != 2 ] || [ "$(wc -l <"$scratch/error")" = 1 ] || complain "more than one message: $(cat "$scratch/error")"
}
scene="&pendulum /\n&fit free='length gravity position velocity', sigma=0.01 /\n"
refused 2 "data.csv:3: x must be a finite number, got 'nan'" "$scene" 't,x,y\n0,1,0\n1,nan,0\n2,1,0\n'
refused 2 'at least two rows' "$scene" 't,x,y\n0,1,0\n'
refused 2 'data.csv:4: t must ascend' "$scene" 't,x,y\n0,1,0\n1,0,1\n1,1,1\n'
refused 2 'nothing moves' "$scene" 't,x,y\n0,1,0\n1,1,0\n2,1,0\n'
refused 2 'no degree of freedom' "$scene" 't,x\n0,1\n1,0\n2,1\n'
refused 2 'the column t is missing' "$scene" 'x,y\n0,1\n1,0\n2,1\n'
refused 2 'unknown column foo' "$scene" 't,foo\n0,1\n1,0\n2,1\n'
refused 2 'no &fit group' '&pendulum length=1, release_angle=3 /\n' 't,x\n0,1\n1,0\n2,1\n'
refused 2 'no setting is named lenth' "&pendulum /\n&fit free='lenth' /\n" 't,x\n0,1\n1,0\n2,1\n'
refused 2 'need a &camera group' "$scene" 't,u,v\n0,1,0\n1,0,1\n2,1,1\n3,1,4\n4,2,1\n'

refused 2 'data.csv:2: not a text file (byte 0)' "$scene" 't,x,y\n\0\1\n'
refused 2 'data.csv:3: x must be a finite number, got .inf' "$scene" 't,x,y\n0,1,0\n1,inf,0\n2,1,0\n'
refused 2 'data.csv:4: t must ascend' "$scene" 't,x,y\n0,1,0\n2,0,1\n1,1,1\n'
refused 2 'data.csv:3: t is missing beside a measured value' "$scene" 't,x,y\n0,1,0\n,0,1\n1,1,1\n'
refused 2 'data.csv:3: a row has 3 cells, as the header, got 2' "$scene" 't,x,y\n0,1,0\n1,0\n'
refused 2 'data.csv:1: column x given twice' "$scene" 't,x,x\n0,1,0\n1,0,1\n'
refused 2 'data.csv:1: sigma_x without x' "$scene" 't,y,sigma_x\n0,1,1\n1,2,1\n'
refused 2 'data.csv:2: sigma_x must be a finite number' "$scene" 't,x,sigma_x\n0,1,0\n1,2,1\n'
refused 2 'data.csv:1: column y is empty' "$scene" 't,x,y\n0,1,\n1,2,\n'
refused 2 'data.csv:3: period and amplitude must both be given, and positive' "$scene" 'period,amplitude\n2,0.1\n-2,0.2\n2.1,0.3\n'
refused 2 'data.csv:3: period and amplitude must both be given, and positive' "$scene" 'period,amplitude\n2,0.1\n2,\n2.1,0.3\n'
refused 2 'data.csv:3: amplitude must be below half a turn' "$scene" 'period,amplitude\n2,0.1\n2,10\n2.1,0.3\n2.1,0.3\n2.1,0.3\n2.1,0.3\n2.1,0.3\n'
refused 2 'prior_length and prior_sigma_length go together' "&pendulum /\n&fit free='length position velocity' prior_length=1 /\n" 't,x\n0,1\n1,0\n2,1\n'
refused 2 'prior_length and prior_sigma_length go together' "&pendulum /\n&fit free='length position velocity' prior_sigma_length=1 /\n" 't,x\n0,1\n1,0\n2,1\n'

refused 2 'scene.nml:1: &pendulum has no start' "&pendulum length=1 /\n&fit free='gravity' /\n" 't,x\n0,1\n1,0\n2,1\n'
refused 2 'scene.nml:1: &pendulum has no start' "&pendulum length=1 /\n&fit free='gravity' /\n" 't,x,period,amplitude\n0,1,2,0.1\n1,0,2,0.1\n2,1,2,0.2\n'

# What no pendulum makes has no minimum, however the bob may come to rest: no value, status 1.
for column in azimuth tension; do
   for sigma in '' sigma=0.01; do
      awk -v c=$column 'BEGIN { print "t," c; for (i = 0; i < 60; i++) printf "%.1f,%.4f\n", 0.1*i, 3*sin(1.1*i*i) }' >"$scratch/data.csv"
      printf "&pendulum length=1 /\n&fit free='position velocity' $sigma /\n" >"$scratch/scene.nml"
      "$kyvadlo" fit "$scratch/scene.nml" "$scratch/data.csv" --format json >"$scratch/out" 2>"$scratch/error"
      status=$?
      [ $status = 1 ] || complain "noise as $column, $sigma: status $status: $(cat "$scratch/error")"
      grep -q '"converged": false' "$scratch/out" || complain "noise as $column, $sigma: converged"
   done
done

# Units: a pendulum of a metre in millimetres is one of a kilometre. Rows further apart than half a period, of which aliases fit.
printf '&pendulum length=1 gravity=9.81 release_angle=25 /\n&output duration=60 samples=601 quantities="position" /\n' |
   "$kyvadlo" simulate - >"$scratch/swing.csv"
printf "&pendulum /\n&fit free='length gravity position velocity' /\n" >"$scratch/plain.nml"
awk -F, 'NR == 1 { print "t,x,y,z"; next } { printf "%s,%.7f,%.7f,%.7f\n", $1, 1e3*$2 + sin(NR*NR), 1e3*$3 + cos(NR*NR*1.7), 1e3*$4 + sin(NR*NR*2.3) }' "$scratch/swing.csv" >"$scratch/mm.csv"
"$kyvadlo" fit "$scratch/plain.nml" "$scratch/mm.csv" >"$scratch/out" 2>"$scratch/error" || complain "millimetres: status $?"
grep -q 'mm.csv:1: length fits at 999.9[0-9]* m: are the data in metres and seconds' "$scratch/error" || complain "millimetres: $(cat "$scratch/error")"
awk 'NR == 1 || (NR - 2) % 13 == 0 { print }' "$scratch/mm.csv" >"$scratch/sparse.csv"
"$kyvadlo" fit "$scratch/plain.nml" "$scratch/sparse.csv" >"$scratch/out" 2>"$scratch/error"
grep -q 'sparse.csv:1: rows at equal intervals, fewer than three a period,' "$scratch/error" || complain "sparse: $(cat "$scratch/error")"

# A start far before the data; `plane` alone, whose jumps a search does not find.
awk -F, 'NR == 1 { print "t,x,y,z"; next } { printf "%.1f,%s,%s,%s\n", $1 + 1e6, $2, $3, $4 }' "$scratch/swing.csv" >"$scratch/late.csv"
"$kyvadlo" fit "$scratch/plain.nml" "$scratch/late.csv" >"$scratch/out" 2>"$scratch/error"
status=$?
[ $status = 2 ] || complain "late: status $status"
grep -q 'late.csv:2: t begins at 1000000 s, and the data last 60.0 s: position and velocity are those at t = 0;' "$scratch/error" ||
   complain "late: $(cat "$scratch/error")"
printf '&pendulum length=1 position=0.8,0,-0.6 velocity=0,1.3,0 /\n&output duration=30 samples=301 quantities="plane" /\n' |
   "$kyvadlo" simulate - | awk -F, 'NR == 1 { print "t,plane"; next } { printf "%s,%.5f\n", $1, $2 + 0.01*sin(NR*NR) }' >"$scratch/plane.csv"
printf "&pendulum length=1 /\n&fit free='position velocity' sigma=0.01 /\n" >"$scratch/plane.nml"
"$kyvadlo" fit "$scratch/plane.nml" "$scratch/plane.csv" >"$scratch/out" 2>"$scratch/error"
status=$?
[ $status = 1 ] || complain "jumps of plane: status $status"
grep -q 'plane.csv:1: plane alone tells how fast the line of apsides turns' "$scratch/error" || complain "jumps: $(cat "$scratch/error")"

# Angles alone do not tell length from gravity, only their ratio: a valley is a minimum.
sed "s/length = 0.8/length = 1/; s/free = 'gravity/free = 'length gravity/" ../../examples/fits/laboratory.nml >"$scratch/valley.nml"
"$kyvadlo" fit "$scratch/valley.nml" ../../examples/fits/laboratory.csv --format json >"$scratch/out" || complain "valley: status $?"
grep -q '"converged": true' "$scratch/out" || complain 'valley: not converged'
grep -q '"gravity": {"value": [^ ]*, "sigma": null' "$scratch/out" || complain 'valley: sigma of gravity is not null'
grep -q 'length[^"]*/gravity' "$scratch/out" || complain 'valley: length/gravity is not undetermined'

# A drag far smaller than a search begins with is found, and not moved away from its bound.
printf '&pendulum length=1 release_angle=25 /\n&air linear=1e-5 /\n&output duration=300 samples=1501 quantities="position" /\n' |
   "$kyvadlo" simulate - | awk -F, 'NR == 1 { print "t,x,z"; next }
      { printf "%s,%.9f,%.9f\n", $1, $2 + 1e-5*sin(NR*NR), $4 + 1e-5*cos(NR*NR*1.7) }' >"$scratch/drag.csv"
printf '&pendulum length=1 /\n&air linear=1e-3 /\n&fit free="gravity linear position velocity" sigma=1e-5 /\n' >"$scratch/drag.nml"
"$kyvadlo" fit "$scratch/drag.nml" "$scratch/drag.csv" >"$scratch/out" || complain "small drag: status $?"
awk '$1 == "linear" { pull = ($2 - 1e-5)/$3; print pull; exit !(pull*pull < 25) }' "$scratch/out" || complain 'small drag'
exit $((bad > 0))
