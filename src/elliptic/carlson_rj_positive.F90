!> Carlson's integral of the third kind RJ for p > 0.
module kyvadlo_carlson_rj_positive_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use kyvadlo_carlson_rc_real32, only: carlson_rc, rc_near_one
   use kyvadlo_carlson_rd_real32, only: rj_series
   use kyvadlo_carlson_rf_real32, only: carlson_rf
#include "carlson_rj_positive.inc"
end module kyvadlo_carlson_rj_positive_real32

module kyvadlo_carlson_rj_positive_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_carlson_rc_real64, only: carlson_rc, rc_near_one
   use kyvadlo_carlson_rd_real64, only: rj_series
   use kyvadlo_carlson_rf_real64, only: carlson_rf
#include "carlson_rj_positive.inc"
end module kyvadlo_carlson_rj_positive_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_carlson_rj_positive_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_carlson_rc_real128, only: carlson_rc, rc_near_one
   use kyvadlo_carlson_rd_real128, only: rj_series
   use kyvadlo_carlson_rf_real128, only: carlson_rf
#include "carlson_rj_positive.inc"
end module kyvadlo_carlson_rj_positive_real128
#endif
