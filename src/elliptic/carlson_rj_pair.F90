!> Principal values of Carlson's RJ near their zero, in pairs of numbers of real64 and real128 (real32 takes real64).
module kyvadlo_carlson_rj_pair_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_carlson_rd, only:  ! for fpm, which does not look into what is included
   use kyvadlo_two_part, only:  ! for fpm, which does not look into what is included
#include "carlson_rj_pair.inc"
end module kyvadlo_carlson_rj_pair_real64

#define pair_type pair_type_real128
module kyvadlo_carlson_rj_pair_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
#include "carlson_rj_pair.inc"
end module kyvadlo_carlson_rj_pair_real128
#undef pair_type

module kyvadlo_carlson_rj_pair
   use kyvadlo_carlson_rj_pair_real64
   use kyvadlo_carlson_rj_pair_real128
   implicit none
   public
end module kyvadlo_carlson_rj_pair
