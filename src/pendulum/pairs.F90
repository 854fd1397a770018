!> The arithmetic in pairs of numbers for the exact motion: a copy of `kyvadlo_two_part` that is compiled in one unit
!> with the set-up of orbits (`src/unit_orbit.F90`).
module kyvadlo_pairs_real64
   use, intrinsic :: iso_fortran_env, only: pk => real64
#include "../arithmetic/two_part.inc"
end module kyvadlo_pairs_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_pairs_real128
   use, intrinsic :: iso_fortran_env, only: pk => real128
#include "../arithmetic/two_part.inc"
end module kyvadlo_pairs_real128
#endif

module kyvadlo_pairs
   use kyvadlo_pairs_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_pairs_real128, pair_type_real128 => pair_type, pi_pair_real128 => pi_pair, &
      root_two_pair_real128 => root_two_pair
#endif
   implicit none
   public
end module kyvadlo_pairs
