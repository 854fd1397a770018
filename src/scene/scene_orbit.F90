!> How a pendulum of a scene becomes an orbit, in three kinds.
#define pendulum_type pendulum_type_real32
#define orbit_type orbit_type_real32
module kyvadlo_scene_orbit_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
#include "scene_orbit.inc"
end module kyvadlo_scene_orbit_real32
#undef pendulum_type
#undef orbit_type

module kyvadlo_scene_orbit_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
#include "scene_orbit.inc"
end module kyvadlo_scene_orbit_real64

#define pendulum_type pendulum_type_real128
#define orbit_type orbit_type_real128
#ifndef KYVADLO_NO_REAL128
module kyvadlo_scene_orbit_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
#include "scene_orbit.inc"
end module kyvadlo_scene_orbit_real128
#endif
#undef pendulum_type
#undef orbit_type

module kyvadlo_scene_orbit
   use kyvadlo_scene_orbit_real32
   use kyvadlo_scene_orbit_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_scene_orbit_real128
#endif
   implicit none
   public
end module kyvadlo_scene_orbit
