!> The orbit of a spherical pendulum: everything about it that does not change with time, set up once, read by any
!> thread.
!>
!> `wp` is the caller's kind, `cp` the kind that computes: real32 orbits are computed in real64. `orbit_rates.inc`
!> computes T and the advance, `orbit_series.inc` sets up the theta series.
module kyvadlo_motion_kinds
   implicit none
   private
   public :: motion_none, motion_generic, motion_conical, motion_plane_libration, motion_plane_rotation, &
      motion_separatrix, motion_rest, motion_upright, most_harmonics

   integer, parameter :: motion_none = 0             !! No orbit: the set-up failed
   integer, parameter :: motion_generic = 1          !! Between two turning circles
   integer, parameter :: motion_conical = 2          !! On a level circle
   integer, parameter :: motion_plane_libration = 3  !! To and fro in a vertical plane
   integer, parameter :: motion_plane_rotation = 4   !! Over the top in a vertical plane
   integer, parameter :: motion_separatrix = 5       !! In a vertical plane, reaching the top after infinite time
   integer, parameter :: motion_rest = 6             !! At rest at the bottom
   integer, parameter :: motion_upright = 7          !! At rest at the top
   !> The last harmonic of the theta functions in any kind.
   integer, parameter :: most_harmonics = 5
end module kyvadlo_motion_kinds


module kyvadlo_orbit_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, cp => real64
   use kyvadlo_motion_kinds
   use kyvadlo_gaps_real32
   use kyvadlo_numbers_real32, only: quiet_nan
   use kyvadlo_numbers_real64, only: quiet_nan_cp => quiet_nan, infinity_cp => infinity
   use kyvadlo_batch_constants
   use kyvadlo_status, only: error_type, fail, code_domain
   use kyvadlo_pairs_real64
#define has_kernel
#define real_number real(cp)
#include "orbit.inc"
#define number type(pair_type)
#define rates_name rates_in_pairs
#include "orbit_rates.inc"
#undef number
#undef rates_name
#define number real(cp)
#define rates_name rates_in_reals
#include "orbit_rates.inc"
#undef number
#undef rates_name
#include "orbit_series.inc"
#include "orbit_kernel.inc"
end module kyvadlo_orbit_real32

module kyvadlo_orbit_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, cp => real64
   use kyvadlo_motion_kinds
   use kyvadlo_gaps_real64
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_numbers_real64, only: quiet_nan_cp => quiet_nan, infinity_cp => infinity
   use kyvadlo_batch_constants
   use kyvadlo_status, only: error_type, fail, code_domain
   use kyvadlo_pairs_real64
#include "orbit.inc"
#define number type(pair_type)
#define rates_name rates_in_pairs
#include "orbit_rates.inc"
#undef number
#undef rates_name
#define number real(cp)
#define rates_name rates_in_reals
#include "orbit_rates.inc"
#undef number
#undef rates_name
#include "orbit_series.inc"
#include "orbit_kernel.inc"
#undef has_kernel
end module kyvadlo_orbit_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_orbit_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, cp => real128
   use kyvadlo_motion_kinds
   use kyvadlo_gaps_real128
   use kyvadlo_numbers_real128, only: quiet_nan
   use kyvadlo_numbers_real128, only: quiet_nan_cp => quiet_nan, infinity_cp => infinity
   use kyvadlo_batch_constants
   use kyvadlo_status, only: error_type, fail, code_domain
   use kyvadlo_pairs_real128
#include "orbit.inc"
#define number type(pair_type)
#define rates_name rates_in_pairs
#include "orbit_rates.inc"
#undef number
#undef rates_name
#define number real(cp)
#define rates_name rates_in_reals
#include "orbit_rates.inc"
#undef number
#undef rates_name
#include "orbit_series.inc"
end module kyvadlo_orbit_real128
#endif

module kyvadlo_orbit
   use kyvadlo_motion_kinds
   use kyvadlo_orbit_real32, orbit_type_real32 => orbit_type, turning_type_real32 => turning_type, &
      harmonics_type_real32 => harmonics_type
   use kyvadlo_orbit_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_orbit_real128, orbit_type_real128 => orbit_type, turning_type_real128 => turning_type, &
      harmonics_type_real128 => harmonics_type
#endif
   implicit none
   public
end module kyvadlo_orbit
