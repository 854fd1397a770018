# Names that would be commands of gnuplot, the shell or a spreadsheet, and good names that look dangerous.
# shellcheck disable=SC2154

attack 'names of pictures'
mkdir -p 'a folder' ./-folder
if [ $with_gnuplot = yes ]; then
   for picture in '<touch PWN;.svg' '|touch PWN;.svg' '|touch PWN;.png' '$x.svg' "it''s.svg" "it's.png" '`touch PWN`.svg' \
      '$(touch PWN).svg' '";system("touch PWN");".svg' "';system('touch PWN');'.svg" '@x.svg' '~.svg' '~root.svg' '-e.svg' \
      '-.svg' '--.png' '%d%s.svg' 'a#b.svg' 'a\b.svg' 'a\nb.svg' 'ě🙂.svg' '*.svg' '?.svg' ' .svg' 'a;b.svg' 'a folder/b c.png' \
      './-folder/x.svg' 'x.y.svg' '+.svg' '=1.svg'; do
      case $picture in -*) go simulate scene.nml "--plot=$picture" ;; *) go simulate scene.nml --plot "$picture" ;; esac
      want 'status 0' [ "$status" -eq 0 ]
      want 'a picture' [ -s "$picture" -o -s "./$picture" ]
      want 'no command may run' [ ! -e PWN ]
      # The script draws the same by itself.
      mv "./$picture" kept
      script=./${picture%.*}.gp
      (cd "$(dirname "$script")" && gnuplot -d "./$(basename "$script")") >/dev/null 2>err
      want 'the script draws the same' same kept "./$picture"
      want 'no command may run' [ ! -e PWN ]
   done
fi
feed='a
system("touch PWN")
.svg'
go simulate scene.nml --plot "$feed"
refused 'without control characters'
go simulate scene.nml --plot "$(printf '\033]2;x\007.svg')"
refused '\x1b]2;x\x07.svg'
go simulate scene.nml --plot "$(printf 'a\377.svg')"
refused 'UTF-8'
want 'no command may run' [ ! -e PWN ]
# Messages send no control characters to the terminal.
go simulate "$(printf 'no\033[31m\nsuch.nml')"
refused 'no\x1b[31m\nsuch.nml'
go "$(printf 'comm\033and')"
want 'no control character' eval '! grep -q "$(printf "\033")" err'

attack 'titles and fields'
for title in '`touch PWN`' '";system("touch PWN");"' '@PWN' '$x' 'a\nb' '_^{}&~' '=1+1' '-2+3' '@sum' '+1' 'a,b' 'a""b'; do
   printf '%s\n' "&pendulum name='$title', length=1, z_upper=0.3, z_lower=-0.8 /" '&output duration=2 samples=5 /' >titled.nml
   rm -f p.svg
   go simulate titled.nml --plot p.svg
   if [ $with_gnuplot = yes ]; then
      want 'status 0' [ "$status" -eq 0 ]
      want 'a picture' grep -q '</svg>' p.svg
   fi
   want 'no command may run' [ ! -e PWN ]
   go table titled.nml --data --format csv
   case $title in
   [=@]* | '-2+3') want 'a quoted field' grep -q -F "\"$title\"" out ;;
   '+1') want 'a number as it is' grep -q -E '(^|,)[+]1(,|$)' out ;;
   esac
done
printf '&pendulum name="a\014b", length=1, z_upper=0.3, z_lower=-0.8 /\n' >titled.nml
go simulate titled.nml --plot p.svg
want 'status 2' [ "$status" -eq 2 ]
printf '&pendulum name="a\377b", length=1, z_upper=0.3, z_lower=-0.8 /\n' >titled.nml
go simulate titled.nml --plot p.svg
want 'status 2' [ "$status" -eq 2 ]

attack 'what lies in the current folder or at home'
# Libraries of the current folder, a gnuplot that is set up strangely, a path of folders.
for library in libgomp.so.1 libgfortran.so.5 libgsl.so.27 libgslcblas.so.0 liblapack.so.3 libblas.so.3 libm.so.6 libc.so.6; do
   : >$library
done
go --version
want 'status 0' [ "$status" -eq 0 ]
rm -f ./*.so.*
printf 'system("touch PWN")\nset terminal dumb\n' >.gnuplot
for setting in HOME="$PWD" CDPATH=/:/tmp GNUTERM=dumb POSIXLY_CORRECT=1 IFS=x LC_ALL=xx_XX TMPDIR=/nowhere; do
   line="$setting kyvadlo simulate scene.nml --plot p.svg"
   rm -f p.svg
   env "$setting" timeout 20 "$program" simulate scene.nml --plot p.svg >out 2>err
   count $?
   if [ $with_gnuplot = yes ]; then want 'a picture' grep -q '</svg>' p.svg; fi
   want 'no command may run' [ ! -e PWN ]
done
for size in 16k 1 64b; do
   line="OMP_STACKSIZE=$size"
   OMP_STACKSIZE=$size timeout 20 "$program" simulate scene.nml >out 2>err
   count $?
   refused 'OMP_STACKSIZE'
done
