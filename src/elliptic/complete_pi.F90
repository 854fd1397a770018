!> Complete elliptic integral of the third kind in three kinds; real32 is computed in real64.
module kyvadlo_complete_pi_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, inner => real64
   use kyvadlo_numbers_real64, only: quiet_nan, infinity
   use kyvadlo_cel_positive, only: cel_of_roots, general_complete
#include "complete_pi.inc"
end module kyvadlo_complete_pi_real32

module kyvadlo_complete_pi_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, inner => real64
   use kyvadlo_numbers_real64, only: quiet_nan, infinity
   use kyvadlo_cel_positive, only: cel_of_roots, general_complete
#include "complete_pi.inc"
end module kyvadlo_complete_pi_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_complete_pi_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, inner => real128
   use kyvadlo_numbers_real128, only: quiet_nan, infinity
   use kyvadlo_cel_positive, only: cel_of_roots, general_complete
#include "complete_pi.inc"
end module kyvadlo_complete_pi_real128
#endif

module kyvadlo_complete_pi
   use kyvadlo_complete_pi_real32, only: elliptic_pi, elliptic_pic
   use kyvadlo_complete_pi_real64, only: elliptic_pi, elliptic_pic
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_complete_pi_real128, only: elliptic_pi, elliptic_pic
#endif
   implicit none
   public
end module kyvadlo_complete_pi
