!> How a pendulum of a scene becomes numbers and an orbit, in three kinds.
module kyvadlo_scene_orbit_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, cp => real64, real64
   use kyvadlo_pairs_real64, only: operator(*), operator(+), operator(/), pair, pair_type, two_difference, two_product
   use kyvadlo_start_real32, only: new_orbit
   use kyvadlo_orbit_real32, only: orbit_type
#include "scene_orbit.inc"
end module kyvadlo_scene_orbit_real32

module kyvadlo_scene_orbit_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, cp => real64, real64
   use kyvadlo_pairs_real64, only: operator(*), operator(+), operator(/), pair, pair_type, two_difference, two_product
   use kyvadlo_start_real64, only: new_orbit
   use kyvadlo_orbit_real64, only: orbit_type
#include "scene_orbit.inc"
end module kyvadlo_scene_orbit_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_scene_orbit_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, cp => real128, real64
   use kyvadlo_pairs_real128, only: operator(*), operator(+), operator(/), pair, pair_type, two_difference, two_product
   use kyvadlo_start_real128, only: new_orbit
   use kyvadlo_orbit_real128, only: orbit_type
#include "scene_orbit.inc"
end module kyvadlo_scene_orbit_real128
#endif

module kyvadlo_scene_orbit
   use kyvadlo_scene_orbit_real32, numbers_type_real32 => numbers_type
   use kyvadlo_scene_orbit_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_scene_orbit_real128, numbers_type_real128 => numbers_type
#endif
   implicit none
   public
end module kyvadlo_scene_orbit
