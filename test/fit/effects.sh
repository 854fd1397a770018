#!/bin/sh
# Fits of what `simulate` shows of scenes with effects, with a little noise added: every number within 5 sigmas of the scene's.
#
#   effects.sh KYVADLO
set -u
kyvadlo=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
bad=0
complain() { echo "$*"; bad=$((bad + 1)); }

# data SCENE SAMPLES QUANTITIES AWK: a table, made by a program of awk from the columns of simulate; n() is noise of size 1.
data() {
   printf "$1 &output duration=$2 quantities='$3' /\n" | "$kyvadlo" simulate - >"$scratch/raw.csv" || complain "no data: $1"
   awk -F, 'function n() { k++; return 1.4142*sin(k*k*1.7 + 0.3*k) } '"$4" "$scratch/raw.csv" >"$scratch/data.csv"
}
# fit NAME SCENE NUMBER=VALUE...
fit() {
   name=$1
   printf "$2" >"$scratch/scene.nml"
   shift 2
   "$kyvadlo" fit "$scratch/scene.nml" "$scratch/data.csv" --format csv >"$scratch/out" 2>"$scratch/error" ||
      complain "$name: status $?: $(cat "$scratch/error")"
   for pair in "$@"; do
      awk -F, -v name="${pair%=*}" -v true="${pair#*=}" -v of="$name" '
         $1 == name { seen = 1; pull = ($2 - true)/$3; if (!(pull*pull < 25 && $3 > 0)) { print of ": " $0 ": " pull " sigmas off"; exit 1 } }
         END { if (!seen) { print of ": no " name; exit 1 } }' "$scratch/out" || bad=$((bad + 1))
   done
}

# A camera whose settings have bounds.
data '&pendulum length=1.2 position=0.576,0.432,-0.96 velocity=-0.6,0.8,0 /' '20 samples=401' 'position' \
   'NR == 1 { print "t,u,v"; next } { a = $2 + 0.3; b = $4 + 0.7; printf "%s,%.6f,%.6f\n", $1, 200*(a*cos(0.1) - b*sin(0.1)) + 0.2*n(), 200*(a*sin(0.1) + b*cos(0.1)) + 0.2*n() }'
fit 'camera' "&pendulum gravity=9.80665 /\n&camera view='xz' /\n&fit free='length position velocity scale angle offset' sigma=0.2 /\n" \
   length=1.2 scale=200 angle=5.729578 offset1=0.3
fit 'bounded camera' "&pendulum gravity=9.80665 /\n&camera view='xz' /\n&fit free='length position velocity scale angle offset' sigma=0.2 least_scale=20 most_scale=900 least_angle=-40 most_angle=30 /\n" \
   length=1.2 scale=200 angle=5.729578 offset1=0.3

# Swings over the top, with nothing known of the start: one angle wrapped, one counted on.
data '&pendulum length=0.5 gravity=9.79 position=0.05,0,-0.4974937 velocity=4.577,0,0.46 /' '12 samples=241' 'position' \
   'NR == 1 { print "t,angle"; next } { printf "%s,%.4f\n", $1, 57.29577951308232*atan2($2, -$4) + 0.5*n() }'
fit 'over the top' "&pendulum length=0.5 /\n&fit free='gravity position velocity' units='degrees' sigma=0.5 /\n" gravity=9.79 position1=0.05
data '&pendulum length=0.5 gravity=9.79 position=-0.14,0,-0.48 velocity=-6.72,0,1.96 /' '8 samples=161' 'position' \
   'NR == 1 { print "t,angle"; next } { a = 57.29577951308232*atan2($2, -$4); while (NR > 2 && a - b > 180) a -= 360; b = a
      printf "%s,%.4f\n", $1, a + 0.5*n() }'
fit 'angle counted on' "&pendulum length=0.5 /\n&fit free='gravity position velocity' units='degrees' sigma=0.5 /\n" gravity=9.79

# A photogate that missed one passage in four, its clock started earlier: a swing twice as fast has these passages too, and is not it.
data '&pendulum length=0.6 gravity=9.81 release_angle=25 / &air linear=0.01 /' '60 samples=60001' 'position' \
   'NR == 1 { print "crossing_time"; next } NR > 2 && x*$2 < 0 && ++i % 4 != 3 { printf "%.6f\n", 3.217 + $1 - $2*($1 - t)/($2 - x) + 2e-4*n() }
      { t = $1; x = $2 }'
fit 'missed passages' "&pendulum length=0.6 /\n&air /\n&fit free='gravity linear position velocity' sigma=2e-4 /\n" gravity=9.81 linear=0.01

# Events before t = 0: highest points of a swing of 30 degrees, whose period is 1.0174087975... small ones.
awk 'BEGIN { print "turning_time"; for (i = -5; i <= 6; i++) printf "%.9f\n", i*1.01740879759*3.14159265359*sqrt(0.5/9.81) + 1e-5*sin(i*i) }' >"$scratch/data.csv"
fit 'events before t = 0' "&pendulum length=0.5 release_angle=30 /\n&fit free='gravity' sigma=1e-5 /\n" gravity=9.81

# Forces act relative to the pivot and in resting axes; what is seen is not.
pivot="&moving_pivot amplitude=0.02,0,0.01 frequency=0.9,0,1.7 phase=30,0,0 /"
data "&pendulum length=1 release_angle=35 / $pivot" '20 samples=401' 'tension' \
   'NR == 1 { print "t,tension"; next } { printf "%s,%.6f\n", $1, $2 + 0.01*n() }'
fit 'tension with a moving pivot' "&pendulum length=1.01 release_angle=35 /\n&moving_pivot amplitude=0.021,0,0.011 frequency=0.9,0,1.7 phase=30,0,0 /\n&fit free='length gravity amplitude' sigma=0.01 /\n" \
   length=1 gravity=9.80665 amplitude1=0.02 amplitude3=0.01
data "&pendulum length=1 position=0.48,0.36,-0.8 velocity=-0.3,0.4,0 / &turning_frame rate=0.3 /" '20 samples=401' 'position tension' \
   'NR == 1 { print "t,x,tension"; next } { printf "%s,%.6f,%.6f\n", $1, $2 + 0.001*n(), $5 + 0.01*n() }'
fit 'tension from a turning frame' "&pendulum length=1.01 position=0.48,0.36,-0.8 velocity=-0.3,0.4,0 /\n&turning_frame rate=0.31 /\n&fit free='length gravity position velocity turning_frame.rate' sigma_x=0.001 sigma_tension=0.01 /\n" \
   length=1 gravity=9.80665 turning_frame.rate=0.3
data "&pendulum length=1 position=0.6,0,-0.8 velocity=0,0.02,0 / &turning_frame rate=0.3 /" '20 samples=401' 'plane' \
   'NR == 1 { print "t,plane"; next } { printf "%s,%.6f\n", $1, $2 + 0.001*n() }'
fit 'plane from a turning frame' "&pendulum length=1 position=0.6,0,-0.8 velocity=0,0.02,0 /\n&turning_frame rate=0.31 /\n&fit free='turning_frame.rate' sigma=0.001 /\n" turning_frame.rate=0.3

# Columns that show no position, alone: where the bob is follows from them too, but for what they do not see. `plane` is that of
# `simulate`, of wide ellipses too: the azimuth of the nearest highest point.
start='position=0.48,0.36,-0.8 velocity=-0.3,0.4,0'
data "&pendulum length=1 $start /" '20 samples=201' 'position' \
   'NR == 1 { print "t,azimuth"; next } { printf "%s,%.6f\n", $1, atan2($3, $2) + 0.01*n() }'
fit 'azimuth alone' "&pendulum length=1 /\n&fit free='gravity position velocity' sigma=0.01 /\n" \
   gravity=9.80665 position1=0.48 position2=0.36 velocity1=-0.3 velocity2=0.4
data "&pendulum length=1 $start /" '20 samples=201' 'tension' 'NR == 1 { print "t,tension"; next } { printf "%s,%.6f\n", $1, $2 + 0.01*n() }'
fit 'tension alone' "&pendulum length=1 /\n&fit free='gravity position velocity' sigma=0.01 /\n" gravity=9.80665 position3=-0.8
data "&pendulum length=1 $start /" '20 samples=201' 'plane' 'NR == 1 { print "t,plane"; next } { printf "%s,%.6f\n", $1, $2 + 0.01*n() }'
fit 'plane of a wide ellipse' "&pendulum length=1 $start /\n&fit free='gravity' sigma=0.01 /\n" gravity=9.80665
"$kyvadlo" fit "$scratch/scene.nml" "$scratch/data.csv" | grep -q '^chi2/dof = [12]..\.' || complain 'plane of a wide ellipse: chi2'
data '&pendulum length=1 position=0.3,0.1,-0.9486832980505138 velocity=0.02,-0.06,0 /' '20 samples=201' 'plane' \
   'NR == 1 { print "t,plane"; next } { printf "%s,%.6f\n", $1, $2 + 0.01*n() }'
printf "&pendulum length=1 /\n&fit free='position velocity' sigma=0.01 /\n" >"$scratch/scene.nml"
"$kyvadlo" fit "$scratch/scene.nml" "$scratch/data.csv" | grep -q '^chi2/dof = [12]..\.' || complain 'plane alone'

# Periods of given amplitudes need no start; the scene that is printed has one all the same.
printf 'period,amplitude\n2.00736,5\n2.01023,10\n2.01504,15\n2.02179,20\n' >"$scratch/data.csv"
fit 'periods' "&pendulum length=1 /\n&fit free='gravity' units='degrees' sigma=1e-3 /\n" gravity=9.80665
"$kyvadlo" fit "$scratch/scene.nml" "$scratch/data.csv" | sed -n '/^&pendulum/,$p' | "$kyvadlo" simulate - >"$scratch/out" ||
   complain 'periods: the fitted scene does not run'
exit $((bad > 0))
