# Commands, options, help, version: exit status and messages.
. "$2/test/driver/expect.sh"

fails 2 'no command' 
fails 2 "unknown command 'tabel'; the commands are table, simulate, eval, sweep, fit, study, help, examples" tabel
fails 2 "unknown command ''" ''
fails 2 "unknown option '--frobnicate'" --frobnicate
fails 2 "unknown option '--frobnicate'" eval --frobnicate
fails 2 "unknown option '--divisions'" eval --divisions 3
fails 2 'option --kind needs a value: single|double|quad' eval K 0.5 --kind
fails 2 "option --kind must be one of single|double|quad, got 'half'" eval --kind half K 0.5
fails 2 "option --kind must be one of single|double|quad, got 'single|double'" eval '--kind=single|double' K 0.5
fails 2 "option --kind must be one of single|double|quad, got ''" eval --kind= K 0.5
fails 2 'option --kind given twice' eval --kind double --kind double K 0.5
fails 2 'option --list takes no value' eval --list=3

for word in --help -h; do
   run $word
   expect_status 0
   expect_in_out 'Usage: kyvadlo COMMAND'
   expect_in_out 'kyvadlo eval K 0.5'
done
for command in table eval study; do
   run $command --help
   expect_status 0
   expect_in_out "Usage: kyvadlo $command"
   expect_in_out 'Examples:'
   [ $command = study ] || expect_in_out '--kind single|double|quad'
done
run --version
expect_status 0
expect_in_out 'kyvadlo '
expect_in_out 'Licence: MIT'
fails 2 'takes no value' --version=3

# The examples of the help run (the one that measures, and the one that needs a file of requests, left out).
run --help
grep '^  kyvadlo ' out | grep -v -e study -e '<' >examples
has_quad || sed -i '/quad/d' examples
checks=$((checks + 1))
[ "$(wc -l <examples)" -ge 4 ] || complain 'at least four examples expected'
while read -r line; do
   command_line=$line
   (cd "$top" && PATH=$(dirname "$program"):$PATH sh -c "$line") >out 2>err
   status=$?
   expect_status 0
done <examples

# The manual page and the completion come from the same tables as the help.
run --manual-page
expect_status 0
expect_in_out '.TH KYVADLO 1'
expect_in_out '\fB\-\-divisions\fR \fIN\fR'
expect_in_out '\fBpassage_azimuth\fR'
if command -v groff >/dev/null; then
   checks=$((checks + 1))
   groff -man -Tascii -ww out >page 2>warnings
   [ ! -s warnings ] || { complain 'groff must have nothing to say'; cat warnings; }
fi
fails 2 "unknown option '--manual-page'" eval --manual-page
run --scene-page
expect_status 0
expect_in_out '.TH KYVADLO-SCENE 5'
expect_in_out '.B density_ratio, must be given'
if command -v groff >/dev/null; then
   checks=$((checks + 1))
   groff -man -Tascii -ww out >page 2>warnings
   [ ! -s warnings ] || { complain 'groff must have nothing to say about scenes'; cat warnings; }
fi

# Offline, every name of a scene is explained, and every quantity.
for topic in scenes effects output fit sweep; do run help $topic; expect_status 0; cat out; done >topics
run simulate --list
sed -n 's/^| `\([a-z_]*\).*/\1/p' out | sort -u >names
checks=$((checks + 1))
[ "$(wc -l <names)" -gt 30 ] || complain 'names of settings expected'
while read -r name; do
   checks=$((checks + 1))
   grep -q "^  $name\b" topics || complain "kyvadlo help must explain $name"
done <names
# A newcomer sees every group with a line of its own.
run simulate --list
sed -n 's/^| name of `&\([a-z_]*\)`.*/\1/p' out | grep -v -e pendulum >groups
run help scenes
while read -r name; do
   checks=$((checks + 1))
   grep -q "^  &$name  *[a-z]" out || complain "kyvadlo help scenes must list &$name"
done <groups
checks=$((checks + 1))
[ "$(wc -l <groups)" -ge 14 ] || complain 'groups expected'
run help
expect_in_out 'effects   what else may act'
run help eval
expect_in_out 'Usage: kyvadlo eval'
fails 2 "unknown topic 'weather'; the topics are scenes, effects, output, fit, " help weather
fails 2 'help takes one TOPIC' help scenes effects

# The example scenes: listed, copied byte for byte, and no file is overwritten.
run examples
for scene in "$top"/examples/scenes/* "$top"/examples/fits/* "$top"/examples/sweeps/*; do
   name=${scene#"$top"/examples/}
   name=${name#scenes/}
   run examples
   expect_in_out "$name "
   run examples "$name" -
   expect_status 0
   checks=$((checks + 1))
   cmp out "$scene" || complain "$name must come out as it is"
done
run examples foucault mine.nml
expect_status 0
run table mine.nml
expect_in_out 'Foucault'
fails 2 'mine.nml is there already' examples foucault mine.nml
# With the tables that it reads.
mkdir cranes
run examples hoisting_crane cranes/mine.nml
expect_status 0
checks=$((checks + 1))
cmp cranes/crane_trolley.txt "$top/examples/scenes/crane_trolley.txt" && cmp cranes/crane_winch.txt "$top/examples/scenes/crane_winch.txt" ||
   complain 'the tables of a scene must come with it'
run examples fits/laboratory.nml
expect_status 0
checks=$((checks + 1))
[ -s laboratory.nml ] || complain 'an example of a fit must lie in this folder'
run examples
expect_match '^swinging_spring.nml .* P\. Lynch'
! grep -q ' P\.$' out || complain 'a sentence ends at an initial'
fails 2 "no example 'weather'; kyvadlo examples lists them" examples weather

run --completion
expect_status 0
if command -v bash >/dev/null; then
   cat >ask.sh <<'END'
. ./out
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
_kyvadlo
echo "${COMPREPLY[*]}"
END
   completes() {
      wanted=$1
      shift
      checks=$((checks + 1))
      got=$(bash ask.sh "$@")
      [ "$got" = "$wanted" ] || complain "completion of $*: $got, expected $wanted"
   }
   completes table kyvadlo ta
   completes '--kind' kyvadlo eval --k
   completes 'single double quad' kyvadlo table --kind ''
   completes 'Pi Pic Piinc Piincc' kyvadlo eval Pi
   completes ask.sh kyvadlo table as
fi

finish
