!> Bulirsch's integrals cel, el1, el2, el3 in three kinds; real32 is computed in real64.
module kyvadlo_bulirsch_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, inner => real64
   use kyvadlo_numbers_real64, only: quiet_nan, infinity
   use kyvadlo_carlson_rc_real64, only: carlson_rc
   use kyvadlo_carlson_rd_real64, only: carlson_rd
   use kyvadlo_carlson_rf_real64, only: carlson_rf
   use kyvadlo_cel_positive, only: cel_positive, scaled_cel
   use kyvadlo_incomplete_pi_real64, only: first_turn
#include "bulirsch.inc"
end module kyvadlo_bulirsch_real32

module kyvadlo_bulirsch_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, inner => real64
   use kyvadlo_numbers_real64, only: quiet_nan, infinity
   use kyvadlo_carlson_rc_real64, only: carlson_rc
   use kyvadlo_carlson_rd_real64, only: carlson_rd
   use kyvadlo_carlson_rf_real64, only: carlson_rf
   use kyvadlo_cel_positive, only: cel_positive, scaled_cel
   use kyvadlo_incomplete_pi_real64, only: first_turn
#include "bulirsch.inc"
end module kyvadlo_bulirsch_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_bulirsch_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, inner => real128
   use kyvadlo_numbers_real128, only: quiet_nan, infinity
   use kyvadlo_carlson_rc_real128, only: carlson_rc
   use kyvadlo_carlson_rd_real128, only: carlson_rd
   use kyvadlo_carlson_rf_real128, only: carlson_rf
   use kyvadlo_cel_positive, only: cel_positive, scaled_cel
   use kyvadlo_incomplete_pi_real128, only: first_turn
#include "bulirsch.inc"
end module kyvadlo_bulirsch_real128
#endif

module kyvadlo_bulirsch
   use kyvadlo_bulirsch_real32
   use kyvadlo_bulirsch_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_bulirsch_real128
#endif
   implicit none
   public
end module kyvadlo_bulirsch
