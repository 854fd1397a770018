!> Reduction by the quarter period in two parts, in real64 and real128 (real32 takes real64).
module kyvadlo_quarter_period_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_two_part_real64, only: pair_type, pair, pi_pair, value, scaled, by_power_of_two, two_difference, &
      operator(-), operator(+), operator(*), operator(/), sqrt
#include "quarter_period.inc"
end module kyvadlo_quarter_period_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_quarter_period_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_two_part_real128, only: pair_type, pair, pi_pair, value, scaled, by_power_of_two, two_difference, &
      operator(-), operator(+), operator(*), operator(/), sqrt
#include "quarter_period.inc"
end module kyvadlo_quarter_period_real128
#endif
