#!/bin/sh
# Flags that make x of (x + big) - big are refused with a sentence: by the compiler, whoever calls it (fpm), and by CMake,
# whether they stand in its flags or in FFLAGS.
#
#   refused_flags.sh SOURCE_FOLDER SCRATCH_FOLDER FORTRAN_COMPILER C_COMPILER
set -u
top=$1 work=$2 fortran=$3 c=$4
status=0
rm -rf "$work"
mkdir -p "$work/project"
cd "$work" || exit 1
fails() { echo "FAILED: $*"; status=1; }

compile() { "$fortran" -O2 "$@" -I "$top/src/arithmetic" -c -o two_part.o "$top/src/arithmetic/two_part.F90" >compiled 2>&1; }
compile || { cat compiled; fails 'the source does not compile without such a flag'; }
for flags in -ffast-math -Ofast -funsafe-math-optimizations -ffinite-math-only -freciprocal-math \
   '-fassociative-math -fno-signed-zeros -fno-trapping-math'; do
   # shellcheck disable=SC2086
   compile $flags && fails "$flags: compiled"
   grep -q 'kyvadlo cannot be compiled with -ffast-math, -Ofast' compiled || fails "$flags: no sentence of the compiler"
done

printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(flags LANGUAGES Fortran C)' \
   "include($top/cmake/compiler_checks.cmake)" >project/CMakeLists.txt
configure() {
   rm -rf build
   cmake -S project -B build -DCMAKE_BUILD_TYPE=Release "-DCMAKE_Fortran_COMPILER=$fortran" "-DCMAKE_C_COMPILER=$c" "$@" \
      >configured 2>&1
}
FFLAGS='' CFLAGS='' configure || { cat configured; fails 'CMake refuses what has no such flag'; }
refused() {
   configure "$@" && fails "$*: configured"
   grep -q 'kyvadlo cannot be compiled with -O\{0,1\}f' configured || fails "$*: no sentence of CMake"
}
refused -DCMAKE_Fortran_FLAGS=-ffast-math
refused -DCMAKE_Fortran_FLAGS_RELEASE='-O3 -Ofast -g'
refused -DCMAKE_C_FLAGS=-ffinite-math-only
FFLAGS='-g -Ofast'; export FFLAGS
refused
exit "$status"
