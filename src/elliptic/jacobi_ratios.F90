module kyvadlo_jacobi_ratios_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use kyvadlo_numbers_real32, only: infinity
   use kyvadlo_jacobi_real32, only: neville_functions, neville_functionsc
#include "jacobi_ratios.inc"
end module kyvadlo_jacobi_ratios_real32

module kyvadlo_jacobi_ratios_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_numbers_real64, only: infinity
   use kyvadlo_jacobi_real64, only: neville_functions, neville_functionsc
#include "jacobi_ratios.inc"
end module kyvadlo_jacobi_ratios_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_jacobi_ratios_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_numbers_real128, only: infinity
   use kyvadlo_jacobi_real128, only: neville_functions, neville_functionsc
#include "jacobi_ratios.inc"
end module kyvadlo_jacobi_ratios_real128
#endif

!> The twelve Jacobian elliptic functions, one at a time, and the amplitude, in three kinds.
module kyvadlo_jacobi_ratios
   use kyvadlo_jacobi_ratios_real32
   use kyvadlo_jacobi_ratios_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_jacobi_ratios_real128
#endif
   implicit none
   public
end module kyvadlo_jacobi_ratios
