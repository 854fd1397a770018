!> What `kyvadlo eval` computes, in three kinds.
module kyvadlo_eval_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, dk => real64
   use kyvadlo, orbit_type_real64 => orbit_type, orbit_type => orbit_type_real32, error_type => kyvadlo_error_type
   use kyvadlo, only: slopes_type => derivatives_type
   use kyvadlo_numbers_real32, only: infinity
#include "eval.inc"
end module kyvadlo_eval_real32

module kyvadlo_eval_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, dk => real64
   use kyvadlo, error_type => kyvadlo_error_type
   use kyvadlo, only: slopes_type => derivatives_type
   use kyvadlo_numbers_real64, only: infinity
#include "eval.inc"
end module kyvadlo_eval_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_eval_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, dk => real128
   use kyvadlo, orbit_type_real64 => orbit_type, orbit_type => orbit_type_real128, error_type => kyvadlo_error_type
   use kyvadlo, only: slopes_type => derivatives_type_real128
   use kyvadlo_numbers_real128, only: infinity
#include "eval.inc"
end module kyvadlo_eval_real128
#endif

module kyvadlo_eval
   use kyvadlo_eval_real32
   use kyvadlo_eval_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_eval_real128
#endif
   implicit none
   public
end module kyvadlo_eval
