!> Carlson's integral of the third kind RJ in the three kinds.
module kyvadlo_carlson_rj_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, xp => real64
   use kyvadlo_numbers_real32, only: quiet_nan, infinity
   use kyvadlo_carlson_rc_real32, only: carlson_rc, rc_near_one
   use kyvadlo_carlson_rd_real32, only: rj_series
   use kyvadlo_carlson_rf_real32, only: carlson_rf
   use kyvadlo_carlson_rj_pair_real64, only: rj_principal_in_pairs
#include "carlson_rj.inc"
end module kyvadlo_carlson_rj_real32

module kyvadlo_carlson_rj_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, xp => real64
   use kyvadlo_numbers_real64, only: quiet_nan, infinity
   use kyvadlo_carlson_rc_real64, only: carlson_rc, rc_near_one
   use kyvadlo_carlson_rd_real64, only: rj_series
   use kyvadlo_carlson_rf_real64, only: carlson_rf
   use kyvadlo_carlson_rj_pair_real64, only: rj_principal_in_pairs
#include "carlson_rj.inc"
end module kyvadlo_carlson_rj_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_carlson_rj_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, xp => real128
   use kyvadlo_numbers_real128, only: quiet_nan, infinity
   use kyvadlo_carlson_rc_real128, only: carlson_rc, rc_near_one
   use kyvadlo_carlson_rd_real128, only: rj_series
   use kyvadlo_carlson_rf_real128, only: carlson_rf
   use kyvadlo_carlson_rj_pair_real128, only: rj_principal_in_pairs
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
