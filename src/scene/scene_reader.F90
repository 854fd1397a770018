!> How a scene file becomes pendulums, in three kinds: every number is read in its kind.
#define pendulum_type pendulum_type_real32
module kyvadlo_scene_reader_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
#include "scene_reader.inc"
end module kyvadlo_scene_reader_real32
#undef pendulum_type

module kyvadlo_scene_reader_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
#include "scene_reader.inc"
end module kyvadlo_scene_reader_real64

#define pendulum_type pendulum_type_real128
#ifndef KYVADLO_NO_REAL128
module kyvadlo_scene_reader_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
#include "scene_reader.inc"
end module kyvadlo_scene_reader_real128
#endif
#undef pendulum_type

module kyvadlo_scene_reader
   use kyvadlo_scene_reader_real32
   use kyvadlo_scene_reader_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_scene_reader_real128
#endif
   implicit none
   public
end module kyvadlo_scene_reader
