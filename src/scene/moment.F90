!> What a table shows of an orbit at one part of its period, by the closed form of its motion, in three kinds.
!>
!> `wp` is the caller's kind, `cp` the kind that computes: real32 orbits are computed in real64.
module kyvadlo_moment_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, cp => real64
   use kyvadlo_numbers_real32, only: quiet_nan
   use kyvadlo_orbit_real32, only: orbit_type
   use kyvadlo_pairs_real64, only: pair_type
#include "moment.inc"
end module kyvadlo_moment_real32

module kyvadlo_moment_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, cp => real64
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_pairs_real64, only: pair_type
#include "moment.inc"
end module kyvadlo_moment_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_moment_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, cp => real128
   use kyvadlo_numbers_real128, only: quiet_nan
   use kyvadlo_orbit_real128, only: orbit_type
   use kyvadlo_pairs_real128, only: pair_type
#include "moment.inc"
end module kyvadlo_moment_real128
#endif

module kyvadlo_moment
   use kyvadlo_moment_real32, moment_type_real32 => moment_type
   use kyvadlo_moment_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_moment_real128, moment_type_real128 => moment_type
#endif
   implicit none
   public
end module kyvadlo_moment
