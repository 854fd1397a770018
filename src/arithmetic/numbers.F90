!> Infinity and NaN as constants and tests for them, without an IEEE module: gfortran saves and restores the
!> floating-point environment at each call of a procedure whose scope uses one (600 to 1200 ns). Where a test must be
!> inlined, `x /= x` tells a NaN too: == and /= are quiet (IEEE 754), < and <= raise invalid.
module kyvadlo_numbers_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, ik => int32, int8, int16
#include "numbers.inc"
end module kyvadlo_numbers_real32

module kyvadlo_numbers_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, ik => int64, int8, int16
#include "numbers.inc"
end module kyvadlo_numbers_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_numbers_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, ik => int64, int8, int16
#include "numbers.inc"
end module kyvadlo_numbers_real128
#endif

module kyvadlo_numbers
   use kyvadlo_numbers_real32, quiet_nan_real32 => quiet_nan, infinity_real32 => infinity
   use kyvadlo_numbers_real64, quiet_nan_real64 => quiet_nan, infinity_real64 => infinity
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_numbers_real128, quiet_nan_real128 => quiet_nan, infinity_real128 => infinity
#endif
   implicit none
   public
end module kyvadlo_numbers
