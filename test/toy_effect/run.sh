#!/bin/sh
# An effect is added as doc/contributing.md says: toy_effect.patch, a constant force `&push acceleration=`, touches the files that
# page names and no other. With a folder to build in, the patched program is built, and a bob that is pushed sideways swings as it
# would about the tilted vertical.
#
#   run.sh TOP [FOLDER]      FOLDER: made anew
set -u
top=$1
patch=$top/test/toy_effect/toy_effect.patch
named=$(sed -n '/^## Adding an effect/,/^## Adding a start/p' "$top/doc/contributing.md" | tr '\140' '\n' |   # \140: a backquote
   grep '^src/[a-zA-Z0-9_/.]*$' | LC_ALL=C sort -u)
touched=$(sed -n 's|^+++ b/||p' "$patch" | LC_ALL=C sort)
[ "$named" = "$touched" ] || {
   printf 'doc/contributing.md names\n%s\nthe patch touches\n%s\n' "$named" "$touched"
   exit 1
}
command -v patch >/dev/null || { echo 'skipped: there is no patch'; exit 77; }
folder=${2-}
[ -n "$folder" ] || exec patch --dry-run --batch -d "$top" -p1 -i "$patch"

rm -rf "$folder"
mkdir -p "$folder/tree" || exit 1
for part in CMakeLists.txt cmake src examples man LICENSE; do
   [ ! -e "$top/$part" ] || cp -R "$top/$part" "$folder/tree" || exit 1
done
cd "$folder/tree" || exit 1
patch --batch -p1 -i "$patch" || exit 1
cmake -S . -B ../build -DCMAKE_BUILD_TYPE=Debug -DKYVADLO_BUILD_TESTS=OFF -DKYVADLO_WITH_REAL128=OFF -DKYVADLO_WITH_NETCDF=OFF \
   -DKYVADLO_WITH_SLATEC=OFF >../configure.log || { cat ../configure.log; exit 1; }
cmake --build ../build --target kyvadlo_driver >../build.log 2>&1 || { tail -n 40 ../build.log; exit 1; }

# From rest at the lowest point the bob swings to twice the angle of the plumb line, here atan(0.2), and back.
cat >../push.nml <<'END'
&pendulum length=1 gravity=9.80665 position=0,0,-1 velocity=0,0,0 /
&push acceleration=1.96133,0,0 /
&output duration=2 samples=20001 quantities='inclination position derivatives' derivatives='acceleration' /
END
sed "s/1.96133/0/; s/ derivatives'.*/' \//" ../push.nml >../still.nml
../build/bin/kyvadlo simulate ../push.nml >../push.csv || exit 1
awk -F, 'NR > 1 && $2 > most { most = $2 } END { error = most/(2*atan2(0.2, 1)) - 1; print "angle off by " error
   exit !(error*error < 1e-14) }' ../push.csv || exit 1
# Pushed twice as hard for a short time it is twice as far: x = a t**2/2, so dx/da = t**2/2.
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "dx_dacceleration1") column = i }
   NR == 101 { error = $column/($1*$1/2) - 1; print "derivative off by " error; exit !(column > 0 && error*error < 1e-6) }' \
   ../push.csv || exit 1
# Not pushed it is the scene without the group.
../build/bin/kyvadlo simulate --explain ../still.nml 2>&1 >/dev/null | grep 'at rest' || exit 1
