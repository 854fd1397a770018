!> The exact sign of a sum of products, in real64 and real128.
module kyvadlo_exact_sign_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_two_part_real64, only: pair_type, two_sum, two_product
#include "exact_sign.inc"
end module kyvadlo_exact_sign_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_exact_sign_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_two_part_real128, only: pair_type, two_sum, two_product
#include "exact_sign.inc"
end module kyvadlo_exact_sign_real128
#endif

module kyvadlo_exact_sign
   use kyvadlo_exact_sign_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_exact_sign_real128, monomial_type_real128 => monomial_type
#endif
   implicit none
   public
end module kyvadlo_exact_sign
