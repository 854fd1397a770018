!> Principal values of Carlson's RJ near their zero, in pairs of numbers of real64 and real128 (real32 takes real64).
module kyvadlo_carlson_rj_pair_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_carlson_rd_real64, only: rj_series
   use kyvadlo_two_part_real64, only: pair_type, pair, value, two_sum, two_product, operator(+), &
      operator(-), operator(*), operator(/), sqrt
#include "carlson_rj_pair.inc"
end module kyvadlo_carlson_rj_pair_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_carlson_rj_pair_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_carlson_rd_real128, only: rj_series
   use kyvadlo_two_part_real128, only: pair_type, pair, value, two_sum, two_product, operator(+), &
      operator(-), operator(*), operator(/), sqrt
#include "carlson_rj_pair.inc"
end module kyvadlo_carlson_rj_pair_real128
#endif

module kyvadlo_carlson_rj_pair
   use kyvadlo_carlson_rj_pair_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_carlson_rj_pair_real128
#endif
   implicit none
   public
end module kyvadlo_carlson_rj_pair
