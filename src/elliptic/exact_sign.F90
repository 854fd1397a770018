!> The exact sign of a sum of products, in real64 and real128.
module kyvadlo_exact_sign_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_two_part, only:  ! for fpm, which does not look into what is included
#include "exact_sign.inc"
end module kyvadlo_exact_sign_real64

#define pair_type pair_type_real128
#define monomial_type monomial_type_real128
module kyvadlo_exact_sign_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
#include "exact_sign.inc"
end module kyvadlo_exact_sign_real128
#undef pair_type
#undef monomial_type

module kyvadlo_exact_sign
   use kyvadlo_exact_sign_real64
   use kyvadlo_exact_sign_real128
   implicit none
   public
end module kyvadlo_exact_sign
