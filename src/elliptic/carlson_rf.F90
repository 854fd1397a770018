!> Carlson's integral of the first kind RF in the three kinds.
module kyvadlo_carlson_rf_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use kyvadlo_numbers_real32, only: quiet_nan, infinity
#include "carlson_rf.inc"
end module kyvadlo_carlson_rf_real32

module kyvadlo_carlson_rf_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_numbers_real64, only: quiet_nan, infinity
#include "carlson_rf.inc"
end module kyvadlo_carlson_rf_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_carlson_rf_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_numbers_real128, only: quiet_nan, infinity
#include "carlson_rf.inc"
end module kyvadlo_carlson_rf_real128
#endif

module kyvadlo_carlson_rf
   use kyvadlo_carlson_rf_real32
   use kyvadlo_carlson_rf_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_carlson_rf_real128
#endif
   implicit none
   public
end module kyvadlo_carlson_rf
