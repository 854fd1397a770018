#!/bin/sh
# The calls that doc/elliptic.md shows compile with the names of their arguments as keywords: `carlson_rf(x, y, z)` as
# carlson_rf(x=x, y=y, z=z).
#
#   keywords.sh TOP FORTRAN_COMPILER FOLDER_OF_MODULES...
set -u
page=$1/doc/elliptic.md
compiler=$2
shift 2
for folder in "$@"; do set -- "$@" "-I$(CDPATH='' cd -- "$folder" && pwd)"; shift; done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
{
   cat <<'END'
program keywords
   use kyvadlo
   implicit none
   double precision :: x, y, z, p, n, m, mc, phi, u, v, q, kc, a, b, c, d, sn, cn, dn, am, value, roots(3)
   integer :: i, count
   type(jacobi_type) :: jacobi
END
   # Calls of the lines that define them: rows of tables with a formula, and sentences that begin with a call.
   grep -E '^(\|[^|]*\| *\$|`)' "$page" | grep -o '`[a-z_]*([a-z, ]*)`' | tr -d '`' | sort -u | grep -v '(i=' |
      awk -F'[()]' '{
         count = split($2, words, / *, */); text = ""
         for (k = 1; k <= count; k++) text = text (k > 1 ? ", " : "") words[k] "=" words[k]
         is_call = $1 ~ /^(jacobi_functionsc?|jacobi_evaluate|cubic_roots)$/
         if ($1 ~ /^new_jacobi/) print "   jacobi = " $1 "(" text ")"
         else print "   " (is_call ? "call " : "value = ") $1 "(" text ")"
      }'
   echo 'end program keywords'
} >keywords.f90
calls=$(grep -c -E ' (call|value =|jacobi =) ' keywords.f90)
[ "$calls" -gt 35 ] || { echo "only $calls calls found"; exit 1; }
"$compiler" -fsyntax-only -std=f2018 "$@" keywords.f90 || exit 1
echo "$calls calls compile with their keywords"
