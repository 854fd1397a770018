!> The real roots of a cubic in the three kinds. real32 is computed in real64: deciding exactly needs four times the
!> digits of the coefficients below one another, for which real32 has no room in its exponents.
module kyvadlo_cubic_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, xp => real64
   use kyvadlo_numbers, only: is_finite
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_exact_sign_real64, only: monomial, exact_sign
   use kyvadlo_two_part_real64
#include "cubic.inc"
end module kyvadlo_cubic_real32

module kyvadlo_cubic_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, xp => real64
   use kyvadlo_numbers, only: is_finite
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_exact_sign_real64, only: monomial, exact_sign
   use kyvadlo_two_part_real64
#include "cubic.inc"
end module kyvadlo_cubic_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_cubic_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, xp => real128
   use kyvadlo_numbers, only: is_finite
   use kyvadlo_numbers_real128, only: quiet_nan
   use kyvadlo_exact_sign_real128, only: monomial, exact_sign
   use kyvadlo_two_part_real128
#include "cubic.inc"
end module kyvadlo_cubic_real128
#endif

module kyvadlo_cubic
   use kyvadlo_cubic_real32
   use kyvadlo_cubic_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_cubic_real128
#endif
   implicit none
   public
end module kyvadlo_cubic
