#!/bin/sh
# Ten million orbits of eight constants by `kyvadlo sweep`, beside what the disk takes for as many bytes: both are on the disk at the
# end (fsync). The best of some runs, in turn.
#
#   sweep_beside_disk.sh KYVADLO [FOLDER [RUNS [SIDE]]]     SIDE orbits along each of two axes (3163)
set -eu
program=$1
folder=${2-.}
runs=${3-3}
side=${4-3163}
scratch=$(mktemp -d "$folder/sweep.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
cat >"$scratch/plan.nml" <<END
&pendulum length = 1, upper_gap = 0.5, lower_rise = 0.2 /
&axis name = 'upper_gap', from = 0.5, to = 1, count = $side /
&axis name = 'lower_rise', from = 0.01, to = 0.4, count = $side /
&measure quantities = 'T k complementary_modulus K q A phi_T advance' /
END
# seconds COMMAND...: of one run
seconds() {
   start=$(date +%s.%N)
   "$@" >"$scratch/out" 2>&1 || { cat "$scratch/out"; exit 1; }
   awk "BEGIN { print $(date +%s.%N) - $start }"
}
swept() { "$program" sweep "$scratch/plan.nml" --output "$scratch/swept.nc" && sync "$scratch/swept.nc"; }
written() { dd if=/dev/zero of="$scratch/written" bs=1M count="$bytes" iflag=count_bytes conv=fsync; }
ours=999999
disk=999999
for run in $(seq "$runs"); do
   rm -f "$scratch/swept.nc" "$scratch/written"
   sync
   time=$(seconds swept)
   ours=$(awk "BEGIN { print $time < $ours ? $time : $ours }")
   bytes=$(stat -c %s "$scratch/swept.nc")
   rm -f "$scratch/swept.nc"
   sync
   time=$(seconds written)
   disk=$(awk "BEGIN { print $time < $disk ? $time : $disk }")
   echo "run $run of $runs: sweep $ours s, disk $disk s at best" >&2
done
awk "BEGIN { n = $side*$side
   printf \"%d orbits of eight constants, %d bytes\\n\", n, $bytes
   printf \"sweep, on the disk %10.2f s %8.1f ns an orbit\\n\", $ours, 1e9*$ours/n
   printf \"dd, on the disk    %10.2f s %8.1f ns an orbit\\n\", $disk, 1e9*$disk/n
   printf \"sweep over dd      %10.2f\\n\", $ours/$disk }"
