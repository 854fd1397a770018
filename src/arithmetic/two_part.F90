!> Two-part ("double-word") arithmetic: sums high + low with twice the digits of a kind, for the constants that long times
!> multiply and for differences that must not lose digits. Pure value arithmetic; compile without contraction.
!>
!> Callers that are to have it inlined are compiled in one unit with it (`src/unit_arithmetic.F90`, `src/unit_orbit.F90`).
!>
!> There is no real32 instance: what real32 needs beyond its digits is computed in real64.
module kyvadlo_two_part_real64
   use, intrinsic :: iso_fortran_env, only: pk => real64
#include "two_part.inc"
end module kyvadlo_two_part_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_two_part_real128
   use, intrinsic :: iso_fortran_env, only: pk => real128
#include "two_part.inc"
end module kyvadlo_two_part_real128
#endif

module kyvadlo_two_part
   use kyvadlo_two_part_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_two_part_real128, pair_type_real128 => pair_type, pi_pair_real128 => pi_pair, &
      root_two_pair_real128 => root_two_pair
#endif
   implicit none
   public
end module kyvadlo_two_part
