!> The cubic (5) of the spherical pendulum as gaps between its roots and the poles, from every kind of input.
!>
!> (5)-(11), [S6.1], [S6.4]. `wp` is the caller's kind, `cp` the kind that computes: real32 computes in real64.
module kyvadlo_gaps_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, cp => real64
   use kyvadlo_numbers_real32, only: is_finite, is_nan
   use kyvadlo_status, only: error_type, fail, code_domain
   use kyvadlo_pairs_real64
#include "gaps.inc"
#include "gaps_energy.inc"
#include "gaps_state.inc"
end module kyvadlo_gaps_real32

module kyvadlo_gaps_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, cp => real64
   use kyvadlo_numbers_real64, only: is_finite, is_nan
   use kyvadlo_status, only: error_type, fail, code_domain
   use kyvadlo_pairs_real64
#include "gaps.inc"
#include "gaps_energy.inc"
#include "gaps_state.inc"
end module kyvadlo_gaps_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_gaps_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, cp => real128
   use kyvadlo_numbers_real128, only: is_finite, is_nan
   use kyvadlo_status, only: error_type, fail, code_domain
   use kyvadlo_pairs_real128
#include "gaps.inc"
#include "gaps_energy.inc"
#include "gaps_state.inc"
end module kyvadlo_gaps_real128
#endif
