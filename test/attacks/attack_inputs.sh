# Inputs that are large, endless, closed or read before. 10 MB take less than a second on an idle machine.
# shellcheck disable=SC2154

attack 'standard streams'
{ echo 'a line that is no scene'; cat scene.nml; } >in
line='{ read x; simulate -; } <file'
{ read -r _; timeout 20 "$program" simulate - >out 2>err; } <in
count $?
want 'read on from there' [ "$status" -eq 0 ]
rm in
line='simulate - from a pipe'
timeout 20 "$program" simulate - >out 2>err <<END
$(cat scene.nml)
END
count $?
want 'status 0' [ "$status" -eq 0 ]
for closed in '<&-' '>&-' '2>&-' '<&- >&- 2>&-'; do
   for arguments in 'simulate scene.nml --events e.csv --plot p.svg' 'eval K 0.5' eval table 'simulate -' '--help'; do
      line="$arguments $closed"
      : >out
      : >err
      eval "timeout 20 \"\$program\" $arguments >out 2>err $closed"
      count $?
      want 'no samples in a file that took a stream' eval '! grep -q "^t,x,y,z,vx" e.csv 2>/dev/null'
   done
done
if command -v python3 >/dev/null; then
   line='simulate - from a socket'
   python3 - "$program" scene.nml >out 2>err <<'END'
import socket, subprocess, sys
ours, theirs = socket.socketpair()
child = subprocess.Popen([sys.argv[1], 'simulate', '-'], stdin=theirs, stdout=subprocess.PIPE)
theirs.close()
ours.sendall(open(sys.argv[2], 'rb').read())
ours.close()
out = child.communicate(timeout=20)[0]
sys.exit(0 if child.returncode == 0 and out.startswith(b't,') else 1)
END
   count $?
   want 'a socket is read' [ "$status" -eq 0 ]
   # On a terminal of 40 columns: a picture alone prints no samples, and a line of progress does not wrap.
   line='simulate --plot on a terminal'
   python3 - "$program" >out 2>err <<'END'
import fcntl, os, pty, struct, subprocess, sys, termios
def on_terminal(arguments, seconds=None):
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack('HHHH', 24, 40, 0, 0))
    out = None if seconds is None else subprocess.DEVNULL
    child = subprocess.Popen([sys.argv[1]] + arguments, stdin=slave, stdout=slave if out is None else out, stderr=slave)
    os.close(slave)
    if seconds is not None:
        try: child.wait(timeout=seconds)
        except subprocess.TimeoutExpired: child.terminate()
    text = b''
    try:
        while True:
            more = os.read(master, 65536)
            if not more: break
            text += more
    except OSError: pass
    child.wait()
    return text
text = on_terminal(['simulate', 'scene.nml', '--plot', 'p.svg'])
assert b't,x' not in text, text
assert b't,x' in on_terminal(['simulate', 'scene.nml', '--plot', 'p.svg', '--output', '-'])
text = on_terminal(['simulate', 'endless.nml'], 2.5)
lines = [part for part in text.replace(b'\n', b'\r').split(b'\r') if part]
assert lines and all(len(part) < 40 for part in lines), lines
assert any(b' left' in part for part in lines), lines
END
   count $?
   want 'fit for the terminal' [ "$status" -eq 0 ]
fi

attack 'large inputs'
patience=10
repeated() { head -c "$2" /dev/zero | tr '\0' "$1"; }
head='&pendulum name="x", length=1, z_upper=0.3, z_lower=-0.8'
end='&output duration=2 samples=3 /'
large() {
   line="$1"
   timeout $patience "$program" simulate large.nml >out 2>err
   count $?
   want 'an answer or a message' [ "$status" -eq 0 -o "$status" -eq 2 ]
   timeout $patience "$program" table large.nml >out 2>err
   count $?
   want 'an answer or a message' [ "$status" -eq 0 -o "$status" -eq 2 ]
}
{ echo "$head"; repeated ' ' 10000000; echo "/ $end"; } >large.nml; large '10 MB of blanks'
{ echo "$head"; repeated '\n' 10000000; echo "/ $end"; } >large.nml; large '10 MB of line feeds'
{ echo "$head !"; repeated 'x' 10000000; echo; echo "/ $end"; } >large.nml; large 'a comment of 10 MB'
{ echo "$head gravity=1"; repeated '0' 10000000; echo "/ $end"; } >large.nml; large 'a number of 10 MB'
{ echo "$head gravity=1."; repeated '3' 10000000; echo "/ $end"; } >large.nml; large 'a fraction of 10 MB'
{ printf "&pendulum name='"; repeated 'x' 10000000; echo "' length=1, z_upper=0.3, z_lower=-0.8 / $end"; } >large.nml; large 'a name of 10 MB'
{ printf "&pendulum name='"; repeated "'" 2000000; echo "' length=1, z_upper=0.3, z_lower=-0.8 / $end"; } >large.nml; large '1e6 doubled quotes'
{ echo "$head"; awk 'BEGIN { for (i = 1; i <= 20000; i++) print "n" i "=1" }'; echo "/ $end"; } >large.nml; large '20000 names'
{ echo "$head"; awk 'BEGIN { for (i = 1; i <= 20000; i++) print "gravity=9.81" }'; echo "/ $end"; } >large.nml; large 'a name 20000 times'
{ echo "$head $end" | sed 's/length=1/length=10000*1/'; echo '/'; } >large.nml; large 'length=10000*1'
{ echo "$head gravity=9999999999*1 / $end"; } >large.nml; large 'a repeat of 1e10'
{ awk 'BEGIN { for (i = 1; i <= 100000; i++) print "&pendulum length=1 z_upper=0 z_lower=-0.5 /" }'; } >large.nml
line='100000 groups'
timeout 60 "$program" table large.nml --data --format csv >out 2>err
count $?
{ repeated '&' 1000000; } >large.nml; large '1e6 ampersands'
{ repeated '(' 1000000; } >large.nml; large '1e6 brackets'
head -c 10000000 /dev/zero >large.nml; large '10 MB of zero bytes'
head -c 70000000 /dev/zero | tr '\0' ' ' >large.nml; large '70 MB'
rm large.nml
line='eval with a line of 80 MB'
{ repeated '1' 80000000; echo; echo 'K 0.5'; } | timeout $patience "$program" eval >out 2>err
count $?
want 'the next request is answered' grep -q '^1.85407467730137' out
line='eval with 1 MB of arguments'
{ printf 'K '; repeated '1' 1000000; echo; } | timeout $patience "$program" eval >out 2>err
count $?
line='eval with 500000 words'
{ awk 'BEGIN { for (i = 1; i <= 500000; i++) printf "1 "; print "" }'; } | timeout $patience "$program" eval >out 2>err
count $?
if [ $with_gsl = yes ]; then
   printf '%s\n' '&pendulum length=1, z_upper=0.3, z_lower=-0.8 / &output duration=2 samples=3 /' "&moving_pivot table='big' /" >big.nml
   awk 'BEGIN { for (i = 0; i < 160000; i++) printf "%.10g %.10g 0 0\n", i*0.01, i*0.0001 }' >big
   go simulate big.nml
   want 'a table of 160000 lines' [ "$status" -eq 0 ]
   { echo '0 0 0 0 #'; repeated 'x' 10000000; } >big
   go simulate big.nml
   want 'a message' [ "$status" -eq 2 ]
   { repeated '1' 10000000; echo ' 0 0 0'; } >big
   go simulate big.nml
   want 'a message' [ "$status" -eq 2 ]
   mkfifo pipe
   sed 's/big/pipe/' big.nml >waits.nml
   line='a pipe as table='
   timeout 5 "$program" simulate waits.nml >out 2>err &
   victim=$!
   sleep 1
   inputs=$((inputs + 1))
   status=0
   want 'it says that it waits' grep -q 'pipe is a pipe: waiting' err
   printf '0 0 0 0\n1 0 0 0\n3 0 0 0\n' >pipe
   wait $victim
   status=$?
   want 'and goes on' [ "$status" -eq 0 ]
fi
patience=20

attack 'integrations without an end'
if [ $with_gsl = yes ]; then
   for groups in '&elastic stiffness=1e12 mass=1 /' '&air linear=1e300 /' '&air linear=1 / &wind velocity=1e300,0,0 /' \
      '&moving_pivot amplitude=3*1e300 frequency=3*1 /' '&moving_pivot amplitude=3*1 frequency=3*1e150 /' \
      '&earth_rotation latitude=45 rate=1e100 /' '&elastic stiffness=1e-300 mass=1e300 /'; do
      printf '%s\n' '&pendulum length=1, z_upper=0.3, z_lower=-0.8 / &output duration=1000 samples=3 /' "$groups" >scene.nml
      go simulate scene.nml
      want 'a message or samples' [ "$status" -eq 0 -o "$status" -eq 2 ]
      want 'no row of nothing' eval '! grep -q -i -e ",,," -e nan out'
   done
fi
for pendulum in 'length=1 position=1,0,0 velocity=0,1e9,0' 'length=1 gravity=1e300 z_upper=0.3 z_lower=-0.8' \
   'length=1e-300 z_upper=0.3e-300 z_lower=-0.8e-300' 'length=1e300 z_upper=0.3e300 z_lower=-0.8e300'; do
   for rest in '' '&air linear=0.1 /'; do
      [ -z "$rest" ] || [ $with_gsl = yes ] || continue
      printf '%s\n' "&pendulum $pendulum / &output duration=1000 samples=3 /" "$rest" >scene.nml
      go simulate scene.nml
      want 'a message or samples' [ "$status" -eq 0 -o "$status" -eq 2 ]
      want 'no row of nothing' eval '! grep -q -i -e ",,," -e nan out'
   done
done
printf '%s\n' '&pendulum length=1 z_upper=0.3 z_lower=-0.8 / &output duration=1e300 samples=3 /' >scene.nml
go simulate scene.nml
want 'no rows at 1e300' eval '! grep -q "^1e+300,,," out'
