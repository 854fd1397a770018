#!/bin/sh
# Fits stored synthetic sets (make_sets.py) from no guess, and compares with the truth: every number within 5.5 of its sigmas. What
# bad data and scenes are answered with.
#
#   sets.sh KYVADLO FOLDER
set -u
kyvadlo=$1
cd "$2" || exit 1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
bad=0
count=0
complain() { echo "$*"; bad=$((bad + 1)); }
for scene in sets/*.nml; do
   name=${scene%.nml}
   count=$((count + 1))
   "$kyvadlo" fit "$scene" "$name.csv" --format csv >"$scratch/out" || { complain "$name: status $?"; continue; }
   # A camera along y sees no difference between y and -y.
   awk -F, -v mirror="$(case $name in */5_*) echo 1 ;; esac)" '
      FILENAME ~ /truth$/ { truth[$1] = $2; n++; next }
      FNR > 1 && $1 in truth {
         seen++
         if ($3 == "" || !($3 > 0)) { print "no sigma of " $1; bad = 1; next }
         pull = ($2 - truth[$1])/$3; other = ($2 + truth[$1])/$3
         if (pull < 0) pull = -pull
         if (other < 0) other = -other
         if (mirror && $1 ~ /^(position|velocity)2$/ && other < pull) pull = other
         if (!(pull < 5.5)) { print $1 " is " pull " sigmas off"; bad = 1 }
      }
      END { if (seen != n) { print seen " of " n " numbers"; bad = 1 }; exit bad }' "$name.truth" "$scratch/out" || complain "$name"
done
[ "$count" -ge 15 ] || complain "only $count sets"

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
