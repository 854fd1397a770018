!> Angles in double-double arithmetic, in quarter turns.
module kyvadlo_double_double_angle
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_double_doubles, only: pair_type
   implicit none
   private
   public :: quarter_turns

contains

   !> The angle of (x, y): that of double precision, corrected by the sine of what it misses.
   elemental type(pair_type) function quarter_turns(y, x) result(turns)
      type(pair_type), intent(in) :: y, x
      type(pair_type) :: sine, cosine, old
      real(real64) :: first, whole
      real(real64), parameter :: per_radian = 2/acos(-1.0_real64)
      integer :: quarter

      first = atan2(y%high, x%high)*per_radian
      whole = anint(first)
      call sine_and_cosine(pair_type(first - whole, 0.0_real64), sine, cosine)
      do quarter = 1, modulo(nint(whole), 4)
         old = sine
         sine = cosine
         cosine = minus(old)
      end do
      old = sum_of_products(y, cosine, minus(x), sine)
      turns = sum_of_products(x, cosine, y, sine)
      turns = two_sum(first, old%high/turns%high*per_radian)
   end function quarter_turns

#include "double_double_arithmetic.inc"
#define without_hyperbolic_functions
#include "double_double_polynomials.inc"
#undef without_hyperbolic_functions
end module kyvadlo_double_double_angle
