!> Tables of the motion of pendulums, and of orbits over a grid of turning heights, in three kinds.
module kyvadlo_table_real32
   use, intrinsic :: iso_fortran_env, only: int64, wp => real32
   use kyvadlo_moment_real32, only: moment_of, moment_type, span_of
   use kyvadlo_orbit_real32, only: orbit_type
#include "table.inc"
end module kyvadlo_table_real32

module kyvadlo_table_real64
   use, intrinsic :: iso_fortran_env, only: int64, wp => real64
   use kyvadlo_moment_real64, only: moment_of, moment_type, span_of
   use kyvadlo_orbit_real64, only: orbit_type
#include "table.inc"
end module kyvadlo_table_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_table_real128
   use, intrinsic :: iso_fortran_env, only: int64, wp => real128
   use kyvadlo_moment_real128, only: moment_of, moment_type, span_of
   use kyvadlo_orbit_real128, only: orbit_type
#include "table.inc"
end module kyvadlo_table_real128
#endif

module kyvadlo_table
   use kyvadlo_table_real32
   use kyvadlo_table_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_table_real128
#endif
   implicit none
   public
end module kyvadlo_table
