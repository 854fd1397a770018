!> Three-part arithmetic: sums high + low + lowest with three times the digits of real64, under the names of
!> `two_part.inc`, so that what is written for pairs can be compiled for these too. For the constants that long times
!> multiply where the place is wanted in double-double.
module kyvadlo_three_part
   use, intrinsic :: iso_fortran_env, only: pk => real64
   use kyvadlo_double_doubles, only: two_parts => pair_type, exact_sum => two_sum, exact_product => two_product, &
      scaled_real => scaled
   implicit none
   private
   public :: pair_type, pair, two_sum, two_difference, two_product, value, scaled, by_power_of_two
   public :: pi_pair, root_two_pair, parts
   public :: lead, left_out, assignment(=)
   public :: operator(+), operator(-), operator(*), operator(/), operator(<), operator(<=), sqrt, root_of_quotient

   !> An unevaluated sum, each part at most an ulp of the one before.
   type :: pair_type
      real(pk) :: high = 0.0_pk
      real(pk) :: low = 0.0_pk
      real(pk) :: lowest = 0.0_pk
   end type pair_type

   integer, parameter :: parts = 3
   type(pair_type), parameter :: pi_pair = pair_type(3.141592653589793_pk, 1.2246467991473532e-16_pk, &
      -2.9947698097183397e-33_pk)
   type(pair_type), parameter :: root_two_pair = pair_type(1.4142135623730951_pk, -9.667293313452913e-17_pk, &
      4.1386753086994136e-33_pk)

   interface value
      module procedure value_of_triple
   end interface value
   interface scaled
      module procedure scaled_triple, scaled_number
   end interface scaled
   interface assignment(=)
      module procedure real_from_triple, triple_from_real
   end interface assignment(=)
   interface sqrt
      module procedure sqrt_triple
   end interface sqrt
   interface operator(+)
      module procedure add_triples, add_triple_real
   end interface operator(+)
   interface operator(-)
      module procedure subtract_triples, negate_triple
   end interface operator(-)
   interface operator(*)
      module procedure multiply_triples, multiply_triple_real
   end interface operator(*)
   interface operator(/)
      module procedure divide_triples
   end interface operator(/)
   interface operator(<)
      module procedure is_less
   end interface operator(<)
   interface operator(<=)
      module procedure is_less_or_equal
   end interface operator(<=)

contains

   !> The number x; exact.
   elemental type(pair_type) function pair(x) result(p)
      real(pk), intent(in) :: x

      p%high = x
   end function pair

   !> Rounded to one number.
   elemental real(pk) function value_of_triple(p) result(x)
      type(pair_type), intent(in) :: p

      x = p%high + (p%low + p%lowest)
   end function value_of_triple

   !> Times 2**power; exact unless it leaves the range.
   elemental type(pair_type) function scaled_triple(p, power) result(r)
      type(pair_type), intent(in) :: p
      integer, intent(in) :: power

      r = pair_type(scaled_real(p%high, power), scaled_real(p%low, power), scaled_real(p%lowest, power))
   end function scaled_triple

   elemental real(pk) function scaled_number(x, power) result(r)
      real(pk), intent(in) :: x
      integer, intent(in) :: power

      r = scaled_real(x, power)
   end function scaled_number

   !> Times a power of 2 given as a number.
   elemental type(pair_type) function by_power_of_two(p, factor) result(r)
      type(pair_type), intent(in) :: p
      real(pk), intent(in) :: factor  !! 2**n

      r = pair_type(p%high*factor, p%low*factor, p%lowest*factor)
   end function by_power_of_two

   !> The leading part.
   elemental real(pk) function lead(p) result(x)
      type(pair_type), intent(in) :: p

      x = p%high
   end function lead

   !> Its square is what a series may leave out.
   elemental real(pk) function left_out(mold) result(tolerance)
      type(pair_type), intent(in) :: mold

      tolerance = epsilon(mold%high)*sqrt(epsilon(mold%high))
   end function left_out

   !> a + b, exact.
   elemental type(pair_type) function two_sum(a, b) result(s)
      real(pk), intent(in) :: a, b
      type(two_parts) :: sum

      sum = exact_sum(a, b)
      s = pair_type(sum%high, sum%low)
   end function two_sum

   !> a - b, exact.
   elemental type(pair_type) function two_difference(a, b) result(s)
      real(pk), intent(in) :: a, b

      s = two_sum(a, -b)
   end function two_difference

   !> a b, exact where that of `two_part.inc` is.
   elemental type(pair_type) function two_product(a, b) result(p)
      real(pk), intent(in) :: a, b
      type(two_parts) :: product

      product = exact_product(a, b)
      p = pair_type(product%high, product%low)
   end function two_product

   !> a + b + c, of which b and c may be as large as a where digits cancelled, carried over.
   elemental type(pair_type) function carried(a, b, c) result(s)
      real(pk), intent(in) :: a, b, c
      type(two_parts) :: upper, lower

      lower = exact_sum(b, c)
      upper = exact_sum(a, lower%high)
      s%high = upper%high
      lower = exact_sum(upper%low, lower%low)
      upper = exact_sum(s%high, lower%high)
      s = pair_type(upper%high, upper%low, lower%low)
   end function carried

   !> The same for numbers each below 2**-50 of the one before.
   elemental type(pair_type) function ordered(a, b, c) result(s)
      real(pk), intent(in) :: a, b, c
      real(pk) :: upper, lower

      lower = (b) + (c)
      upper = (c) - (lower - (b))
      s%high = (a) + (lower)
      lower = (lower) - (s%high - (a))
      s%low = (lower) + (upper)
      s%lowest = (upper) - (s%low - (lower))
   end function ordered

   !> Sum with an error of a few units of 2**-158, also where the high parts cancel.
   elemental type(pair_type) function add_triples(a, b) result(s)
      type(pair_type), intent(in) :: a, b
      type(two_parts) :: high, low, lowest, middle, last

      high = exact_sum(a%high, b%high)
      low = exact_sum(a%low, b%low)
      lowest = exact_sum(a%lowest, b%lowest)
      middle = exact_sum(low%high, high%low)
      last = exact_sum(lowest%high, low%low)
      low = exact_sum(last%high, middle%low)
      s = carried(high%high, middle%high, low%high)
      if (abs(s%high) < abs(high%high)/2 .or. .not. abs(high%high) > 0) then
         ! Digits cancelled: what was beyond the third part counts.
         s = carried(s%high, s%low, s%lowest + (low%low + (last%low + lowest%low)))
      else
         s%lowest = s%lowest + (low%low + (last%low + lowest%low))
      end if
   end function add_triples

   elemental type(pair_type) function add_triple_real(a, b) result(s)
      type(pair_type), intent(in) :: a
      real(pk), intent(in) :: b

      s = add_triples(a, pair_type(b, 0.0_pk, 0.0_pk))
   end function add_triple_real

   elemental type(pair_type) function negate_triple(a) result(r)
      type(pair_type), intent(in) :: a

      r = pair_type(-a%high, -a%low, -a%lowest)
   end function negate_triple

   elemental type(pair_type) function subtract_triples(a, b) result(s)
      type(pair_type), intent(in) :: a, b

      s = add_triples(a, negate_triple(b))
   end function subtract_triples

   !> Product with a relative error of a few units of 2**-156.
   elemental type(pair_type) function multiply_triples(a, b) result(p)
      type(pair_type), intent(in) :: a, b
      type(two_parts) :: high, left, right, middle, sum
      real(pk) :: rest

      high = exact_product(a%high, b%high)
      left = exact_product(a%high, b%low)
      right = exact_product(a%low, b%high)
      middle = exact_sum(left%high, right%high)
      sum = exact_sum(middle%high, high%low)
      rest = (a%high*b%lowest + a%low*b%low) + a%lowest*b%high
      p = ordered(high%high, sum%high, rest + ((left%low + right%low) + (middle%low + sum%low)))
   end function multiply_triples

   elemental type(pair_type) function multiply_triple_real(a, b) result(p)
      type(pair_type), intent(in) :: a
      real(pk), intent(in) :: b
      type(two_parts) :: high, low, sum

      high = exact_product(a%high, b)
      low = exact_product(a%low, b)
      sum = exact_sum(high%low, low%high)
      p = ordered(high%high, sum%high, sum%low + (low%low + a%lowest*b))
   end function multiply_triple_real

   !> Quotient by long division; 0/b is 0 for b > 0.
   elemental type(pair_type) function divide_triples(a, b) result(q)
      type(pair_type), intent(in) :: a, b
      type(two_parts) :: high, low, left, right, rest, last
      real(pk) :: first, second, beyond

      first = a%high/b%high
      high = exact_product(b%high, first)
      low = exact_product(b%low, first)
      left = exact_sum(a%high - high%high, a%low)   ! The difference is exact
      right = exact_sum(-high%low, -low%high)
      rest = exact_sum(left%high, right%high)
      beyond = rest%low + ((left%low + right%low) + ((a%lowest - low%low) - b%lowest*first))
      second = rest%high/b%high
      last = exact_product(b%high, second)
      q = ordered(first, second, (((rest%high - last%high) - last%low) + (beyond - b%low*second))/b%high)
   end function divide_triples

   !> Square root by two Newton corrections.
   elemental type(pair_type) function sqrt_triple(a) result(r)
      type(pair_type), intent(in) :: a
      type(two_parts) :: square, rest, sum, last
      real(pk) :: first, second, beyond

      first = sqrt(a%high)
      if (.not. first > 0) then
         r = pair(first)
         return
      end if
      square = exact_product(first, first)
      rest = exact_sum(a%high - square%high, -square%low)   ! The difference is exact
      sum = exact_sum(rest%high, a%low)
      beyond = sum%low + (rest%low + a%lowest)
      second = sum%high/(2*first)
      last = exact_product(2*first, second)
      r = ordered(first, second, (((sum%high - last%high) - last%low) + (beyond - second*second))/(2*first))
   end function sqrt_triple

   elemental type(pair_type) function root_of_quotient(a, b) result(r)
      type(pair_type), intent(in) :: a, b

      r = sqrt_triple(divide_triples(a, b))
   end function root_of_quotient

   elemental logical function is_less(a, b) result(less)
      type(pair_type), intent(in) :: a, b
      type(pair_type) :: difference

      difference = subtract_triples(a, b)
      less = difference%high < 0
   end function is_less

   elemental logical function is_less_or_equal(a, b) result(less)
      type(pair_type), intent(in) :: a, b
      type(pair_type) :: difference

      difference = subtract_triples(a, b)
      less = difference%high <= 0
   end function is_less_or_equal

   elemental subroutine real_from_triple(x, p)
      real(pk), intent(out) :: x
      type(pair_type), intent(in) :: p

      x = value_of_triple(p)
   end subroutine real_from_triple

   elemental subroutine triple_from_real(p, x)
      type(pair_type), intent(out) :: p
      real(pk), intent(in) :: x

      p = pair_type(x, 0.0_pk, 0.0_pk)
   end subroutine triple_from_real
end module kyvadlo_three_part
