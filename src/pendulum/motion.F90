!> The motion: place, velocity and azimuth of the bob at any time, and the rates that describe an orbit.
!>
!> `motion.inc` holds the public functions, `motion_place.inc` the series they evaluate.

module kyvadlo_motion_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, cp => real64
   use kyvadlo_orbit_real32
   use kyvadlo_numbers_real32, only: quiet_nan
   use kyvadlo_numbers_real64, only: is_nan, quiet_nan_cp => quiet_nan
   use kyvadlo_batch_kernel_single
   use kyvadlo_motion_kinds
   use kyvadlo_pairs_real64
#define has_kernel
#include "motion.inc"
#include "motion_place.inc"
end module kyvadlo_motion_real32

module kyvadlo_motion_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, cp => real64
   use kyvadlo_orbit_real64
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_numbers_real64, only: is_nan, quiet_nan_cp => quiet_nan
   use kyvadlo_batch_kernel_single
   use kyvadlo_motion_kinds
   use kyvadlo_pairs_real64
#include "motion.inc"
#include "motion_place.inc"
#undef has_kernel
end module kyvadlo_motion_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_motion_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, cp => real128
   use kyvadlo_orbit_real128
   use kyvadlo_numbers_real128, only: quiet_nan
   use kyvadlo_numbers_real128, only: is_nan, quiet_nan_cp => quiet_nan
   use kyvadlo_motion_kinds
   use kyvadlo_pairs_real128
#include "motion.inc"
#include "motion_place.inc"
end module kyvadlo_motion_real128
#endif

module kyvadlo_motion
   use kyvadlo_motion_real32
   use kyvadlo_motion_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_motion_real128
#endif
   implicit none
   public
end module kyvadlo_motion
