#!/bin/sh
# `kyvadlo --version` prints the flags that the core was compiled with (OpenMP's that of its sources with threads), each of them
# and no other.
#
#   version_flags.sh BUILD_FOLDER PROGRAM
set -u
build=$1 program=$2
if [ -f "$build/build.ninja" ]; then
   given=$(sed -n '/^build src\/CMakeFiles\/kyvadlo_core.dir\/.*threads.f90.o:/,/^$/s/^  FLAGS = //p' "$build/build.ninja")
else
   make=$build/src/CMakeFiles/kyvadlo_core.dir/flags.make
   given="$(sed -n 's/^Fortran_FLAGS = //p' "$make") $(sed -n 's/^# Custom options: .*threads.f90.o_OPTIONS = //p' "$make" | tr ';' ' ')"
fi
# What says where files are, and what Ninja adds to a source that it preprocessed before, are no flags of ours.
words() { printf '%s\n' "$1" | tr -s ' ' '\n' | grep -v -e '^-J' -e '^-fpreprocessed$' -e '^$' | sort -u; }
printed=$("$program" --version | sed -n 's/^Flags: //p')
[ -n "$given" ] && [ "$(words "$given")" = "$(words "$printed")" ] && exit 0
printf 'FAILED\ngiven:   %s\nprinted: %s\n' "$given" "$printed"
exit 1
