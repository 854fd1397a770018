!> The motion: place, velocity and azimuth of the bob at any time, and the rates that describe an orbit.
!>
!> `motion.inc` holds the public functions, `motion_place.inc` the series they evaluate.

submodule (kyvadlo_orbit_real32) kyvadlo_motion_real32
   use kyvadlo_numbers_real64, only: is_nan
   use kyvadlo_batch_kernel_single
#define has_kernel
#include "motion.inc"
#include "motion_place.inc"
end submodule kyvadlo_motion_real32

submodule (kyvadlo_orbit_real64) kyvadlo_motion_real64
   use kyvadlo_numbers_real64, only: is_nan
   use kyvadlo_batch_kernel_single
#include "motion.inc"
#include "motion_place.inc"
#undef has_kernel
end submodule kyvadlo_motion_real64

#ifndef KYVADLO_NO_REAL128
submodule (kyvadlo_orbit_real128) kyvadlo_motion_real128
   use kyvadlo_numbers_real128, only: is_nan
#include "motion.inc"
#include "motion_place.inc"
end submodule kyvadlo_motion_real128
#endif
