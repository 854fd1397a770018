!> Complete elliptic integrals of the first and second kind K, E and their parts D, B in three kinds.
!>
!> real64 evaluates polynomials, real32 the same ones, real128 the arithmetic-geometric mean.
module kyvadlo_complete_polynomials
   use, intrinsic :: iso_fortran_env, only: wp => real64, int64
   use kyvadlo_numbers_real64, only: quiet_nan, infinity
#include "complete_polynomials.inc"
end module kyvadlo_complete_polynomials

#ifndef KYVADLO_NO_REAL128
module kyvadlo_complete_mean
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_numbers_real128, only: quiet_nan, infinity
   use kyvadlo_nome_real128, only: log_nome
   use kyvadlo_two_part_real128, only: pair_type, pi_pair, pair, value, scaled, by_power_of_two, two_sum, &
      two_difference, operator(+), operator(-), operator(*), operator(/), sqrt
#include "complete_mean.inc"
end module kyvadlo_complete_mean
#endif

module kyvadlo_complete_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, inner => real64
   use kyvadlo_complete_polynomials, only: first_kind, second_kind, d_kind, b_kind
#include "complete.inc"
end module kyvadlo_complete_real32

module kyvadlo_complete_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, inner => real64
   use kyvadlo_complete_polynomials, only: first_kind, second_kind, d_kind, b_kind
#include "complete.inc"
end module kyvadlo_complete_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_complete_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, inner => real128
   use kyvadlo_complete_mean, only: first_kind, second_kind, d_kind, b_kind
#include "complete.inc"
end module kyvadlo_complete_real128
#endif

module kyvadlo_complete
   use kyvadlo_complete_real32
   use kyvadlo_complete_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_complete_real128
#endif
   implicit none
   public
end module kyvadlo_complete
