!> Bulirsch's general complete elliptic integral in two kinds, a tool of the third kind, of zeta and of lambda.
module kyvadlo_bulirsch_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, real128
#include "bulirsch.inc"
end module kyvadlo_bulirsch_real64

module kyvadlo_bulirsch_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, real128
#include "bulirsch.inc"
end module kyvadlo_bulirsch_real128

module kyvadlo_bulirsch
   use kyvadlo_bulirsch_real64
   use kyvadlo_bulirsch_real128
   implicit none
   public
end module kyvadlo_bulirsch
