!> Pairs of real64 with the operators of reals, so that what is written for a real kind can be compiled for them too.
module kyvadlo_double_double_numbers
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_double_doubles
   implicit none
   private
   public :: pair_type, assignment(=), operator(+), operator(-), operator(*), operator(/), operator(**)
   public :: operator(<), operator(>), operator(>=), sqrt, abs, sum

   interface assignment(=)
      module procedure pair_from_integer
   end interface assignment(=)
   interface operator(+)
      module procedure integer_plus, real_plus
   end interface operator(+)
   interface operator(-)
      module procedure integer_minus, minus_integer
   end interface operator(-)
   interface operator(*)
      module procedure integer_times, times_integer, real_times
   end interface operator(*)
   interface operator(/)
      module procedure integer_over, over_integer
   end interface operator(/)
   interface operator(**)
      module procedure power
   end interface operator(**)
   interface operator(>)
      module procedure is_greater, is_greater_than_real
   end interface operator(>)
   interface operator(>=)
      module procedure is_not_less
   end interface operator(>=)
   interface abs
      module procedure magnitude
   end interface abs
   interface sum
      module procedure total
   end interface sum

contains

   elemental subroutine pair_from_integer(p, n)
      type(pair_type), intent(out) :: p
      integer, intent(in) :: n

      p = pair(real(n, real64))
   end subroutine pair_from_integer

   elemental type(pair_type) function integer_plus(n, a) result(r)
      integer, intent(in) :: n
      type(pair_type), intent(in) :: a

      r = a + real(n, real64)
   end function integer_plus

   elemental type(pair_type) function real_plus(x, a) result(r)
      real(real64), intent(in) :: x
      type(pair_type), intent(in) :: a

      r = a + x
   end function real_plus

   elemental type(pair_type) function integer_minus(n, a) result(r)
      integer, intent(in) :: n
      type(pair_type), intent(in) :: a

      r = (-a) + real(n, real64)
   end function integer_minus

   elemental type(pair_type) function minus_integer(a, n) result(r)
      type(pair_type), intent(in) :: a
      integer, intent(in) :: n

      r = a + (-real(n, real64))
   end function minus_integer

   elemental type(pair_type) function integer_times(n, a) result(r)
      integer, intent(in) :: n
      type(pair_type), intent(in) :: a

      r = a*real(n, real64)
   end function integer_times

   elemental type(pair_type) function times_integer(a, n) result(r)
      type(pair_type), intent(in) :: a
      integer, intent(in) :: n

      r = a*real(n, real64)
   end function times_integer

   elemental type(pair_type) function real_times(x, a) result(r)
      real(real64), intent(in) :: x
      type(pair_type), intent(in) :: a

      r = a*x
   end function real_times

   elemental type(pair_type) function integer_over(n, a) result(r)
      integer, intent(in) :: n
      type(pair_type), intent(in) :: a

      r = pair(real(n, real64))/a
   end function integer_over

   elemental type(pair_type) function over_integer(a, n) result(r)
      type(pair_type), intent(in) :: a
      integer, intent(in) :: n

      r = a/pair(real(n, real64))
   end function over_integer

   !> a**2 and a**4.
   elemental type(pair_type) function power(a, n) result(r)
      type(pair_type), intent(in) :: a
      integer, intent(in) :: n

      r = a*a
      if (n == 4) r = r*r
   end function power

   elemental logical function is_greater(a, b)
      type(pair_type), intent(in) :: a, b

      is_greater = b < a
   end function is_greater

   elemental logical function is_greater_than_real(a, x)
      type(pair_type), intent(in) :: a
      real(real64), intent(in) :: x

      is_greater_than_real = a%high > x
   end function is_greater_than_real

   elemental logical function is_not_less(a, b)
      type(pair_type), intent(in) :: a, b

      is_not_less = .not. a < b
   end function is_not_less

   elemental type(pair_type) function magnitude(a) result(r)
      type(pair_type), intent(in) :: a

      r = a
      if (a%high < 0) r = -a
   end function magnitude

   pure type(pair_type) function total(a) result(r)
      type(pair_type), intent(in) :: a(:)
      integer :: i

      r = pair(0.0_real64)
      do i = 1, size(a)
         r = r + a(i)
      end do
   end function total
end module kyvadlo_double_double_numbers
