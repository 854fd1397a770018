!> Bulirsch's general complete elliptic integral in two kinds, a tool of the third kind, of zeta and of lambda.
module kyvadlo_bulirsch_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
#include "bulirsch.inc"
end module kyvadlo_bulirsch_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_bulirsch_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
#include "bulirsch.inc"
end module kyvadlo_bulirsch_real128
#endif

module kyvadlo_bulirsch
   use kyvadlo_bulirsch_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_bulirsch_real128
#endif
   implicit none
   public
end module kyvadlo_bulirsch
