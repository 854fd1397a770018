!> Principal values of Carlson's RJ in real64 and real128 (real32 takes real64).
module kyvadlo_carlson_rj_principal_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_carlson_rc_real64, only: carlson_rc, rc_near_one, rc_excess
   use kyvadlo_carlson_rf_real64, only: carlson_rf
   use kyvadlo_carlson_rj_positive_real64, only: rj_positive, rj_moderate, middle_of, low, high
   use kyvadlo_two_part_real64, only: pair_type, pair, value, two_sum, two_product
#include "carlson_rj_principal.inc"
end module kyvadlo_carlson_rj_principal_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_carlson_rj_principal_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_carlson_rc_real128, only: carlson_rc, rc_near_one, rc_excess
   use kyvadlo_carlson_rf_real128, only: carlson_rf
   use kyvadlo_carlson_rj_positive_real128, only: rj_positive, rj_moderate, middle_of, low, high
   use kyvadlo_two_part_real128, only: pair_type, pair, value, two_sum, two_product
#include "carlson_rj_principal.inc"
end module kyvadlo_carlson_rj_principal_real128
#endif
