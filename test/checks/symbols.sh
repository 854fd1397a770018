#!/bin/sh
# Usage: symbols.sh NM LIBRARY...
# A program that links the libraries statically shares their global names: each begins with kyvadlo_, __kyvadlo or kyv, or is one
# of SLATEC's in libkyvadlo_slatec. A callback for C hides its name by bind(c, name=''). And no procedure of the core, of the
# elliptic functions or of the interfaces saves and restores the floating-point environment, as those do whose scope uses an IEEE
# module.
nm=$1
shift
status=0
seen=0
for library in "$@"; do
   names=$(LC_ALL=C "$nm" -g --defined-only "$library" | awk 'NF == 3 { print $3 }' | sort -u)
   seen=$((seen + $(printf '%s\n' "$names" | grep -c .)))
   case $library in
   *kyvadlo_slatec*) slatec='|^d?r[cdfj]_$' ;;
   *) slatec= ;;
   esac
   strangers=$(printf '%s\n' "$names" | grep -Ev "^kyvadlo_|^__kyvadlo|^kyv$slatec")
   if [ -n "$strangers" ]; then
      echo "global names of ${library##*/} that may clash with a program's:"
      echo "$strangers"
      status=1
   fi
   case $library in
   *kyvadlo_core.* | *kyvadlo_elliptic.* | *kyvadlo_c.* | *kyvadlo_slatec.*)
      if LC_ALL=C "$nm" -A "$library" | grep _gfortran_ieee_procedure; then
         echo "${library##*/}: these objects use an IEEE module where procedures see it"
         status=1
      fi ;;
   esac
done
if [ "$seen" -lt 100 ]; then
   echo "only $seen names in $*: nothing was checked"
   status=1
fi
exit $status
