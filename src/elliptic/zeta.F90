!> Jacobi's zeta function in three kinds; real32 is computed in real64.
module kyvadlo_zeta_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, inner => real64
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_carlson_rf_real64, only: carlson_rf
   use kyvadlo_complete, only: elliptic_kc
   use kyvadlo_jacobi, only: jacobi_functions, jacobi_functionsc
   use kyvadlo_zeta_ratio, only: zeta_ratio
#include "zeta.inc"
end module kyvadlo_zeta_real32

module kyvadlo_zeta_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, inner => real64
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_carlson_rf_real64, only: carlson_rf
   use kyvadlo_complete, only: elliptic_kc
   use kyvadlo_jacobi, only: jacobi_functions, jacobi_functionsc
   use kyvadlo_zeta_ratio, only: zeta_ratio
#include "zeta.inc"
end module kyvadlo_zeta_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_zeta_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, inner => real128
   use kyvadlo_numbers_real128, only: quiet_nan
   use kyvadlo_carlson_rf_real128, only: carlson_rf
   use kyvadlo_complete, only: elliptic_kc
   use kyvadlo_jacobi, only: jacobi_functions, jacobi_functionsc
   use kyvadlo_zeta_ratio, only: zeta_ratio
#include "zeta.inc"
end module kyvadlo_zeta_real128
#endif

module kyvadlo_zeta
   use kyvadlo_zeta_real32
   use kyvadlo_zeta_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_zeta_real128
#endif
   implicit none
   public
end module kyvadlo_zeta
