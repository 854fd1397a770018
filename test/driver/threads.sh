#!/bin/sh
# Samples are the same to the last byte whatever the number of threads, also where fields are zero, tiny or huge: their text takes
# another way than that of common numbers. Two scenes by the closed form, one with a moving pivot, one string that goes slack.
# Fifty runs each, or $3.
. "$(dirname "$0")/expect.sh"

output='&output samples=4100'
runs=${3-50}
OMP_WAIT_POLICY=passive; export OMP_WAIT_POLICY  # 16 threads that spin on two cores take their time
cat >plane.nml <<END
&pendulum length=1, release_angle=60, release_speed=0 /
$output, duration=100 /
END
cat >tiny.nml <<END
&pendulum length=1e-30, gravity=1e-40, z_upper=-0.3e-30, z_lower=-0.8e-30 /
$output, duration=1e6, quantities='momentum' /
END
cat >huge.nml <<END
&pendulum length=1e30, gravity=1e40, z_upper=0.3e30, z_lower=-0.8e30 /
$output, duration=1e-3, quantities='momentum' /
&moving_pivot amplitude=0,0,0 frequency=1,1,1 /
END
cat >string.nml <<END
&pendulum length=1, position=0,0,-1, velocity=5.8,0,0 /
&string restitution=0.5 /
$output, duration=3 /
END
for scene in plane tiny huge string; do
   run simulate $scene.nml --threads 1
   expect_status 0
   mv out one
   [ "$(wc -l <one)" -ge 4101 ] || complain '4101 lines expected'
      ! grep -q -e '-0e+00' one || complain 'zero has no sign'
   for threads in 1 2 3 7 16; do
      checks=$((checks + 1))
      different=0
      for _ in $(seq "$runs"); do
         "$program" simulate $scene.nml --threads $threads >out 2>err
         cmp -s one out || different=$((different + 1))
      done
      [ $different -eq 0 ] || complain "$different of $runs runs differ, $scene on $threads threads"
   done
done
fails 2 "option --threads must be a whole number, 0 to 1024, got '-1'" simulate plane.nml --threads -1
finish
