module kyvadlo_jacobi_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, xp => real64, real64, int64
   use kyvadlo_numbers_real32, only: quiet_nan
   use kyvadlo_quarter_period_real64, only: subtract_quarter_periods, most_quarter_periods
#include "jacobi.inc"
end module kyvadlo_jacobi_real32

module kyvadlo_jacobi_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, xp => real64, real64, int64
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_quarter_period_real64, only: subtract_quarter_periods, most_quarter_periods
#include "jacobi.inc"
end module kyvadlo_jacobi_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_jacobi_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, xp => real128, real64, int64
   use kyvadlo_numbers_real128, only: quiet_nan
   use kyvadlo_quarter_period_real128, only: subtract_quarter_periods, most_quarter_periods
#include "jacobi.inc"
end module kyvadlo_jacobi_real128
#endif

!> Jacobian elliptic functions in three kinds.
module kyvadlo_jacobi
   use kyvadlo_jacobi_real32, jacobi_type_real32 => jacobi_type
   use kyvadlo_jacobi_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_jacobi_real128, jacobi_type_real128 => jacobi_type
#endif
   implicit none
   public
end module kyvadlo_jacobi
