!> Carlson's integrals of the second kind RD and RG in the three kinds.
module kyvadlo_carlson_rd_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use kyvadlo_numbers_real32, only: quiet_nan, infinity
   use kyvadlo_carlson_rf_real32, only: rf_series
#include "carlson_rd.inc"
end module kyvadlo_carlson_rd_real32

module kyvadlo_carlson_rd_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_numbers_real64, only: quiet_nan, infinity
   use kyvadlo_carlson_rf_real64, only: rf_series
#include "carlson_rd.inc"
end module kyvadlo_carlson_rd_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_carlson_rd_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_numbers_real128, only: quiet_nan, infinity
   use kyvadlo_carlson_rf_real128, only: rf_series
#include "carlson_rd.inc"
end module kyvadlo_carlson_rd_real128
#endif

module kyvadlo_carlson_rd
   use kyvadlo_carlson_rd_real32
   use kyvadlo_carlson_rd_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_carlson_rd_real128
#endif
   implicit none
   public
end module kyvadlo_carlson_rd
