!> Carlson's integral of the third kind RJ in the three kinds.
module kyvadlo_carlson_rj_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, xp => real64
   use kyvadlo_numbers_real32, only: quiet_nan, infinity
   use kyvadlo_carlson_rj_positive_real32, only: rj_positive, rj_far, middle_of, far
   use kyvadlo_carlson_rj_principal_real64, only: rj_principal
#include "carlson_rj.inc"
end module kyvadlo_carlson_rj_real32

module kyvadlo_carlson_rj_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, xp => real64
   use kyvadlo_numbers_real64, only: quiet_nan, infinity
   use kyvadlo_carlson_rj_positive_real64, only: rj_positive, rj_far, middle_of, far
   use kyvadlo_carlson_rj_principal_real64, only: rj_principal
#include "carlson_rj.inc"
end module kyvadlo_carlson_rj_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_carlson_rj_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, xp => real128
   use kyvadlo_numbers_real128, only: quiet_nan, infinity
   use kyvadlo_carlson_rj_positive_real128, only: rj_positive, rj_far, middle_of, far
   use kyvadlo_carlson_rj_principal_real128, only: rj_principal
#include "carlson_rj.inc"
end module kyvadlo_carlson_rj_real128
#endif

module kyvadlo_carlson_rj
   use kyvadlo_carlson_rj_real32
   use kyvadlo_carlson_rj_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_carlson_rj_real128
#endif
   implicit none
   public
end module kyvadlo_carlson_rj
