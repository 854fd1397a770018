#!/bin/sh
# The program loads few libraries: those of NetCDF and MPI take longer to load than most commands take to run, and belong to the
# program beside it, which it becomes where they are needed.
#
#   start_up.sh PROGRAM
set -u
needed=$(readelf -d "$1" | sed -n 's/.*NEEDED.*\[\(.*\)\].*/\1/p')
[ -n "$needed" ] || { echo "$1: no library found"; exit 1; }
slow=$(printf '%s\n' "$needed" | grep -E 'netcdf|hdf5|mpi|curl')
[ -z "$slow" ] || { echo "$1 loads $slow"; exit 1; }
echo "$1 loads $(printf '%s\n' "$needed" | wc -l) libraries"
