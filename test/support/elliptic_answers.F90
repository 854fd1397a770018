!> The questions of the reference files of elliptic functions, answered by the library in three kinds.
module elliptic_answers_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
#include "elliptic_answers.inc"
end module elliptic_answers_real32

module elliptic_answers_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
#include "elliptic_answers.inc"
end module elliptic_answers_real64

#ifndef KYVADLO_NO_REAL128
module elliptic_answers_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
#include "elliptic_answers.inc"
end module elliptic_answers_real128
#endif

module elliptic_answers
   use elliptic_answers_real32
   use elliptic_answers_real64
#ifndef KYVADLO_NO_REAL128
   use elliptic_answers_real128
#endif
   implicit none
   public
end module elliptic_answers
