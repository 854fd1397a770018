!> Every row of a reference file against the library, in three kinds.
module measure_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, real64, real128
   use kyvadlo, error_type => kyvadlo_error_type
#define orbit_type orbit_type_real32
#include "measure.inc"
#undef orbit_type
end module measure_real32

module measure_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, real64, real128
   use kyvadlo, error_type => kyvadlo_error_type
#include "measure.inc"
end module measure_real64

#ifndef KYVADLO_NO_REAL128
module measure_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, real64, real128
   use kyvadlo, error_type => kyvadlo_error_type
#define orbit_type orbit_type_real128
#include "measure.inc"
#undef orbit_type
end module measure_real128
#endif

module measure_rows
   use measure_real32
   use measure_real64
#ifndef KYVADLO_NO_REAL128
   use measure_real128
#endif
   implicit none
   public
end module measure_rows
