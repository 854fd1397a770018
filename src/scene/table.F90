!> Tables of the motion of pendulums, and of orbits over a grid of turning heights, in three kinds.
#define pendulum_type pendulum_type_real32
#define orbit_type orbit_type_real32
#define moment_type moment_type_real32
module kyvadlo_table_real32
   use, intrinsic :: iso_fortran_env, only: int64, wp => real32
#include "table.inc"
end module kyvadlo_table_real32
#undef pendulum_type
#undef orbit_type
#undef moment_type

module kyvadlo_table_real64
   use, intrinsic :: iso_fortran_env, only: int64, wp => real64
#include "table.inc"
end module kyvadlo_table_real64

#define pendulum_type pendulum_type_real128
#define orbit_type orbit_type_real128
#define moment_type moment_type_real128
#ifndef KYVADLO_NO_REAL128
module kyvadlo_table_real128
   use, intrinsic :: iso_fortran_env, only: int64, wp => real128
#include "table.inc"
end module kyvadlo_table_real128
#endif
#undef pendulum_type
#undef orbit_type
#undef moment_type

module kyvadlo_table
   use kyvadlo_table_real32
   use kyvadlo_table_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_table_real128
#endif
   implicit none
   public
end module kyvadlo_table
