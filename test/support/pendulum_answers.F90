!> The pendulum questions of the reference files, answered by the library in three kinds.
module pendulum_answers_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use reference_kinds, only: real128
   use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
   use kyvadlo, error_type => kyvadlo_error_type
   use reference_data, only: read_reference, ulps
#define orbit_type orbit_type_real32
#include "pendulum_answers.inc"
#undef orbit_type
end module pendulum_answers_real32

module pendulum_answers_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use reference_kinds, only: real128
   use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
   use kyvadlo, error_type => kyvadlo_error_type
   use reference_data, only: read_reference, ulps
#include "pendulum_answers.inc"
end module pendulum_answers_real64

#ifndef KYVADLO_NO_REAL128
module pendulum_answers_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, real128
   use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
   use kyvadlo, error_type => kyvadlo_error_type
   use reference_data, only: read_reference, ulps
#define orbit_type orbit_type_real128
#include "pendulum_answers.inc"
#undef orbit_type
end module pendulum_answers_real128
#endif

module pendulum_answers
   use pendulum_answers_real32
   use pendulum_answers_real64
#ifndef KYVADLO_NO_REAL128
   use pendulum_answers_real128
#endif
   implicit none
   public
end module pendulum_answers
