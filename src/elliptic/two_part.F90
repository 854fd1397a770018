!> Two-part ("double-word") arithmetic: sums high + low with twice the digits of a kind, for the constants that long times
!> multiply and for differences that must not lose digits. Pure value arithmetic; compile without contraction.
!>
!> The set-up of orbits includes the procedures for itself (`two_part_procedures.inc`), so that the compiler sees them in
!> one file with their callers and inlines them: a quarter of its time.
!>
!> There is no real32 instance: what real32 needs beyond its digits is computed in real64.
module kyvadlo_two_part_real64
   use, intrinsic :: iso_fortran_env, only: pk => real64
#include "two_part.inc"
end module kyvadlo_two_part_real64

#define pair_type pair_type_real128
#define pi_pair pi_pair_real128
#define root_two_pair root_two_pair_real128
module kyvadlo_two_part_real128
   use, intrinsic :: iso_fortran_env, only: pk => real128
#include "two_part.inc"
end module kyvadlo_two_part_real128
#undef pair_type
#undef pi_pair
#undef root_two_pair

module kyvadlo_two_part
   use kyvadlo_two_part_real64
   use kyvadlo_two_part_real128
   implicit none
   public
end module kyvadlo_two_part
