#!/bin/sh
# Usage: static_memory.sh NM LIBRARY...
# No object of a library has memory of its own that a thread could write: every symbol in .bss, .data, .tbss or COMMON is listed
# and fails, but for gfortran's tables of types, `__vtab_*`, and since gfortran 14 the null of C pointers by which it initialises
# what is declared, `__def_init___iso_c_binding_*`. (What it puts there without being told: the length of a character
# function result of deferred length, one for each call; `save`; variables of modules; a description of a type none of whose
# components has a default.)
nm=$1
shift
found=$(for library in "$@"; do
   LC_ALL=C "$nm" -f sysv "$library" | awk -F '|' -v library="${library##*/}" '
      /\.o[:\]]/ && !/\|/ { object = $1; sub(/:$/, "", object); sub(/.*\[/, "", object); sub(/\].*/, "", object) }
      NF > 6 && $NF ~ /^\.(bss|data|tbss|tdata)|COM/ && $NF !~ /^\.data\.rel\.ro/ && $1 !~ /__vtab_|___def_init___iso_c_binding_C_(fun)?ptr/ {
         sub(/ +$/, "", $1)
         print library, object, $NF, $1
      }'
done)
symbols=$(for library in "$@"; do "$nm" "$library"; done | wc -l)
if [ "$symbols" -lt 100 ]; then
   echo "only $symbols symbols in $*: nothing was checked"
   exit 1
fi
[ -z "$found" ] && exit 0
echo "writable static memory (library, object, section, symbol):"
echo "$found"
exit 1
