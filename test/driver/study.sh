# The command study: options, the record of a quick run, its summary, and what it says of a scene.
. "$2/test/driver/expect.sh"

if ! has_quad; then
   fails 2 'study: this build has no quadruple precision, in which a study measures errors' study --quick
   finish
   exit
fi

fails 2 "option --seconds must be a number of seconds, got 'soon'" study --seconds soon
fails 2 "option --seconds must be a number of seconds, got '0'" study --seconds 0
fails 2 "option --seconds must be a number of seconds, got '1e9'" study --seconds 1e9
fails 2 "option --seconds must be a number of seconds, got 'nan'" study --seconds nan
fails 2 "unknown option '--fast'" study --fast
fails 2 'no/such/place' study --quick --output no/such/place
fails 2 'no_such_scene.nml' study --quick no_such_scene.nml
: >file
fails 2 'cannot make the folder file' study --quick --output file
echo "&pendulum length = 1, energy_above_top = 2, momentum = 0 /" >over.nml
fails 2 "must swing" study --quick over.nml
printf '&pendulum name = "twin", length = 1, z_upper = 0.3, z_lower = -0.8 /\n' >two.nml
cat two.nml two.nml >twins.nml
fails 2 "two pendulums are named 'twin of twins.nml'" study --quick two.nml twins.nml

# Everything once, quickly.
started=$(date +%s)
run study --quick --output record
expect_status 0
# A limit for a machine that does other things too; the command itself shall take under 20 s.
checks=$((checks + 1))
[ $(($(date +%s) - started)) -le 60 ] || complain 'a quick study takes longer than a minute'
has_gsl=yes
grep -q 'This build has no GSL' out && has_gsl=no
for title in 'Position at times within one period' 'Position at times within the 1000th period' 'Period; relative error' \
   'Turning heights from energy and momentum' 'Gaps between turning heights' 'Elliptic functions'; do
   expect_in_out "$title"
done
expect_match '^   1.E-15 .*closed_form'
expect_match '^  near_upright .*closed_form'
expect_match '^closed_form to a stated accuracy. Position at times within the 1000th period'
expect_match '^  1e-6 *[1-9].[0-9]E-0[789] .* x'
expect_match '^[0-9]* cells; [0-9]* capped.*; 0 failed'
checks=$((checks + 1))
grep -q -i -w nan out && complain 'no result is NaN'
for question in position position_1000 period roots gaps functions; do
   checks=$((checks + 1))
   [ -s record/study_$question.gp ] || complain "study_$question.gp is missing"
   if command -v gnuplot >/dev/null; then
      checks=$((checks + 2))
      grep -q '</svg>' record/study_$question.svg || complain "study_$question.svg is not whole"
      [ "$(head -c 4 record/study_$question.png | tail -c 3)" = PNG ] || complain "study_$question.png is no picture"
   fi
done
checks=$((checks + 1))
[ "$(find record -name '*.part*' | wc -l)" -eq 0 ] || complain 'unfinished files are left'

# The record: header, form of every line, every method for every orbit, falling errors.
cat >check.awk <<'RULES'
function complain(what) { print FILENAME ":" FNR ": " what; bad++ }
function number(x) { return x ~ /^[0-9]\.[0-9]+E[+-][0-9]+$/ }
BEGIN { FS = ","; floor["real64"] = 2e-15; floor["real128"] = 1e-32; floor["real32"] = 1e-6 }
/^#/ { if (seen_header) complain("comment behind the header"); next }
!seen_header {
   if ($0 != "question,orbit,method,setting,kind,error,ns_median,ns_low,ns_high,evaluations") complain("header: " $0)
   seen_header = 1
   next
}
{
   if (NF != 10) complain(NF " fields")
   for (i = 1; i <= 5; i++) if ($i == "") complain("empty field " i)
   if (number($6)) {
      for (i = 7; i <= 9; i++) if (!number($i)) complain("field " i " is no number: " $i)
      if (!($8 + 0 <= $7 + 0 && $7 + 0 <= $9 + 0)) complain("the median lies outside its quartiles")
      if (!($7 + 0 > 0)) complain("no time")
   } else {
      if ($6 != "capped" && $6 != "failed") complain("neither number nor outcome: " $6)
      for (i = 7; i <= 9; i++) if ($i != $6) complain("field " i " is not " $6)
   }
   if ($10 !~ /^[0-9]+$/) complain("evaluations: " $10)
   if ($5 != "real32" && $5 != "real64" && $5 != "real128") complain("kind: " $5)
   rows[$1 "," $3 "," $2]++
   orbits[$1 "," $2] = 1
   # The more terms, iterations or nodes the smaller the error, down to the last digits.
   if ($3 ~ /^(agm_terms|carlson_early|theta_terms|gauss_legendre)$/ && number($6)) {
      key = $1 "," $2 "," $3 "," $5
      split($4, setting, " ")
      if (key in last_error && setting[1] + 0 > last_setting[key] && $6 + 0 > 1.01*last_error[key] && $6 + 0 > floor[$5])
         complain("error does not fall: " $0)
      if (key in last_error && $6 + 0 < last_error[key]) falls[$3]++
      last_error[key] = $6 + 0
      last_setting[key] = setting[1] + 0
   }
   # Integrators: the smallest tolerance is better than the largest.
   if ($3 ~ /^gsl_(rk4|rkf45|rk8pd|msadams)$/ && $1 == "position" && number($6)) {
      key = $1 "," $2 "," $3 "," $4
      sub(/ [^ ]*$/, "", key)
      if (!(key in first_error)) first_error[key] = $6 + 0
      tightest[key] = $6 + 0
   }
}
END {
   questions = "position position_1000 period roots gaps functions"
   methods["position"] = "closed_form theta_terms jacobi_series carlson_point small_angle"
   methods["period"] = "closed_form agm_terms carlson_early series"
   methods["roots"] = "ours cardano"
   methods["functions"] = "ours"
   if (has_gsl == "yes") {
      methods["position"] = methods["position"] " gsl_rk4 gsl_rkf45 gsl_rk8pd gsl_msadams gsl_bsimp"
      methods["period"] = methods["period"] " gsl_ellint gauss_legendre gsl_qag"
      methods["roots"] = methods["roots"] " gsl_cubic lapack_dgeev"
      methods["functions"] = methods["functions"] " gsl_ellint"
   }
   methods["position_1000"] = methods["position"]
   methods["gaps"] = methods["roots"]
   count["position"] = count["position_1000"] = count["period"] = 7
   count["roots"] = count["gaps"] = 9
   count["functions"] = 26
   for (key in orbits) {
      split(key, part, ",")
      found[part[1]]++
      n = split(methods[part[1]], names, " ")
      if (n == 0) complain("unknown question " part[1])
      for (i = 1; i <= n; i++) if (!((part[1] "," names[i] "," part[2]) in rows)) complain("no " names[i] " for " key)
   }
   n = split(questions, names, " ")
   for (i = 1; i <= n; i++) if (found[names[i]] != count[names[i]]) complain(names[i] ": " found[names[i]] " orbits")
   if (!(falls["agm_terms"] >= 7 && falls["carlson_early"] >= 7 && falls["theta_terms"] >= 14)) complain("errors do not fall")
   if (has_gsl == "yes" && !(falls["gauss_legendre"] >= 7)) complain("errors of gauss_legendre do not fall")
   for (key in tightest) if (tightest[key] > first_error[key] && tightest[key] > 1e-10) complain("no better when tighter: " key)
   if (!seen_header) complain("no header")
   exit bad > 0
}
RULES
checks=$((checks + 1))
awk -v has_gsl=$has_gsl -f check.awk record/study.csv >complaints || { complain 'the record is not as it should be'; head -n 20 complaints; }
checks=$((checks + 1))
for word in kyvadlo '-std=' mpmath; do
   grep -q -e "^# .*$word" record/study.csv || complain "the comments of the record say nothing of $word"
done

# A closed form to a stated accuracy keeps it.
cat >kept.awk <<'RULES'
BEGIN { FS = "," }
$3 == "closed_form" && match($4, /1e-[0-9]+/) {
   rows[$1]++
   if (!($6 + 0 <= substr($4, RSTART, RLENGTH) + 0)) { print; bad++ }
}
END { exit bad > 0 || !(rows["position"] >= 7 && rows["position_1000"] >= 7 && rows["period"] >= 7) }
RULES
checks=$((checks + 1))
awk -f kept.awk record/study.csv || complain 'the record does not show that accuracies are kept'

# Pendulums of a scene: against our own quad precision, which the record says.
printf '&pendulum name = "wide, by far", length = 2, z_upper = 0.3, z_lower = -0.8 /\n' >own.nml
run study --quick --seconds 0.0005 own.nml --output own
expect_status 0
expect_match '^  wide, by far .*closed_form'
checks=$((checks + 1))
grep -q '^# Orbits of scenes: errors against our real128 path' own/study.csv || complain 'the record must name its reference'
checks=$((checks + 1))
grep -q mpmath own/study.csv && complain 'no reference of mpmath expected for a scene'
checks=$((checks + 1))
[ "$(grep -c '"wide, by far",closed_form,' own/study.csv)" -ge 9 ] || complain 'closed form of the scene expected in the record'
checks=$((checks + 1))
awk -F, '$4 == "closed_form" && $6 == "real64" && $5 !~ /1e-/ && !($7 + 0 < 1e-15)' own/study.csv | grep . && complain 'errors of the closed form'
checks=$((checks + 1))
awk -F, '$4 == "closed_form" && match($5, /1e-[0-9]+/) && !($7 + 0 <= substr($5, RSTART, RLENGTH) + 0)' own/study.csv | grep . &&
   complain 'an accuracy asked for is not kept'

# A conical pendulum has a double root, which rounding takes away: that its heights are not asked for is said.
echo '&pendulum name = "cone", length = 1, z_upper = -0.7, z_lower = -0.7 /' >cone.nml
run study --quick --seconds 0.0001 cone.nml
expect_status 0
expect_match '^  cone .*closed_form'
checks=$((checks + 1))
grep -q "not asked for turning heights of 'cone'" err || complain 'a question that is left out must be named'
# Its references are those of real128: that is not told as an error of nothing.
expect_match '^  1e-20 *is the reference '
checks=$((checks + 1))
! grep -q ' 0.0E+00 ' out || complain 'no error of nothing expected'

# Two scenes may name their pendulums alike. Without gnuplot there are no pictures, and one line says so.
printf '&pendulum length = 1, z_upper = 0.3, z_lower = -0.8 /\n' >unnamed.nml
cp unnamed.nml second.nml
mkdir tools
ln -s "$(command -v sh)" tools/sh
PATH=$PWD/tools "$program" study --quick --seconds 0.0001 unnamed.nml second.nml --output "it's" >out 2>err
status=$?
expect_status 0
expect_match '^  pendulum 1 of second.nml .*closed_form'
checks=$((checks + 3))
[ -s "it's/study_period.gp" ] || complain 'the scripts must be written without gnuplot too'
[ ! -e "it's/study_period.svg" ] || complain 'no picture without gnuplot expected'
[ "$(grep -c 'no gnuplot here' err)" -eq 1 ] || complain 'one line about gnuplot expected'

finish
