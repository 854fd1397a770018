#!/bin/sh
# What `kyvadlo fit` prints and writes: a published case, the fitted scene run by `simulate`, residuals, pictures, intervals, options.
#
#   report.sh KYVADLO FOLDER
set -u
kyvadlo=$1
cd "$2" || exit 1
examples=../../examples/fits
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
bad=0
complain() { echo "$*"; bad=$((bad + 1)); }

# same NAME FOUND EXPECTED TOLERANCE
same() { awk -v a="$2" -v b="$3" -v t="$4" 'BEGIN { d = a - b; exit !(a != "" && d <= t && -d <= t) }' || complain "$1 is '$2', not $3"; }
# value FILE PARAMETER COLUMN: of a result in csv
value() { awk -F, -v p="$2" -v c="$3" '$1 == p { print $c }' "$1"; }
# refused STATUS PATTERN ARGUMENT...
refused() {
   wanted=$1; pattern=$2; shift 2
   "$kyvadlo" fit "$@" >"$scratch/out" 2>"$scratch/error"
   status=$?
   [ "$status" = "$wanted" ] || complain "status $status, not $wanted: $*"
   grep -q -e "$pattern" "$scratch/error" || complain "'$pattern' is not in: $(cat "$scratch/error")"
}

# The case study "Pendulum" of lsqfit, with errors in t: published are g/l = 39.82(87), theta(0) = 1.595(32), chi2/dof 0.7 of 10, Q 0.73.
"$kyvadlo" fit published/pendulum.nml published/pendulum.csv --format csv --output "$scratch/pendulum" || complain "pendulum: status $?"
same 'g/l' "$(value "$scratch/pendulum" gravity 2)" 39.82 0.005
same 'sigma of g/l' "$(value "$scratch/pendulum" gravity 3)" 0.87 0.005
same 'theta(0)' "$(value "$scratch/pendulum" release_angle 2)" 91.39 0.03
same 'sigma of theta(0)' "$(value "$scratch/pendulum" release_angle 3)" 1.83 0.03
"$kyvadlo" fit published/pendulum.nml published/pendulum.csv --format json >"$scratch/pendulum.json" || complain "pendulum: status $?"
same chi2 "$(sed -n 's/.*"chi2": \([^,]*\),/\1/p' "$scratch/pendulum.json")" 7 0.5
grep -q '"dof": 10,' "$scratch/pendulum.json" || complain 'pendulum: not 10 degrees of freedom'
same Q "$(sed -n 's/.*"p_value": \([^,]*\),/\1/p' "$scratch/pendulum.json")" 0.73 0.006

# What does not depend on it is asked of the first ten seconds of the laboratory, integrated as they are.
head -n 101 $examples/laboratory.csv >"$scratch/short.csv"

# One pendulum of several, by name or number: as if the scene had it alone, also in the fitted scene.
{ echo "&pendulum name='other' length=3, release_angle=5, release_speed=0 /"; cat published/pendulum.nml; } >"$scratch/two.nml"
for name in lsqfit 2; do
   "$kyvadlo" fit "$scratch/two.nml" published/pendulum.csv --format csv --pendulum $name >"$scratch/chosen" || complain "--pendulum: status $?"
   cmp -s "$scratch/chosen" "$scratch/pendulum" || complain "--pendulum $name: $(head -n 2 "$scratch/chosen")"
done
"$kyvadlo" fit "$scratch/two.nml" published/pendulum.csv --pendulum lsqfit >"$scratch/chosen" || complain "--pendulum: status $?"
grep -c 'other' "$scratch/chosen" | grep -qx 0 || complain 'the fitted scene has the other pendulum'
for option in --output --residuals; do
   refused 2 "option $option: a fit is text; NetCDF (.nc) comes from simulate" published/pendulum.nml published/pendulum.csv $option "$scratch/f.nc"
done
refused 2 "option --pendulum: none is named 'x'; give another name, or a number from 1 to 2" "$scratch/two.nml" published/pendulum.csv --pendulum x
refused 2 'two.nml:3: a second &pendulum; choose it by --pendulum' "$scratch/two.nml" published/pendulum.csv

# Profile: of this case, which is near a parabola, the sigmas; and for a sure asymmetry, where chi2 has grown by 1 for real.
"$kyvadlo" fit published/pendulum.nml published/pendulum.csv --format csv --profile >"$scratch/profile" || complain "profile: status $?"
head -n 1 "$scratch/profile" | grep -qx 'parameter,value,sigma,least,most' || complain "profile: $(head -n 1 "$scratch/profile")"
same 'least g/l' "$(value "$scratch/profile" gravity 4)" 38.956 0.05
same 'most g/l' "$(value "$scratch/profile" gravity 5)" 40.688 0.05
"$kyvadlo" fit $examples/laboratory.nml "$scratch/short.csv" --format csv --profile --threads 2 >"$scratch/profile" || complain "profile: status $?"
free=$("$kyvadlo" fit $examples/laboratory.nml "$scratch/short.csv" --format json | sed -n 's/.*"chi2": \([^,]*\),/\1/p')
for end in 4 5; do
   held=$(value "$scratch/profile" linear $end)
   sed "s/linear = 0.1/linear = $held/; s/gravity linear/gravity/" $examples/laboratory.nml >"$scratch/held.nml"
   "$kyvadlo" fit "$scratch/held.nml" "$scratch/short.csv" --format json >"$scratch/held.json"
   same "chi2 at $held, less the least," "$(sed -n 's/.*"chi2": \([^,]*\),/\1/p' "$scratch/held.json" | awk -v f="$free" '{ print $1 - f }')" 1 0.001
done

# Bootstrap: about the sigmas for normal errors; the same by any number of threads, another by another seed.
echo "&pendulum length=1.2 gravity=9.81 z_upper=-0.4 z_lower=-1.1 / &output duration=12 samples=120 quantities='position' /" |
   "$kyvadlo" simulate - | awk -F, -v OFS=, 'function normal() { return 0.01*sqrt(-2*log(1 - rand()))*cos(6.283185307179586*rand()) }
      NR == 1 { srand(1); print "t,x,y,z"; next } { print $1, $2 + normal(), $3 + normal(), $4 + normal() }' >"$scratch/wide.csv"
echo "&pendulum / &fit free='length gravity position velocity' sigma=0.01 /" >"$scratch/wide.nml"
for threads in 1 2; do
   "$kyvadlo" fit "$scratch/wide.nml" "$scratch/wide.csv" --format csv --bootstrap 500 --threads $threads >"$scratch/bootstrap$threads" ||
      complain "bootstrap: status $?"
done
cmp "$scratch/bootstrap1" "$scratch/bootstrap2" || complain 'bootstrap depends on threads'
for parameter in gravity length velocity3; do
   sigma=$(value "$scratch/bootstrap1" $parameter 3)
   least=$(value "$scratch/bootstrap1" $parameter 4)
   most=$(value "$scratch/bootstrap1" $parameter 5)
   # Half the interval of 500 copies of 120 rows is the sigma of the covariance to 20 per cent.
   same "bootstrap of $parameter, in sigmas," "$(awk -v a="$least" -v b="$most" -v s="$sigma" 'BEGIN { print (b - a)/(2*s) }')" 1 0.2
done
"$kyvadlo" fit $examples/laboratory.nml "$scratch/short.csv" --bootstrap 20 --seed 7 >"$scratch/out" || complain "seed: status $?"
grep -q '68.27 % of 20 fits, seed 7' "$scratch/out" || complain "the seed is not said: $(cat "$scratch/out")"
"$kyvadlo" fit $examples/laboratory.nml "$scratch/short.csv" --bootstrap 20 --format json >"$scratch/json" || complain "bootstrap: status $?"
grep -q '"gravity": {"value": [^ ]*, "sigma": [^ ]*, "least": [^ ]*, "most": [^ ]*}' "$scratch/json" || complain 'no interval in JSON'
grep -q '"intervals": "bootstrap of the rows, 68.27 % of 20 fits, seed 1"' "$scratch/json" || complain 'intervals are not said in JSON'

# Next to a bound, a quadratic drag of none, intervals end at the bound, and beside it where they should.
start='length=1 gravity=9.81 release_angle=40 release_speed=0.5'
echo "&pendulum $start / &air linear=0.03 / &output duration=8 samples=100 quantities='position' /" |
   "$kyvadlo" simulate - | awk -F, -v OFS=, 'function normal() { return 0.003*sqrt(-2*log(1 - rand()))*cos(6.283185307179586*rand()) }
      NR == 1 { srand(2); print "t,x,y,z"; next } { print $1, $2 + normal(), $3 + normal(), $4 + normal() }' >"$scratch/drag.csv"
echo "&pendulum $start / &air linear=0.03 quadratic=0.001 / &fit free='linear quadratic' sigma=0.003 /" >"$scratch/drag.nml"
for intervals in --profile '--bootstrap 20'; do
   # shellcheck disable=SC2086    # an option and its value
   "$kyvadlo" fit "$scratch/drag.nml" "$scratch/drag.csv" $intervals >"$scratch/drag" || complain "bound: status $?"
   awk 'NF == 6 && $1 == "quadratic" { q = $4 >= 0 && $4 <= $2 && $5 >= $2 && $5 - $2 < 3*$3 }
      NF == 6 && $1 == "linear" { l = $4 < $2 && $5 > $2 && $5 - $4 < 2.5*$3 } END { exit !(q && l) }' "$scratch/drag" ||
      complain "bound, $intervals: $(cat "$scratch/drag")"
done
grep -q 'of 20 fits, seed 1$' "$scratch/drag" || complain 'bound: copies without a minimum'

# The fitted scene runs, whatever is free: names with quotation marks, position alone (the velocity is the scene's, at right angles to
# it), length alone (the bob stays on its sphere).
for free in 'gravity position velocity linear' position velocity length gravity; do
   printf "&pendulum name='Bob''s' length=0.79 gravity=9.8 position=0.51,0,-0.6 velocity=0.01,0,0.01 /\n&air linear=0.02 /\n" >"$scratch/scene.nml"
   printf "&output duration=2 samples=3 /\n&fit free='%s' units='degrees' /\n" "$free" >>"$scratch/scene.nml"
   "$kyvadlo" fit "$scratch/scene.nml" "$scratch/short.csv" >"$scratch/out" 2>"$scratch/error" || complain "$free: status $?: $(cat "$scratch/error")"
   sed -n '/^&pendulum/,$p' "$scratch/out" >"$scratch/fitted.nml"
   grep -q "name = 'Bob''s'" "$scratch/fitted.nml" || complain "$free: the name is lost"
   "$kyvadlo" simulate "$scratch/fitted.nml" --output "$scratch/samples" 2>"$scratch/error" || complain "$free: $(cat "$scratch/error")"
   [ "$(wc -l <"$scratch/samples")" = 4 ] || complain "$free: no three samples"
done
# What it prints is the model: simulated at the times of the data it is what the residuals say.
"$kyvadlo" fit $examples/foucault.nml $examples/foucault.csv --residuals "$scratch/residuals" >"$scratch/out" || complain "foucault: status $?"
sed -n '/^&pendulum/,$p' "$scratch/out" >"$scratch/fitted.nml"
echo "&output duration=1797 samples=600 quantities='position' /" >>"$scratch/fitted.nml"
"$kyvadlo" simulate "$scratch/fitted.nml" --output "$scratch/samples" || complain "foucault: fitted scene"
awk -F, 'FNR == 1 { next } FILENAME ~ /samples$/ { x[$1 + 0] = $2; y[$1 + 0] = $3; next }
   { seen++; model = $2 == "x" ? x[$1 + 0] : y[$1 + 0]; d = model - $4; r = $3 - $4 - $5; s = $5/0.005 - $6
     if (!(d < 1e-6 && d > -1e-6 && r < 1e-12 && r > -1e-12 && s < 1e-4 && s > -1e-4)) { if (!bad) print; bad = 1 } }
   END { exit bad || seen != 1200 }' "$scratch/samples" "$scratch/residuals" || complain 'residuals, model and fitted scene differ'
# Measured less model everywhere: one reading too high is positive in the file and among the outliers.
awk -F, -v OFS=, '$1 == 30 { $2 += 1 } { print }' $examples/foucault.csv >"$scratch/outlier.csv"
"$kyvadlo" fit $examples/foucault.nml "$scratch/outlier.csv" | grep -q '^outlier: x in row 11, t = 30.0000 s: 19[0-9] sigmas' ||
   complain 'the outlier is not said'
"$kyvadlo" fit $examples/foucault.nml "$scratch/outlier.csv" --format json --residuals "$scratch/residuals" >"$scratch/json" || complain "outlier: status $?"
grep -q '"outliers": .*"column": "x", "residual_in_sigmas": 1\.9[0-9]*e+02' "$scratch/json" || complain "outlier: $(grep outliers "$scratch/json")"
awk -F, '$1 == 30 && $2 == "x" { exit !($5 > 0.9 && $6 > 180) }' "$scratch/residuals" || complain 'the outlier is negative in the file'

# What is not told, and what of it is known: of angles the ratio of length and gravity, whatever the start; of a support that may yield
# both ways, the sums that make the periods (the data were made with 67 m and a stiff one).
sed 's/length = 0.8/length = 1/; s/gravity linear/length gravity linear/' $examples/laboratory.nml >"$scratch/valley.nml"
"$kyvadlo" fit "$scratch/valley.nml" $examples/laboratory.csv --format json >"$scratch/json" || complain "valley: status $?"
grep -q '"undetermined": \["length/gravity"\]' "$scratch/json" || complain "valley: $(grep undetermined "$scratch/json")"
ratio=$(sed -n 's|.*"known": "length/gravity = \([^ ]*\) +- .*|\1|p' "$scratch/json")
same 'length/gravity' "$ratio" 0.0815494 3e-5
sed "s/'length latitude/'extra_length_x extra_length_y length latitude/" $examples/foucault.nml >"$scratch/support.nml"
"$kyvadlo" fit "$scratch/support.nml" $examples/foucault.csv >"$scratch/out" || complain "support: status $?"
grep -q '^The data do not tell: extra_length_x/extra_length_y/length$' "$scratch/out" || complain "support: $(grep tell "$scratch/out")"
same 'length and extra length' "$(sed -n 's/^They tell: extra_length_x + length = \([^ ]*\) .*/\1/p' "$scratch/out")" 67 3e-4
grep -q '^They tell: extra_length_x - extra_length_y = ' "$scratch/out" || complain "support: $(grep tell "$scratch/out")"

# A wind upwards that is dragged along by linear*wind is gravity: both are unknown and both are named.
echo "&pendulum $start / &air linear=0.03 / &wind / &fit free='gravity wind.velocity' sigma=0.003 /" >"$scratch/wind.nml"
"$kyvadlo" fit "$scratch/wind.nml" "$scratch/drag.csv" >"$scratch/out" || complain "wind: status $?"
grep -q '^The data do not tell: gravity/wind.velocity$' "$scratch/out" || complain "wind: $(grep tell "$scratch/out")"
grep -q '^They tell: gravity - 0.03000\*wind.velocity(3) = 9.8' "$scratch/out" || complain "wind: $(grep tell "$scratch/out")"

# What a fit would do is said before it, on standard error.
"$kyvadlo" fit $examples/laboratory.nml $examples/laboratory.csv --explain >"$scratch/out" 2>"$scratch/error" || complain "explain: status $?"
for line in 'data:     angle t; 300 rows' 'unknowns: gravity, linear \[guess\], position, velocity: 4, which leave 296 degrees of freedom' 'path: *integrated' \
   'start: *[0-9]* guesses' 'cost: .* ms'; do
   grep -q "$line" "$scratch/error" || complain "explain does not say '$line': $(cat "$scratch/error")"
done

# A picture with its script and data, or the two where there is no gnuplot; axes with units.
"$kyvadlo" fit $examples/laboratory.nml $examples/laboratory.csv --plot "$scratch/picture.svg" --output "$scratch/out" 2>"$scratch/error"
status=$?
if command -v gnuplot >/dev/null; then
   [ "$status" = 0 ] || complain "plot: $(cat "$scratch/error")"
   for text in 't \[s\]' 'angle \[degrees\]' 'residual of angle \[sigmas\]' laboratory measured; do
      grep -q "$text" "$scratch/picture.svg" || complain "the picture does not say $text"
   done
fi
grep -q 'set ylabel "angle \[degrees\]"' "$scratch/picture.gp" || complain 'plot: no script'
[ "$(grep -c . "$scratch/picture.dat")" -gt 800 ] || complain 'plot: no data'
echo mine >"$scratch/other.gp"
refused 2 'did not write' $examples/laboratory.nml $examples/laboratory.csv --plot "$scratch/other.svg"
refused 2 '.svg or .png' $examples/laboratory.nml $examples/laboratory.csv --plot "$scratch/other.pdf"
refused 2 'are one file' $examples/laboratory.nml $examples/laboratory.csv --output $examples/laboratory.csv

# A prior is a value and its sigma.
sed "s/sigma = 0.3/sigma = 0.3 prior_gravity = 9.8/" $examples/laboratory.nml >"$scratch/half.nml"
refused 2 'prior_gravity and prior_sigma_gravity go together' "$scratch/half.nml" $examples/laboratory.csv
refused 2 'whole number, 20 to 1000000' $examples/laboratory.nml $examples/laboratory.csv --bootstrap 5
refused 2 'whole number, 20 to 1000000' $examples/laboratory.nml $examples/laboratory.csv --bootstrap many
refused 2 'choose one' $examples/laboratory.nml $examples/laboratory.csv --bootstrap 20 --profile
refused 2 'of --bootstrap' $examples/laboratory.nml $examples/laboratory.csv --seed 2
refused 2 'shares the work' $examples/laboratory.nml $examples/laboratory.csv --threads 2
refused 2 'text|csv|json' $examples/laboratory.nml $examples/laboratory.csv --format xml
refused 2 'needs the name of a file' $examples/laboratory.nml $examples/laboratory.csv --residuals ''
refused 2 'a scene and a table' $examples/laboratory.nml
refused 2 'cannot both be standard input' - -
exit $((bad > 0))
