!> The factor of Jacobi's zeta in two kinds.
module kyvadlo_zeta_ratio_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_cel_positive, only: general_mean
#include "zeta_ratio.inc"
end module kyvadlo_zeta_ratio_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_zeta_ratio_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_cel_positive, only: general_mean
#include "zeta_ratio.inc"
end module kyvadlo_zeta_ratio_real128
#endif

module kyvadlo_zeta_ratio
   use kyvadlo_zeta_ratio_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_zeta_ratio_real128
#endif
   implicit none
   public
end module kyvadlo_zeta_ratio
