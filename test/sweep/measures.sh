# What `kyvadlo sweep` draws and measures: random axes and clouds by their law, derivatives by quotients of differences, what samples
# show by those of `simulate`, edges by the set-up, --explain. $3: mpirun, or empty (not used).
. "$2/test/driver/expect.sh"

# holds WHAT AWK [FILE]...: the script, run over lines of CSV, must print nothing.
holds() {
   checks=$((checks + 1))
   command_line="kyvadlo sweep plan.nml: $1"
   awkward=$2; shift 2
   awk -F, "function near(x, y, rel,  d, s) { d = x - y; s = (y < 0 ? -y : y); return (d < 0 ? -d : d) <= rel*s && x != \"\" }
      $awkward" "${@:-out}" >found 2>&1
   [ ! -s found ] || complain "$(head -n 3 found)"
}
plan() { printf '%s\n' "$@" >plan.nml; }
sweep() { run sweep plan.nml; expect_status 0; }
with_netcdf=yes
"$program" sweep "$top/examples/sweeps/periods.nml" --output probe.nc 2>err || with_netcdf=
gaps='&pendulum length=1, upper_gap=0.7, lower_rise=0.2 /'

# The numbers of an axis: Philox4x32-10 with the seed's words and FNV-1a of the name as key, the index as counter (by Python
# integers), and mpmath's inverse of the normal distribution.
plan "$gaps" "&axis name='length', random='uniform', from=0, to=1, count=3, seed=7 /" "&measure quantities='T' /"
sweep
holds 'uniform' 'BEGIN { split("0.24203660359858536,0.03905814289534437,0.33801306381091656", w) }
   NR > 1 && !near($1, w[NR - 1], 1e-15) { print }'
plan '&pendulum length=1, position=0,0,-1, velocity=1,0,0 /' \
   "&axis name='velocity(2)', random='uniform', from=0, to=1, count=3, seed=1099511627779, together='c' /" \
   "&axis name='velocity(1)', random='normal', mean=0, deviation=1, count=3, seed=7, together='c' /" "&measure quantities='T' /"
sweep
holds 'a large seed, and normal' 'BEGIN { split("0.3023148441215636,0.49645213951730727,0.6588420669010221", w)
      split("1.0942301543746219257,0.37170792125932206908,-0.58398797035216993126", n) }
   NR > 1 && !(near($1, w[NR - 1], 1e-15) && near($2, n[NR - 1], 4e-16)) { print }'

# A cloud: means, and the triangular factor of the covariance times the numbers of the axes alone.
state='&pendulum length=1, position=0,0,-1, velocity=1,2,0 /'
cloud() {
   plan "$state" "&axis name='velocity(1)', random='normal', $1, count=4000, seed=3, together='cloud' /" \
      "&axis name='velocity(2)', random='normal', $2, count=4000, seed=4, together='cloud' /" "&measure quantities='k' /"
}
cloud 'mean=0, deviation=1' 'mean=0, deviation=1'
sweep
cp out alone
cloud 'covariance=4,1.2' 'covariance=1.2,0.45'
sweep
holds 'the factor' 'NR == FNR { a[FNR] = $1; b[FNR] = $2; next }
   FNR > 1 && !(near($1 - 1, 2*a[FNR], 1e-12) || ($1 - 1 - 2*a[FNR])^2 < 1e-30) { print }
   FNR > 1 && ($2 - 2 - (0.6*a[FNR] + 0.3*b[FNR]))^2 > 1e-30 { print }' alone out
holds 'mean and covariance, by four standard errors' 'NR > 1 { n++; x += $1; y += $2; xx += $1*$1; xy += $1*$2; yy += $2*$2 }
   END { x /= n; y /= n; e = 4/sqrt(n)
      if ((x - 1)^2 > (2*e)^2 || (y - 2)^2 > 0.45*e^2) print x, y
      if ((xx/n - x*x - 4)^2 > 2*(4*e)^2 || (yy/n - y*y - 0.45)^2 > 2*(0.45*e)^2) print "variance", xx/n - x*x, yy/n - y*y
      if ((xy/n - x*y - 1.2)^2 > (4*0.45 + 1.44)*e^2) print "covariance", xy/n - x*y }'
cloud 'covariance=4,1.2' 'covariance=1.3,0.45'
fails 2 'the covariance must be symmetric, and no variance negative' sweep plan.nml
cloud 'covariance=1,2' 'covariance=2,1'
fails 2 'the covariance must be symmetric, and no variance negative' sweep plan.nml
cloud 'covariance=1,0,0' 'covariance=0,1,0'
fails 2 'covariance takes the variance, or a number for each of the 2 normal axes together' sweep plan.nml

# Derivatives are those of T and advance themselves.
slopes() {   # START AXIS VALUE NAME
   plan "&pendulum $1 /" "&axis name='$2', values=$(awk "BEGIN { printf \"%.17g, %.17g, %.17g\", $3*(1 - 1e-5), $3, $3*(1 + 1e-5) }") /" \
      "&measure quantities='T advance dT_d$4 dadvance_d$4' /"
   sweep
   holds "derivatives by $4" 'NR > 1 { x[NR] = $1; t[NR] = $2; a[NR] = $3; s[NR] = $4; r[NR] = $5 }
      END { h = x[4] - x[2]; if (!(near(s[3], (t[4] - t[2])/h, 2e-6) || (t[4] - t[2])^2 < 1e-24)) print "T", s[3], (t[4] - t[2])/h
         if (!(near(r[3], (a[4] - a[2])/h, 2e-6) || (a[4] - a[2])^2 < 1e-24)) print "advance", r[3], (a[4] - a[2])/h }'
}
slopes 'length=1.1, z_upper=0.3, z_lower=-0.8' length 1.1 length
slopes 'length=1.1, z_upper=0.3, z_lower=-0.8' gravity 9.8 gravity
slopes 'length=1.1, z_upper=0.3, z_lower=-0.8' z_upper 0.3 z_upper
slopes 'length=1, upper_gap=0.7, lower_rise=0.2' lower_rise 0.2 lower_rise
slopes 'length=1, upper_rise=1.3, lower_rise=0.2' upper_rise 1.3 upper_rise
slopes 'length=1, energy=1.5, momentum=0.7' energy 1.5 energy
slopes 'length=1, energy=1.5, momentum=0.7' momentum 0.7 momentum
slopes 'length=1, release_angle=100, release_speed=0.7' release_angle 100 release_angle
slopes 'length=1, position=0.6,0,-0.8, velocity=0.3,1,0.225' 'velocity(2)' 1 velocity_2
slopes 'length=1, position=0.6,0,-0.8, velocity=0.3,1,0.225' length 1 length
plan '&pendulum length=1, energy_above_top=1, momentum=1 /' "&axis name='length', values=1 /" "&measure quantities='dT_dmomentum' /"
fails 2 "unknown word 'dT_dmomentum'" sweep plan.nml

# T alone over the gaps goes by another way than T with k: the same values and the same edges, in CSV and in histograms.
for order in 'upper_gap lower_rise' 'lower_rise upper_gap'; do
   set -- $order
   axes="&axis name='$1', from=0, to=2, count=41 / &axis name='$2', values=-0.1, 0, 1e-300, 1e-17, 1e-9, 0.05, 0.3, 0.35, 0.9, 0.95, 1, 1.05, 2, 2.1 /"
   plan "$gaps" "$axes" "&measure quantities='T' /"
   sweep
   cut -d, -f 3- out | sed 's/,/ /' >fast
   plan "$gaps" "$axes" "&measure quantities='T k' /"
   sweep
   awk -F, '{ print $3 " " $5 }' out >slow
   checks=$((checks + 1))
   awk 'NR == FNR { a[FNR] = $1; s[FNR] = $2; next }
      FNR > 1 && !(s[FNR] == $2 && (a[FNR] - $1)^2 <= (2e-15*$1)^2) { print FNR, a[FNR], s[FNR], $0 }' fast slow >found
   [ ! -s found ] || complain "T alone, and beside k: $(head -n 3 found)"
done

# What samples show, by those of `simulate`.
cp "$top/examples/scenes/slack_string.nml" scene.nml
run simulate scene.nml
expect_status 0
grep -v '^#' out >samples.csv
{ cat scene.nml; printf '%s\n' "&axis name='velocity(2)', values=1.2 /" "&measure crossing='z', level=0.25,
   quantities='first_x last_y least_z greatest_tension crossing_time slack_time contacts energy_lost last_energy' /"; } >plan.nml
sweep
cp out swept
holds 'samples' 'NR == FNR { if (FNR == 1) { for (i = 1; i <= NF; i++) c[$i] = i; next }
      if (FNR == 2) { x = $c["x"]; e = $c["energy"] }
      y = $c["y"]; z = $c["z"]; last = $c["energy"]
      if (low == "" || z < low) low = z
      if ($c["tension"] != "" && (top == "" || $c["tension"] > top)) top = $c["tension"]
      if (FNR > 2 && when == "" && (before - 0.25)*(z - 0.25) <= 0) when = t + ($1 - t)*(before - 0.25)/(before - z)
      before = z; t = $1; next }
   FNR == 2 && !(near($2, x, 1e-12) && near($3, y, 1e-12) && near($4, low, 1e-12) && near($5, top, 1e-12)) { print; print x, y, low, top }
   FNR == 2 && !near($6, when, 1e-12) { print "crossing", $6, when }
   FNR == 2 && !(near($9, e - last, 1e-9) && near($10, last, 1e-12) && $8 > 2 && $7 >= 0 && $7 < 0.01) { print; print e - last, last }' \
   samples.csv swept

# The azimuth of a conical pendulum grows evenly: the level is reached when the law says.
plan '&pendulum length=1, z_upper=-0.5, z_lower=-0.5 /' '&output duration=3, samples=7 /' "&axis name='gravity', values=9.80665 /" \
   "&measure quantities='crossing_time greatest_z', crossing='azimuth', level=1 /"
sweep
holds 'crossing_time' 'NR == 2 && !near($2, 1/sqrt(9.80665/0.5), 1e-12) { print $2, 1/sqrt(9.80665/0.5) }'

# Before the run.
plan "$gaps" "&axis name='lower_rise', from=0.1, to=0.6, count=50, together='both' /" \
   "&axis name='upper_gap', from=0.7, to=1, count=50, together='both' /" "&axis name='length', values=2,3 /" "&measure quantities='T k' /"
run sweep plan.nml --explain
expect_status 0
for text in 'dimension: both, 50' 'dimension: length, 2' 'points:   100 in 1 chunks' 'size:     about ' 'cost:     about '; do
   checks=$((checks + 1))
   grep -q -F "$text" err || complain "--explain must say: $text"
done

# Memory is that of a chunk, whatever the sweep: a part of 10**12 points, and of 10**9 scenes of a cloud, take little more than ten
# points do. (A sanitizer keeps what was freed.)
case $("$program" --version) in *fsanitize*) is_sanitized=yes ;; *) is_sanitized= ;; esac
if [ -n "$with_netcdf" ] && [ -z "$is_sanitized" ] && command -v python3 >/dev/null; then
   memory() {
      python3 -c 'import resource, subprocess, sys
subprocess.run(sys.argv[1:], check=True, stderr=subprocess.DEVNULL)
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)' "$program" sweep "$@" --threads 1
   }
   plan "$gaps" "&axis name='lower_rise', from=0.1, to=0.6, count=10 /" "&measure quantities='T' /"
   small=$(memory plan.nml --output small.nc)
   plan "$gaps" "&axis name='upper_gap', from=0, to=1, count=1000000 /" "&axis name='lower_rise', from=0, to=1, count=1000000 /" \
      "&measure quantities='T' /" "&histogram quantity='T', from=0, to=2, count=10 /"
   large=$(memory plan.nml --output large.nc --part 1/300000)
   plan "$state" "&axis name='velocity(1)', random='normal', deviation=1, count=1000000000 /" \
      "&output duration=0.01, samples=2 /" "&measure quantities='greatest_z' /" "&histogram quantity='greatest_z', from=-1, to=1, count=9 /"
   cloud=$(memory plan.nml --output cloud.nc --part 1/1000000)
   for kilobytes in "$large" "$cloud"; do
      checks=$((checks + 1))
      [ "$kilobytes" -lt $((small + 30000)) ] || complain "$kilobytes KB, of ten points $small"
   done
fi
finish
