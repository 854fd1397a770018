!> Two-part ("double-word") arithmetic: sums high + low with twice the digits of a kind, for the constants that long
!> times multiply and for differences that must not lose digits. Pure value arithmetic.
!> Parentheses around a product or an argument are not idle: no compiler may fuse across them (gfortran's
!> -fprotect-parens), so that the digits hold where products and sums are contracted, as by -march=native in fpm.
!>
!> Callers that are to have it inlined are compiled in one unit with it (`src/unit_arithmetic.F90`,
!> `src/unit_orbit.F90`).
!>
!> There is no real32 instance: what real32 needs beyond its digits is computed in real64.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    __FINITE_MATH_ONLY__ + 0 == 1
#error "kyvadlo cannot be compiled with -ffast-math, -Ofast or a part of them: (x + big) - big would become x"
#endif

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
