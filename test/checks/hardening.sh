#!/bin/sh
# What the loader does with our program and shared libraries: it looks for libraries in no current folder, binds all addresses
# at the start; the C parts watch their stack, and in a release their buffers too.
#
#   hardening.sh BUILD_TYPE FILE...
set -u
type=$1
shift
breaches=0
breach() {
   echo "$1"
   breaches=$((breaches + 1))
}

for file in "$@"; do
   [ -n "$file" ] || continue     # CMake 3.31 hands on the empty place of libraries that are not shared
   [ -s "$file" ] || { breach "$file is not there"; continue; }
   dynamic=$(LC_ALL=C readelf -d "$file")
   # An empty element of the path, and a relative one, are looked for in the current folder.
   echo "$dynamic" | sed -n 's/.*(R[UN]*PATH).*\[\(.*\)\]$/\1/p' | tr ':' '\n' >elements.$$
   while IFS= read -r element; do
      case $element in
      '$ORIGIN' | '$ORIGIN/'* | /*) ;;
      *) breach "$file: element '$element' of its library path" ;;
      esac
   done <elements.$$
   rm elements.$$
   echo "$dynamic" | grep -q -E 'BIND_NOW|Flags:.*NOW' || breach "$file: addresses are bound late"
   LC_ALL=C readelf -l -W "$file" | grep -q 'GNU_RELRO' || breach "$file: no GNU_RELRO"
   case $file in
   */kyvadlo)
      LC_ALL=C readelf -s -W "$file" >symbols.$$
      grep -q '__stack_chk_fail' symbols.$$ || breach "$file: no stack protector"
      [ "$type" != Release ] || grep -q -E '__[a-z]+_chk(@| |$)' symbols.$$ || breach "$file: no checks of buffers"
      rm symbols.$$
      ;;
   esac
done
[ "$breaches" -eq 0 ] || exit 1
echo "$# files, no breach"
