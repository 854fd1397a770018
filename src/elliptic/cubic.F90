!> The real roots of a cubic in the three kinds. real32 is computed in real64: deciding exactly needs four times the digits
!> of the coefficients below one another, for which real32 has no room in its exponents.
module kyvadlo_cubic_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, xp => real64
   use kyvadlo_exact_sign, only:  ! for fpm, which does not look into what is included
   use kyvadlo_two_part, only:  ! for fpm, which does not look into what is included
#include "cubic.inc"
end module kyvadlo_cubic_real32

module kyvadlo_cubic_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, xp => real64
#include "cubic.inc"
end module kyvadlo_cubic_real64

#define pair_type pair_type_real128
module kyvadlo_cubic_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, xp => real128
#include "cubic.inc"
end module kyvadlo_cubic_real128
#undef pair_type

module kyvadlo_cubic
   use kyvadlo_cubic_real32
   use kyvadlo_cubic_real64
   use kyvadlo_cubic_real128
   implicit none
   public
end module kyvadlo_cubic
