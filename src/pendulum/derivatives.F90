!> Exact derivatives of the motion: the state-transition matrix and the derivatives with respect to length, gravity and
!> start, by the closed form differentiated at set-up (doc/formulas.md).
module kyvadlo_derivatives_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, cp => real64
   use kyvadlo_gaps_real64, only: gaps_type
   use kyvadlo_orbit_real64, only: orbit_type, set_up, new_orbit_from_heights, new_orbit_from_gaps, new_orbit_from_rises
   use kyvadlo_state_real64, only: new_orbit_from_state
   use kyvadlo_motion_kinds
   use kyvadlo_threads, only: thread_count
   use kyvadlo_batch_constants, only: block_size
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_pairs_real64
   use kyvadlo_status, only: error_type
#include "derivatives.inc"
end module kyvadlo_derivatives_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_derivatives_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, cp => real128
   use kyvadlo_gaps_real128, only: gaps_type
   use kyvadlo_orbit_real128, only: orbit_type, set_up, new_orbit_from_heights, new_orbit_from_gaps, &
      new_orbit_from_rises
   use kyvadlo_state_real128, only: new_orbit_from_state
   use kyvadlo_motion_kinds
   use kyvadlo_threads, only: thread_count
   use kyvadlo_batch_constants, only: block_size
   use kyvadlo_numbers_real128, only: quiet_nan
   use kyvadlo_pairs_real128
   use kyvadlo_status, only: error_type
#include "derivatives.inc"
end module kyvadlo_derivatives_real128
#endif

module kyvadlo_derivatives
   use kyvadlo_derivatives_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_derivatives_real128, derivatives_type_real128 => derivatives_type
#endif
   implicit none
   public
end module kyvadlo_derivatives
