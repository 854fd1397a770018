# Signals: nothing is left behind, and what a caller ignores stays ignored.
# shellcheck disable=SC2154

# part_appears: waits until an unfinished file is there.
part_appears() {
   tries=0
   while no_part && [ $tries -lt 100 ]; do tries=$((tries + 1)); sleep 0.05; done
}

attack 'signals'
echo old >out.csv
for signal in HUP TERM PIPE ALRM USR1 USR2 XCPU VTALRM PROF SEGV ABRT BUS FPE; do
   line="simulate endless.nml --output out.csv --events e.csv --plot p.svg, then $signal"
   "$program" simulate endless.nml --output out.csv --events e.csv --plot p.svg >out 2>err &
   victim=$!
   part_appears
   kill -$signal $victim
   wait $victim 2>/dev/null
   status=$?
   inputs=$((inputs + 1))
   want 'ended by the signal' [ "$status" -gt 128 ]
   want 'no unfinished file' no_part
   want 'the old file' grep -q '^old$' out.csv
done
# INT and QUIT are ignored behind & in a script: there they come from timeout.
for signal in INT QUIT; do
   line="timeout -s $signal 1 simulate endless.nml --output out.csv"
   timeout -s $signal 1 "$program" simulate endless.nml --output out.csv >out 2>err
   status=$?
   inputs=$((inputs + 1))
   want 'ended by the signal' [ "$status" -ge 124 ]
   want 'no unfinished file' no_part
   line="simulate endless.nml & and $signal, which a script ignores"
   "$program" simulate endless.nml --output out.csv >out 2>err &
   victim=$!
   part_appears
   kill -$signal $victim
   sleep 0.2
   want 'still there' kill -0 $victim
   kill -TERM $victim 2>/dev/null
   wait $victim 2>/dev/null
   status=0
   inputs=$((inputs + 1))
done
line='nohup simulate endless.nml, then HUP'
nohup "$program" simulate endless.nml --output out.csv >out 2>err &
victim=$!
part_appears
kill -HUP $victim
sleep 0.2
inputs=$((inputs + 1))
want 'still there' kill -0 $victim
kill -TERM $victim
wait $victim 2>/dev/null
status=0
want 'no unfinished file' no_part
line='SIGPIPE ignored'
(trap '' PIPE; "$program" simulate endless.nml --events e.csv 2>err; echo $? >status) | head -n 1 >out
status=$(cat status)
inputs=$((inputs + 1))
refused 'Broken pipe'
want 'no unfinished file' no_part
for more in '--events e.csv' '--plot p.svg'; do
   line="simulate endless.nml $more | head"
   # shellcheck disable=SC2086
   "$program" simulate endless.nml $more 2>err | head -n 1 >out
   inputs=$((inputs + 1))
   status=0
   want 'quietly' [ ! -s err ]
   want 'no unfinished file' no_part
done
line='study, then TERM'
"$program" study --seconds 1 --output record >out 2>err &
victim=$!
part_appears
kill -TERM $victim
wait $victim 2>/dev/null
status=$?
inputs=$((inputs + 1))
want 'ended by the signal' [ "$status" -eq 143 ]
want 'no unfinished file' no_part
if unshare -p -f --kill-child true 2>/dev/null; then
   line='TERM to process 1'
   unshare -p -f --kill-child sh -c 'exec "$0" simulate endless.nml --output out.csv >out 2>err' "$program" &
   outer=$!
   part_appears
   inner=$(pgrep -P $outer)
   kill -TERM "$inner"
   wait $outer
   status=$?
   inputs=$((inputs + 1))
   want 'status 143' [ "$status" -eq 143 ]
   want 'no unfinished file' no_part
fi
