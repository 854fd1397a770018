module kyvadlo_start_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use kyvadlo_gaps_real32, only: gaps_type, gaps_from_heights, gaps_from_gaps, gaps_from_rises, &
      gaps_from_energy, energy_is_total, energy_is_above_top, energy_is_above_bottom
   use kyvadlo_orbit_real32, only: orbit_type, set_up, new_orbit_from_release
   use kyvadlo_start_kinds
   use kyvadlo_state_real32
   use kyvadlo_status, only: error_type, fail, code_domain
#include "start.inc"
end module kyvadlo_start_real32

module kyvadlo_start_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_gaps_real64, only: gaps_type, gaps_from_heights, gaps_from_gaps, gaps_from_rises, gaps_from_energy, &
      energy_is_total, energy_is_above_top, energy_is_above_bottom
   use kyvadlo_orbit_real64, only: orbit_type, set_up, new_orbit_from_release
   use kyvadlo_start_kinds
   use kyvadlo_state_real64
   use kyvadlo_status, only: error_type, fail, code_domain
#include "start.inc"
end module kyvadlo_start_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_start_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_gaps_real128, only: gaps_type, gaps_from_heights, gaps_from_gaps, gaps_from_rises, &
      gaps_from_energy, energy_is_total, energy_is_above_top, energy_is_above_bottom
   use kyvadlo_orbit_real128, only: orbit_type, set_up, new_orbit_from_release
   use kyvadlo_start_kinds
   use kyvadlo_state_real128
   use kyvadlo_status, only: error_type, fail, code_domain
#include "start.inc"
end module kyvadlo_start_real128
#endif

module kyvadlo_start
   use kyvadlo_start_kinds
   use kyvadlo_start_real32
   use kyvadlo_start_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_start_real128
#endif
   implicit none
   public
end module kyvadlo_start
