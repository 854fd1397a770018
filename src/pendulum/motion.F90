!> The motion: place, velocity and azimuth of the bob at any time, and the rates that describe an orbit.
!>
!> `motion.inc` holds the public functions, `motion_place.inc` the series they evaluate.
#define most_harmonics 5

module kyvadlo_motion_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, cp => real64
   use kyvadlo_motion_kinds, only:  ! for fpm, which does not look into what is included
   use kyvadlo_two_part, only:  ! for fpm, which does not look into what is included
   use kyvadlo_orbit_real32
   use kyvadlo_batch_kernel_single
#define has_kernel
#define orbit_type orbit_type_real32
#define harmonics_type harmonics_type_real32
#include "motion.inc"
#include "motion_place.inc"
#undef orbit_type
#undef harmonics_type
end module kyvadlo_motion_real32

module kyvadlo_motion_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, cp => real64
   use kyvadlo_orbit_real64
   use kyvadlo_batch_kernel_single
#include "motion.inc"
#include "motion_place.inc"
#undef has_kernel
end module kyvadlo_motion_real64

module kyvadlo_motion_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, cp => real128
   use kyvadlo_orbit_real128
#define pair_type pair_type_real128
#define pi_pair pi_pair_real128
#define root_two_pair root_two_pair_real128
#define orbit_type orbit_type_real128
#define harmonics_type harmonics_type_real128
#include "motion.inc"
#include "motion_place.inc"
#undef pair_type
#undef pi_pair
#undef root_two_pair
#undef orbit_type
#undef harmonics_type
end module kyvadlo_motion_real128

module kyvadlo_motion
   use kyvadlo_motion_real32
   use kyvadlo_motion_real64
   use kyvadlo_motion_real128
   implicit none
   public
end module kyvadlo_motion
