!> Places by the closed form of the library in each of three kinds, whole and with fewer terms.
module kyvadlo_study_closed_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use kyvadlo_orbit_real32, only: orbit_type
#define has_kernel
#include "study_closed.inc"
end module kyvadlo_study_closed_real32

module kyvadlo_study_closed_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_orbit_real64, only: orbit_type
#include "study_closed.inc"
#undef has_kernel
end module kyvadlo_study_closed_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_study_closed_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_orbit_real128, only: orbit_type
#include "study_closed.inc"
end module kyvadlo_study_closed_real128
#endif
