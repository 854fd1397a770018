#!/bin/sh
# The first ```fortran block of a page is the program in examples that the tests build and run.
#
#   program.sh TOP PAGE PROGRAM
set -u
cd "$1" || exit 1
awk '/^```fortran$/ { inside = 1; next } inside && /^```$/ { exit } inside' "$2" | diff - "$3" || exit 1
echo "$2 shows $3"
