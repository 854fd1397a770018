!> Exact derivatives of the motion: the state-transition matrix and the derivatives with respect to length, gravity and
!> start, by the closed form differentiated at set-up (doc/formulas.md).
!>
!> The arithmetic in pairs comes once more, on the pairs of orbits: the compiler sees it beside its callers and inlines,
!> without which a set-up takes 1.1 times as long.
module kyvadlo_derivative_pairs_real64
   use, intrinsic :: iso_fortran_env, only: pk => real64
   use kyvadlo_pairs_real64, only: pair_type, pi_pair, root_two_pair
#define has_pair_type
#include "../arithmetic/two_part.inc"
end module kyvadlo_derivative_pairs_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_derivative_pairs_real128
   use, intrinsic :: iso_fortran_env, only: pk => real128
   use kyvadlo_pairs_real128, only: pair_type, pi_pair, root_two_pair
#include "../arithmetic/two_part.inc"
end module kyvadlo_derivative_pairs_real128
#endif
#undef has_pair_type

module kyvadlo_derivatives_real64
   use, intrinsic :: iso_fortran_env, only: int64, real64, wp => real64, cp => real64
   use kyvadlo_batch_constants, only: even_cosines, even_sines, odd_cosines, odd_sines
   use kyvadlo_batch_dispatch, only: vector_level
   use kyvadlo_derivative_constants
   use kyvadlo_derivative_dispatch
   use kyvadlo_gaps_real64, only: gaps_type
   use kyvadlo_orbit_real64, only: orbit_type, set_up, new_orbit_from_heights, new_orbit_from_gaps, &
      new_orbit_from_rises, new_orbit_from_energy, new_orbit_from_energy_above_top, &
      new_orbit_from_energy_above_bottom, new_orbit_from_release, kernel_limit, kernel_start
   use kyvadlo_state_real64, only: new_orbit_from_state
   use kyvadlo_motion_kinds
   use kyvadlo_threads, only: thread_count
   use kyvadlo_batch_constants, only: block_size
   use kyvadlo_numbers_real64, only: is_finite, is_nan, quiet_nan
   use kyvadlo_derivative_pairs_real64
   use kyvadlo_status, only: error_type
#define has_kernel
#include "derivatives.inc"
#undef has_kernel
end module kyvadlo_derivatives_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_derivatives_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, cp => real128
   use kyvadlo_gaps_real128, only: gaps_type
   use kyvadlo_orbit_real128, only: orbit_type, set_up, new_orbit_from_heights, new_orbit_from_gaps, &
      new_orbit_from_rises, new_orbit_from_energy, new_orbit_from_energy_above_top, &
      new_orbit_from_energy_above_bottom, new_orbit_from_release
   use kyvadlo_state_real128, only: new_orbit_from_state
   use kyvadlo_motion_kinds
   use kyvadlo_threads, only: thread_count
   use kyvadlo_batch_constants, only: block_size
   use kyvadlo_numbers_real128, only: is_finite, is_nan, quiet_nan
   use kyvadlo_derivative_pairs_real128
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
