#!/bin/sh
# Usage: ieee_entry.sh NM LIBRARY...
# No procedure of the libraries saves and restores the floating-point environment at each call, which takes 600 to 1200 ns:
# gfortran has it do so where its own scope uses, at any depth, a module that uses an IEEE module.
nm=$1
shift
[ "$("$nm" "$@" 2>/dev/null | wc -l)" -gt 100 ] || { echo "hardly a symbol in $*: nothing was checked"; exit 1; }
found=$("$nm" -A "$@" 2>/dev/null | grep '_gfortran_ieee_procedure_entry' | sed 's/: .*//' | sort -u)
[ -z "$found" ] || { printf 'these use an IEEE module in the scope of a procedure:\n%s\n' "$found"; exit 1; }
