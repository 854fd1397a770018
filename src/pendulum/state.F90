!> Orbits from any position and velocity.
!>
!> `wp` is the caller's kind, `cp` the kind that computes: real32 orbits are computed in real64.
module kyvadlo_state_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, cp => real64
   use kyvadlo_gaps_real32, only: gaps_type, gaps_from_state
   use kyvadlo_orbit_real32, only: orbit_type, set_up, place, phase_time
   use kyvadlo_motion_kinds
   use kyvadlo_status, only: error_type
   use kyvadlo_pairs_real64
#include "state.inc"
end module kyvadlo_state_real32

module kyvadlo_state_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, cp => real64
   use kyvadlo_gaps_real64, only: gaps_type, gaps_from_state
   use kyvadlo_orbit_real64, only: orbit_type, set_up, place, phase_time
   use kyvadlo_motion_kinds
   use kyvadlo_status, only: error_type
   use kyvadlo_pairs_real64
#include "state.inc"
end module kyvadlo_state_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_state_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, cp => real128
   use kyvadlo_gaps_real128, only: gaps_type, gaps_from_state
   use kyvadlo_orbit_real128, only: orbit_type, set_up, place, phase_time
   use kyvadlo_motion_kinds
   use kyvadlo_status, only: error_type
   use kyvadlo_pairs_real128
#include "state.inc"
end module kyvadlo_state_real128
#endif

module kyvadlo_state
   use kyvadlo_state_real32
   use kyvadlo_state_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_state_real128
#endif
   implicit none
   public
end module kyvadlo_state
