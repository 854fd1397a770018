!> The orbit of a spherical pendulum: everything about it that does not change with time, set up once, read by any thread.
!>
!> `wp` is the caller's kind, `cp` the kind that computes: real32 orbits are computed in real64. `orbit_rates.inc`
!> computes T and the advance, `orbit_series.inc` sets up the theta series.
module kyvadlo_motion_kinds
   use kyvadlo_batch_constants, only:  ! for fpm, which does not look into what is included
   use kyvadlo_status, only:  ! for fpm, which does not look into what is included
   use kyvadlo_two_part, only:  ! for fpm, which does not look into what is included
   implicit none
   private
   public :: motion_none, motion_generic, motion_conical, motion_plane_libration, motion_plane_rotation, &
      motion_separatrix, motion_rest, motion_upright

   integer, parameter :: motion_none = 0             !! No orbit: the set-up failed
   integer, parameter :: motion_generic = 1          !! Between two turning circles
   integer, parameter :: motion_conical = 2          !! On a level circle
   integer, parameter :: motion_plane_libration = 3  !! To and fro in a vertical plane
   integer, parameter :: motion_plane_rotation = 4   !! Over the top in a vertical plane
   integer, parameter :: motion_separatrix = 5       !! In a vertical plane, reaching the top after infinite time
   integer, parameter :: motion_rest = 6             !! At rest at the bottom
   integer, parameter :: motion_upright = 7          !! At rest at the top
end module kyvadlo_motion_kinds

! Harmonics of the theta functions: the first left out, n + 1, has at k**2 = 1/2 the relative size exp(-pi ((n+1)**2 - (n+1)/2)),
! which is 6e-11 for n = 2 (real32), 8e-20 for 3 (real64), 1e-45 for 5 (real128).
#define most_harmonics 5

module kyvadlo_orbit_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, cp => real64
   use kyvadlo_motion_kinds
   use kyvadlo_gaps_real32
#define gaps_type gaps_type_real32
#define orbit_type orbit_type_real32
#define turning_type turning_type_real32
#define harmonics_type harmonics_type_real32
#define highest_harmonic 2
#define has_kernel
#include "orbit.inc"
#include "orbit_rates.inc"
#define rough_rates
#include "orbit_rates.inc"
#undef rough_rates
#include "orbit_series.inc"
#include "orbit_kernel.inc"
#undef gaps_type
#undef orbit_type
#undef turning_type
#undef harmonics_type
#undef highest_harmonic
end module kyvadlo_orbit_real32

module kyvadlo_orbit_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, cp => real64
   use kyvadlo_motion_kinds
   use kyvadlo_gaps_real64
#define highest_harmonic 3
#include "orbit.inc"
#include "orbit_rates.inc"
#define rough_rates
#include "orbit_rates.inc"
#undef rough_rates
#include "orbit_series.inc"
#include "orbit_kernel.inc"
#undef has_kernel
#undef highest_harmonic
end module kyvadlo_orbit_real64

#define pair_type pair_type_real128
#define pi_pair pi_pair_real128
#define root_two_pair root_two_pair_real128
module kyvadlo_orbit_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, cp => real128
   use kyvadlo_motion_kinds
   use kyvadlo_gaps_real128
#define gaps_type gaps_type_real128
#define orbit_type orbit_type_real128
#define turning_type turning_type_real128
#define harmonics_type harmonics_type_real128
#define highest_harmonic 5
#include "orbit.inc"
#include "orbit_rates.inc"
#define rough_rates
#include "orbit_rates.inc"
#undef rough_rates
#include "orbit_series.inc"
#undef gaps_type
#undef orbit_type
#undef turning_type
#undef harmonics_type
#undef highest_harmonic
end module kyvadlo_orbit_real128
#undef pair_type
#undef pi_pair
#undef root_two_pair
#undef most_harmonics

module kyvadlo_orbit
   use kyvadlo_motion_kinds
   use kyvadlo_orbit_real32
   use kyvadlo_orbit_real64
   use kyvadlo_orbit_real128
   implicit none
   public
end module kyvadlo_orbit
