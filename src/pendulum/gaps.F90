!> The cubic (5) of the spherical pendulum as gaps between its roots and the poles, from every kind of input.
!>
!> (5)-(11), [S6.1], [S6.4]. `wp` is the caller's kind, `cp` the kind that computes: real32 computes in real64.
module kyvadlo_gaps_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, cp => real64
   use kyvadlo_status, only:  ! for fpm, which does not look into what is included
   use kyvadlo_two_part, only:  ! for fpm, which does not look into what is included
#define gaps_type gaps_type_real32
#include "gaps.inc"
#include "gaps_energy.inc"
#include "gaps_state.inc"
#undef gaps_type
end module kyvadlo_gaps_real32

module kyvadlo_gaps_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, cp => real64
#include "gaps.inc"
#include "gaps_energy.inc"
#include "gaps_state.inc"
end module kyvadlo_gaps_real64

#define pair_type pair_type_real128
#define pi_pair pi_pair_real128
#define root_two_pair root_two_pair_real128
module kyvadlo_gaps_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, cp => real128
#define gaps_type gaps_type_real128
#include "gaps.inc"
#include "gaps_energy.inc"
#include "gaps_state.inc"
#undef gaps_type
end module kyvadlo_gaps_real128
#undef pair_type
#undef pi_pair
#undef root_two_pair
