!> Carlson's integral of the third kind RJ in the three kinds.
module kyvadlo_carlson_rj_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, xp => real64
   use kyvadlo_carlson_rc, only:  ! for fpm, which does not look into what is included
   use kyvadlo_carlson_rd, only:  ! for fpm, which does not look into what is included
   use kyvadlo_carlson_rf, only:  ! for fpm, which does not look into what is included
   use kyvadlo_carlson_rj_pair, only:  ! for fpm, which does not look into what is included
#include "carlson_rj.inc"
end module kyvadlo_carlson_rj_real32

module kyvadlo_carlson_rj_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, xp => real64
#include "carlson_rj.inc"
end module kyvadlo_carlson_rj_real64

module kyvadlo_carlson_rj_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, xp => real128
#include "carlson_rj.inc"
end module kyvadlo_carlson_rj_real128

module kyvadlo_carlson_rj
   use kyvadlo_carlson_rj_real32
   use kyvadlo_carlson_rj_real64
   use kyvadlo_carlson_rj_real128
   implicit none
   public
end module kyvadlo_carlson_rj
