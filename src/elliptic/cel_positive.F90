!> Bulirsch's general complete elliptic integral with positive weights in two kinds: a tool of `bulirsch_cel`, of the
!> third kind, of zeta and of lambda.
module kyvadlo_cel_positive_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
#include "cel_positive.inc"
end module kyvadlo_cel_positive_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_cel_positive_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
#include "cel_positive.inc"
end module kyvadlo_cel_positive_real128
#endif

module kyvadlo_cel_positive
   use kyvadlo_cel_positive_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_cel_positive_real128
#endif
   implicit none
   public
end module kyvadlo_cel_positive
