!> When the bob passes through a height or an azimuth, and when it turns next.
!>
!> `wp` is the caller's kind, `cp` the kind that computes: real32 orbits are computed in real64.
module kyvadlo_passage_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, cp => real64
   use kyvadlo_orbit_real32, only: orbit_type
   use kyvadlo_motion_real32, only: place, azimuth, azimuth_of, orbit_momentum, time_limit
   use kyvadlo_numbers_real32, only: is_finite, is_nan, quiet_nan
   use kyvadlo_motion_kinds
   use kyvadlo_pairs_real64
#include "passage.inc"
end module kyvadlo_passage_real32

module kyvadlo_passage_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, cp => real64
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_motion_real64, only: place, azimuth, azimuth_of, orbit_momentum, time_limit
   use kyvadlo_numbers_real64, only: is_finite, is_nan, quiet_nan
   use kyvadlo_motion_kinds
   use kyvadlo_pairs_real64
#include "passage.inc"
end module kyvadlo_passage_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_passage_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, cp => real128
   use kyvadlo_orbit_real128, only: orbit_type
   use kyvadlo_motion_real128, only: place, azimuth, azimuth_of, orbit_momentum, time_limit
   use kyvadlo_numbers_real128, only: is_finite, is_nan, quiet_nan
   use kyvadlo_motion_kinds
   use kyvadlo_pairs_real128
#include "passage.inc"
end module kyvadlo_passage_real128
#endif

module kyvadlo_passage
   use kyvadlo_passage_real32
   use kyvadlo_passage_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_passage_real128
#endif
   implicit none
   public
end module kyvadlo_passage
