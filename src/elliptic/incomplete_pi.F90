!> Incomplete elliptic integral of the third kind in three kinds; real32 is computed in real64.
module kyvadlo_incomplete_pi_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, inner => real64
   use kyvadlo_numbers_real64, only: quiet_nan, infinity
   use kyvadlo_amplitude, only: delta_squared, reduce_amplitude
   use kyvadlo_carlson_rc_real64, only: carlson_rc
   use kyvadlo_carlson_rf_real64, only: carlson_rf
   use kyvadlo_carlson_rj_real64, only: carlson_rj
   use kyvadlo_complete_pi_real64, only: third_kind
#include "incomplete_pi.inc"
end module kyvadlo_incomplete_pi_real32

module kyvadlo_incomplete_pi_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, inner => real64
   use kyvadlo_numbers_real64, only: quiet_nan, infinity
   use kyvadlo_amplitude, only: delta_squared, reduce_amplitude
   use kyvadlo_carlson_rc_real64, only: carlson_rc
   use kyvadlo_carlson_rf_real64, only: carlson_rf
   use kyvadlo_carlson_rj_real64, only: carlson_rj
   use kyvadlo_complete_pi_real64, only: third_kind
#include "incomplete_pi.inc"
end module kyvadlo_incomplete_pi_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_incomplete_pi_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, inner => real128
   use kyvadlo_numbers_real128, only: quiet_nan, infinity
   use kyvadlo_amplitude, only: delta_squared, reduce_amplitude
   use kyvadlo_carlson_rc_real128, only: carlson_rc
   use kyvadlo_carlson_rf_real128, only: carlson_rf
   use kyvadlo_carlson_rj_real128, only: carlson_rj
   use kyvadlo_complete_pi_real128, only: third_kind
#include "incomplete_pi.inc"
end module kyvadlo_incomplete_pi_real128
#endif

module kyvadlo_incomplete_pi
   use kyvadlo_incomplete_pi_real32, only: elliptic_piinc, elliptic_piincc
   use kyvadlo_incomplete_pi_real64, only: elliptic_piinc, elliptic_piincc
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_incomplete_pi_real128, only: elliptic_piinc, elliptic_piincc
#endif
   implicit none
   public
end module kyvadlo_incomplete_pi
