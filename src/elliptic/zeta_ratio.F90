!> The factor of Jacobi's zeta in two kinds.
module kyvadlo_zeta_ratio_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_bulirsch, only: general_mean
#include "zeta_ratio.inc"
end module kyvadlo_zeta_ratio_real64

module kyvadlo_zeta_ratio_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_bulirsch, only: general_mean
#include "zeta_ratio.inc"
end module kyvadlo_zeta_ratio_real128

module kyvadlo_zeta_ratio
   use kyvadlo_zeta_ratio_real64
   use kyvadlo_zeta_ratio_real128
   implicit none
   public
end module kyvadlo_zeta_ratio
