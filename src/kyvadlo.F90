!> Everything public of the elliptic functions and of the pendulum: `use kyvadlo, only: ...`.
!>
!> What belongs to an orbit, a string or an accuracy is bound to its type (`orbit%period()`); every other name carries
!> the prefix of its family, so that it clashes with no name of the program that uses it.
module kyvadlo
   use kyvadlo_status, only: kyvadlo_error_type => error_type, code_domain, code_input, code_file, code_unsupported
   use kyvadlo_release, only: kyvadlo_version_linked, kyvadlo_version_number
   use kyvadlo_carlson
   use kyvadlo_complete
   use kyvadlo_complete_pi
   use kyvadlo_incomplete
   use kyvadlo_incomplete_pi
   use kyvadlo_nome
   use kyvadlo_jacobi
   use kyvadlo_jacobi_ratios
   use kyvadlo_zeta
   use kyvadlo_heuman
   use kyvadlo_theta
   use kyvadlo_bulirsch
   use kyvadlo_cubic
   use kyvadlo_motion_kinds, only: motion_none, motion_generic, motion_conical, motion_plane_libration, &
      motion_plane_rotation, motion_separatrix, motion_rest, motion_upright
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_orbit, only: orbit_type_real128, orbit_turning_type_real128 => turning_type_real128
#endif
   use kyvadlo_orbit, only: orbit_type, orbit_type_real32, orbit_turning_type => turning_type, &
      orbit_turning_type_real32 => turning_type_real32, new_orbit_from_heights, new_orbit_from_gaps, &
      new_orbit_from_rises, new_orbit_from_release, new_orbit_from_energy, new_orbit_from_energy_above_top, &
      new_orbit_from_energy_above_bottom, orbits_locate
   use kyvadlo_state
   use kyvadlo_start, only: new_orbit, start_heights, start_gaps, start_rises, start_energy, start_energy_above_top, &
      start_energy_above_bottom, start_release, start_state
   use kyvadlo_string
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_derivatives, only: derivatives_type_real128
#endif
   use kyvadlo_derivatives, only: derivatives_type, new_derivatives_from_heights, new_derivatives_from_gaps, &
      new_derivatives_from_rises, new_derivatives_from_energy, new_derivatives_from_energy_above_top, &
      new_derivatives_from_energy_above_bottom, new_derivatives_from_release, new_derivatives_from_state
   use kyvadlo_accuracy
   use kyvadlo_periods, only: orbit_period_from_gaps, orbits_period_from_gaps
   use kyvadlo_many_orbits, only: orbits_advance_from_gaps, orbits_constants_from_gaps, orbits_locate_from_gaps
   implicit none
   public
end module kyvadlo
