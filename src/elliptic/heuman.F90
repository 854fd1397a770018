!> Heuman's lambda function in three kinds; real32 is computed in real64.
module kyvadlo_heuman_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, inner => real64
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_amplitude, only: reduce_amplitude
   use kyvadlo_cel_positive, only: general_complete
#include "heuman.inc"
end module kyvadlo_heuman_real32

module kyvadlo_heuman_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, inner => real64
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_amplitude, only: reduce_amplitude
   use kyvadlo_cel_positive, only: general_complete
#include "heuman.inc"
end module kyvadlo_heuman_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_heuman_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, inner => real128
   use kyvadlo_numbers_real128, only: quiet_nan
   use kyvadlo_amplitude, only: reduce_amplitude
   use kyvadlo_cel_positive, only: general_complete
#include "heuman.inc"
end module kyvadlo_heuman_real128
#endif

module kyvadlo_heuman
   use kyvadlo_heuman_real32
   use kyvadlo_heuman_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_heuman_real128
#endif
   implicit none
   public
end module kyvadlo_heuman
