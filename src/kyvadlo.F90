!> Everything public of the core under one name: `use kyvadlo`.
module kyvadlo
   use kyvadlo_kinds
   use kyvadlo_status
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
   use kyvadlo_bulirsch
   use kyvadlo_theta
   use kyvadlo_cubic
   use kyvadlo_motion_kinds
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_orbit, only: orbit_type_real128, turning_type_real128
#endif
   use kyvadlo_orbit, only: orbit_type, orbit_type_real32, turning_type, turning_type_real32, &
      new_orbit_from_heights, new_orbit_from_gaps, new_orbit_from_rises, new_orbit_from_release, &
      new_orbit_from_energy, new_orbit_from_energy_above_top, new_orbit_from_energy_above_bottom, from_upper_turning
   use kyvadlo_state
   use kyvadlo_start, only: new_orbit, start_heights, start_gaps, start_rises, start_energy, start_energy_above_top, &
      start_energy_above_bottom, start_release, start_state
   use kyvadlo_motion, only: height_period, modulus, complementary_modulus, quarter_period, nome, phase_rate, &
      azimuth_rate, azimuth_per_period, apsidal_advance, apsidal_angle, apsidal_rate, &
      orbit_energy, orbit_momentum, time_limit, &
      polar_angle_terms, height, rise, top_clearance, phase, periodic_azimuth, azimuth, vertical_speed, &
      azimuthal_speed, speed, locate, acceleration, rod_force
   use kyvadlo_string
   use kyvadlo_passage, only: time_to_height, time_to_rise, time_to_azimuth, next_turning_time
   use kyvadlo_batch, only: locate_batch, locate_many
   use kyvadlo_accuracy
   use kyvadlo_periods, only: period_from_gaps, periods_from_gaps
   implicit none
   public
end module kyvadlo
