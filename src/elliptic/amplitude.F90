!> Reduction of the amplitude of an incomplete elliptic integral, in two kinds.
module kyvadlo_amplitude_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_two_part_real64, only: pair_type, pair, value, two_difference, two_product, by_power_of_two, &
      operator(+), operator(-), operator(*), operator(/), sqrt
#include "amplitude.inc"
end module kyvadlo_amplitude_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_amplitude_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_two_part_real128, only: pair_type, pair, value, two_difference, two_product, by_power_of_two, &
      operator(+), operator(-), operator(*), operator(/), sqrt
#include "amplitude.inc"
end module kyvadlo_amplitude_real128
#endif

module kyvadlo_amplitude
   use kyvadlo_amplitude_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_amplitude_real128
#endif
   implicit none
   public
end module kyvadlo_amplitude
