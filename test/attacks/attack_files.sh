# Files of one run against each other and against what is there already.
# shellcheck disable=SC2154

attack 'outputs that would destroy an input'
cp scene.nml before
ln scene.nml hard.nml
ln -s scene.nml soft.nml
mkdir sub
for output in scene.nml ./scene.nml sub/../scene.nml hard.nml soft.nml "$PWD/scene.nml"; do
   for command in simulate table; do
      go $command scene.nml --output "$output"
      refused 'are one file'
   done
   go simulate scene.nml --events "$output"
   refused 'are one file'
   want 'the scene as it was' same scene.nml before
done
cp scene.nml in
go simulate - --output in
refused 'are one file'
want 'the scene as it was' same in before
rm in
for pair in '--output a.csv --events a.csv' '--output a.csv --events ./a.csv' '--output a.gp --plot a.svg' \
   '--output a.dat --plot a.svg' '--events a.dat --plot a.svg' '--output a.svg --plot a.svg' '--events a.gp --plot a.png'; do
   # shellcheck disable=SC2086
   go simulate scene.nml $pair
   refused 'are one file'
   want 'nothing written' [ ! -e a.csv -a ! -e a.gp -a ! -e a.dat -a ! -e a.svg ]
done
ln -s nothing_yet.csv one.csv
ln -s nothing_yet.csv other.csv
go simulate scene.nml --output one.csv --events other.csv
refused 'are one file'
line='simulate scene.nml --events log >>log'
timeout 20 "$program" simulate scene.nml --events log >>log 2>err
count $?
refused 'are one file'
go simulate scene.nml --output /dev/null --events /dev/null
want 'a device is shared without harm' [ "$status" -eq 0 ]
if [ $with_gsl = yes ]; then
   printf '0 0 0 0\n1 0.1 0 0\n3 0 0 0\n' >crane.dat
   cp crane.dat table.before
   printf '%s\n' '&pendulum length=1, z_upper=0.3, z_lower=-0.8 / &output duration=2 samples=3 /' \
      "&moving_pivot table='crane.dat' /" >crane.nml
   go simulate crane.nml --output crane.dat
   refused 'are one file'
   go simulate crane.nml --plot crane.svg
   want 'status 2' [ "$status" -eq 2 ]
   want 'the table as it was' same crane.dat table.before
fi

attack "files of others"
for ending in dat gp; do
   echo 'measured by hand' >exp.$ending
   go simulate scene.nml --plot exp.svg
   refused 'which kyvadlo did not write'
   want 'as it was' grep -q '^measured by hand$' exp.$ending
   : >exp.$ending
   go simulate scene.nml --plot exp.svg
   refused 'which kyvadlo did not write'
   rm exp.$ending
done
go simulate scene.nml --plot exp.svg
go simulate scene.nml --plot exp.svg
[ $with_gnuplot = no ] || want 'our own are replaced' [ "$status" -eq 0 ]
mkdir study
for file in study.csv study_period.gp; do
   echo 'measured by hand' >study/$file
   go study --quick --seconds 0.0001 scene.nml --output study
   refused 'which kyvadlo did not write'
   want 'as it was' grep -q '^measured by hand$' study/$file
   rm study/$file
done
# A name that could be guessed, waiting as a link.
echo precious >victim
for guess in .part.study_gaps.svg study/.part.study_gaps.svg "out.csv.part$$"; do ln -s "$PWD/victim" "$guess"; done
go simulate scene.nml --output out.csv
want 'the victim as it was' grep -q '^precious$' victim

attack 'what an old file keeps'
echo old >old.csv
chmod 640 old.csv
go simulate scene.nml --output old.csv
want 'its mode' [ "$(stat -c %a old.csv)" = 640 ]
ln old.csv twin.csv
go simulate scene.nml --output old.csv
want 'its other name' [ old.csv -ef twin.csv ]
want 'the new content' grep -q '^t,x' twin.csv
ln -s old.csv link.csv
go simulate scene.nml --output link.csv
want 'the link' [ -L link.csv ]
ln -s later.csv dangling.csv
go simulate scene.nml --output dangling.csv
want 'the link' [ -L dangling.csv ]
want 'the file behind it' [ -f later.csv ]
ln -s loop.csv loop.csv
go simulate scene.nml --output loop.csv
refused 'cannot write loop.csv'
long=$(printf '%0251d' 0)
go simulate scene.nml --output "$long.csv"
want 'a name of 255 bytes' [ -s "$long.csv" ]
go simulate scene.nml --output "x$long.csv"
refused 'cannot write'
go table --output result.nc
refused '.nc'
want 'nothing written' [ ! -e result.nc ]
want 'no unfinished file' no_part
if [ "$(id -u)" -eq 0 ] && command -v setpriv >/dev/null; then
   # As a user without rights: folders that are not writable, sticky ones, files of others.
   chmod 755 "$scratch" "$folder"
   cp "$program" ./kyvadlo
   chmod 755 kyvadlo
   user='setpriv --reuid=65534 --regid=65534 --clear-groups'
   mkdir closed sticky
   echo old >closed/mine.csv
   chown 65534:65534 closed/mine.csv
   echo old >closed/theirs.csv
   chmod 755 closed
   chmod 1777 sticky
   echo old >sticky/theirs.csv
   chmod 666 sticky/theirs.csv
   echo old >sticky/locked.csv
   for target in closed/mine.csv sticky/theirs.csv; do
      line="simulate --output $target, without rights"
      $user timeout 20 ./kyvadlo simulate scene.nml --output $target >out 2>err
      count $?
      case $target in
      closed/*) want 'a writable file in a closed folder is written' grep -q '^t,x' $target ;;
      # Some systems protect such files from the writer too: then it is said, and the file stays.
      *) want 'written, or refused before the run' grep -q -e '^t,x' -e '^old' $target ;;
      esac
   done
   for target in closed/theirs.csv sticky/locked.csv closed/new.csv; do
      line="simulate --output $target, without rights"
      $user timeout 20 ./kyvadlo simulate endless.nml --output $target >out 2>err
      count $?
      refused "cannot write $target"
   done
fi

attack 'full disks and closed pipes'
for arguments in '--help' '--version' 'table --help' '--manual-page' '--completion' table 'table --divisions 100000000' 'eval --list' \
   'eval K 0.5' eval 'simulate scene.nml' 'simulate endless.nml' 'simulate endless.nml --events e.csv' \
   'table --upper -0.9:0.9:1000 --lower -1:0:1000' 'study --quick --seconds 0.0001 scene.nml'; do
   line="$arguments >/dev/full"
   # shellcheck disable=SC2086
   yes 'K 0.5' | head -n 100000 | timeout 20 "$program" $arguments >/dev/full 2>err
   count $?
   refused 'cannot write to standard output'
   line="$arguments >&-"
   # shellcheck disable=SC2086
   yes 'K 0.5' | head -n 100000 | timeout 20 "$program" $arguments >&- 2>err
   count $?
   refused 'cannot write to standard output'
   line="$arguments | head"
   # shellcheck disable=SC2086
   { timeout 20 "$program" $arguments </dev/null 2>err; echo $? >status; } | head -n 1 >out
   [ "$(cat status)" -ne 124 ] || count 124
   want 'a closed pipe ends quietly' [ ! -s err ]
done
want 'no unfinished file' no_part
go simulate endless.nml --output /dev/full
refused 'cannot write /dev/full'
echo old >limited.csv
sed 's/1e6, samples=100000000/100, samples=9999/' endless.nml >dense.nml
for arguments in 'simulate endless.nml --output limited.csv' 'table --divisions 100000 --output limited.csv' \
   'simulate dense.nml --output /dev/null --plot limited.svg'; do
   line="ulimit -f 100; $arguments"
   # shellcheck disable=SC2086
   (ulimit -f 100; exec timeout 20 "$program" $arguments >out 2>err)
   count $?
   case $arguments in *plot*) ;; *) refused 'File too large' ;; esac
   want 'the old file' grep -q '^old$' limited.csv
   want 'no unfinished file' no_part
done

attack 'gnuplot that fails'
mkdir tools
for how in 'exit 1' 'exit 0' 'printf "<svg"; exit 0' 'cat /dev/zero | head -c 5000; exit 0' 'kill -9 $$' 'exit 127'; do
   printf '#!/bin/sh\n%s\n' "$how" >tools/gnuplot
   chmod +x tools/gnuplot
   for picture in p.svg p.png; do
      echo 'old picture' >$picture
      line="simulate --plot $picture with gnuplot that does: $how"
      PATH=$PWD/tools:$PATH timeout 20 "$program" simulate scene.nml --plot $picture >out 2>err
      count $?
      refused 'gnuplot could not draw'
      want 'the old picture' grep -q '^old picture$' $picture
      want 'no unfinished file' no_part
   done
done
line='study with gnuplot that draws a stump'
printf '#!/bin/sh\nprintf "<svg"\n' >tools/gnuplot
mkdir record
echo 'old picture' >record/study_period.svg
PATH=$PWD/tools:$PATH timeout 60 "$program" study --quick --seconds 0.0001 scene.nml --output record >out 2>err
count $?
refused 'gnuplot could not draw'
want 'the old picture' grep -q '^old picture$' record/study_period.svg
want 'what was measured' grep -q 'closed_form' out
want 'no unfinished file' no_part
line='simulate --plot without gnuplot'
PATH=/nowhere "$program" simulate scene.nml --plot q.svg >out 2>err
count $?
refused 'there is no gnuplot'
want 'script and data' [ -s q.gp -a -s q.dat -a ! -e q.svg ]
printf '#!/bin/sh\nsleep 1000\n' >tools/gnuplot
line='TERM while gnuplot runs'
PATH=$PWD/tools:$PATH "$program" simulate scene.nml --plot r.svg >out 2>err &
victim=$!
sleep 1
kill -TERM $victim
wait $victim
status=$?
inputs=$((inputs + 1))
want 'ended by the signal' [ "$status" -eq 143 ]
want 'gnuplot ended' eval '! pgrep -P 1 -f "$folder/tools/gnuplot"'
want 'no unfinished file' no_part
