module kyvadlo_theta_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use kyvadlo_numbers_real32, only: quiet_nan, infinity
#include "theta.inc"
end module kyvadlo_theta_real32

module kyvadlo_theta_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_numbers_real64, only: quiet_nan, infinity
#include "theta.inc"
end module kyvadlo_theta_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_theta_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_numbers_real128, only: quiet_nan, infinity
#include "theta.inc"
end module kyvadlo_theta_real128
#endif

!> Jacobi's theta functions in three kinds.
module kyvadlo_theta
   use kyvadlo_theta_real32
   use kyvadlo_theta_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_theta_real128
#endif
   implicit none
   public
end module kyvadlo_theta
