!> The shortest decimal text that reads back as a given double, fast: by whole numbers of two 62-bit digits, all
!> exact. (Numbers of 128 bits, where a compiler has them, are no faster.)
!>
!> A double is m 2**e. Times a power of ten its rounding interval, from half a unit below to half a unit above, has ends
!> that are whole numbers over a power of two; the text sought is the multiple of the largest power of ten between them,
!> of several the one nearest to the value. (The principle of Steele and White, PLDI 1990, as Adams, PLDI 2018, uses
!> it.)
module kyvadlo_decimal
   use, intrinsic :: iso_fortran_env, only: int64, real64
   implicit none
   private
   public :: put_shortest, longest_decimal

   integer, parameter :: bits = digits(1.0_real64)
   !> The longest text: sign, 17 figures, point, exponent of three figures.
   integer, parameter :: longest_decimal = 24
   !> Magnitudes served. Below, the products would not fit into 125 bits: 55 of four times m, 70 of 5**30; above, the
   !> value times the power of ten would be a whole number already.
   real(real64), parameter :: smallest = 2.0_real64**(-46), largest = 2.0_real64**49
   !> Written out: the index of an implied loop would be a variable of the module.
   integer, parameter :: count_up(0:27) = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, &
      21, 22, 23, 24, 25, 26, 27]
   integer(int64), parameter :: powers_of_ten(0:18) = 10_int64**count_up(:18)
   !> A long number is two digits to the base 2**62; they are multiplied by halves, `pieces` of 31 bits.
   integer, parameter :: piece = 31
   integer(int64), parameter :: piece_mask = 2_int64**piece - 1, digit_mask = 2_int64**(2*piece) - 1
   integer(int64), parameter :: powers_of_five(0:27) = 5_int64**count_up
   !> 5**0 to 5**30, by their digits.
   integer(int64), parameter :: five_low(0:30) = [iand(powers_of_five, digit_mask), &
      359414837200037393_int64, 1797074186000186965_int64, 4373684911573546921_int64]
   integer(int64), parameter :: five_high(0:30) = [shiftr(powers_of_five, 2*piece), 8_int64, 40_int64, 201_int64]
   !> 00 01 02 ... 99
   character(len=*), parameter :: pairs = &
      '0001020304050607080910111213141516171819202122232425262728293031323334353637383940414243444546474849'// &
      '5051525354555657585960616263646566676869707172737475767778798081828384858687888990919293949596979899'

   type :: long_type
      integer(int64) :: high = 0, low = 0
   end type long_type

contains

   !> Writes the text of a value into the first `length` places: `-1.5e+00`, as `shortest_text` does. `length` is 0
   !> where this does not serve: zero, infinities, NaN, and magnitudes below 1.5e-14 or above 5.6e14.
   pure subroutine put_shortest(value, text, length)
      real(real64), intent(in) :: value
      character(len=*), intent(inout) :: text    !! At least `longest_decimal` places
      integer, intent(out) :: length
      type(long_type) :: five, product, bound
      integer(int64) :: m, centre, above, below, lowest, highest, high, first, number, unit
      integer :: power, order, scaling, shift, zeros, count
      logical :: is_even, is_power_of_two, is_half, ends_above, ends_below

      length = 0
      if (value /= value) return
      if (.not. (abs(value) >= smallest .and. abs(value) < largest)) return
      ! m and e from the bits: the functions of the language are calls.
      m = transfer(value, m)
      power = int(ibits(m, bits - 1, 11)) - (maxexponent(value) - 1)   ! value is 1 to 2 times 2**power
      m = ior(ibits(m, 0, bits - 1), shiftl(1_int64, bits - 1))
      order = shifta(78913*power, 18)                     ! that of the value, or one less, by log10(2): -14 to 14
      scaling = 16 - order                                ! value*10**scaling has 17 or 18 figures
      shift = bits - 1 - power - scaling                  ! 2 m 5**scaling/2**shift is four times that
      is_even = iand(m, 1_int64) == 0
      ! Below a power of two the interval is half as long.
      is_power_of_two = m == 2_int64**(bits - 1)
      if (is_power_of_two) then
         m = 2*m
         shift = shift + 1
      end if
      five = long_type(five_high(scaling), five_low(scaling))
      product = times(2*m, five)
      call divide(product, shift, centre, is_half)
      bound = plus(product, five)
      if (is_power_of_two) bound = plus(bound, five)
      call divide(bound, shift, above, ends_above)
      call divide(minus(product, five), shift, below, ends_below)

      ! Whole numbers in the interval; its ends belong to it where a tie is rounded to this value.
      first = shiftr(centre, 1)
      highest = shiftr(above, 1)
      if (.not. is_even .and. ends_above .and. iand(above, 1_int64) == 0) highest = highest - 1
      lowest = shiftr(below, 1)
      if (.not. (is_even .and. ends_below .and. iand(below, 1_int64) == 0)) lowest = lowest + 1

      ! Step by step: a division by a constant is a multiplication, one by a power that is looked up is not.
      zeros = 0
      do while (zeros < 17)
         high = highest/10
         if (high < (lowest + 9)/10) exit
         highest = high
         lowest = (lowest + 9)/10
         first = first/10
         zeros = zeros + 1
      end do
      unit = powers_of_ten(zeros)
      number = first
      if (first < lowest) then
         number = first + 1
      else if (first < highest) then
         ! Twice the distance from the lower one, against the distance of the two.
         centre = centre - 2*(first*unit)
         if (centre > unit .or. (centre == unit .and. .not. (is_half .and. iand(first, 1_int64) == 0))) &
            number = first + 1
      end if

      count = max(1, 16 - zeros)
      do while (count < 18)
         if (number < powers_of_ten(count)) exit
         count = count + 1
      end do
      if (value < 0) then
         length = 1
         text(1:1) = '-'
      end if
      call put_figures(number, count, text(length + 1:length + count + 1))
      text(length + 1:length + 1) = text(length + 2:length + 2)
      if (count > 1) then
         text(length + 2:length + 2) = '.'
         length = length + count + 1
      else
         length = length + 1
      end if
      order = count - 1 + zeros - scaling
      text(length + 1:length + 2) = merge('e-', 'e+', order < 0)
      order = abs(order)
      text(length + 3:length + 4) = pairs(2*order + 1:2*order + 2)
      length = length + 4
   end subroutine put_shortest

   pure type(long_type) function times(factor, long)
      integer(int64), intent(in) :: factor      !! Below 2**56
      type(long_type), intent(in) :: long       !! Below 2**70
      integer(int64) :: factor_low, factor_high, long_low, long_middle, low, middle

      factor_low = iand(factor, piece_mask)
      factor_high = shiftr(factor, piece)
      long_low = iand(long%low, piece_mask)
      long_middle = shiftr(long%low, piece)
      low = factor_low*long_low
      middle = factor_low*long_middle + factor_high*long_low + shiftr(low, piece)
      times%high = factor_low*long%high + factor_high*long_middle + shiftl(factor_high*long%high, piece) &
         + shiftr(middle, piece)
      times%low = ior(iand(low, piece_mask), shiftl(iand(middle, piece_mask), piece))
   end function times

   pure type(long_type) function plus(a, b)
      type(long_type), intent(in) :: a, b
      integer(int64) :: low

      low = a%low + b%low
      plus = long_type(a%high + b%high + shiftr(low, 2*piece), iand(low, digit_mask))
   end function plus

   pure type(long_type) function minus(a, b)
      type(long_type), intent(in) :: a, b
      integer(int64) :: low

      low = a%low - b%low
      minus = long_type(a%high - b%high + shifta(low, 2*piece), iand(low, digit_mask))
   end function minus

   !> long/2**shift, cut off, and whether nothing was cut off.
   pure subroutine divide(long, shift, quotient, is_exact)
      type(long_type), intent(in) :: long
      integer, intent(in) :: shift              !! 1 to 69
      integer(int64), intent(out) :: quotient
      logical, intent(out) :: is_exact

      if (shift < 2*piece) then
         quotient = ior(shiftl(long%high, 2*piece - shift), shiftr(long%low, shift))
         is_exact = iand(long%low, shiftl(1_int64, shift) - 1) == 0
      else
         quotient = shiftr(long%high, shift - 2*piece)
         is_exact = long%low == 0 .and. iand(long%high, shiftl(1_int64, shift - 2*piece) - 1) == 0
      end if
   end subroutine divide

   !> The figures of a number, one place behind the begin of the text.
   pure subroutine put_figures(number, count, text)
      integer(int64), intent(in) :: number
      integer, intent(in) :: count
      character(len=*), intent(inout) :: text
      integer(int64) :: upper
      integer :: rest, next, at

      upper = number/1000000000_int64
      rest = int(number - upper*1000000000_int64)
      at = count + 1
      if (upper > 0) then
         ! Nine figures of the lower part, zeros included.
         do while (at > count - 7)
            next = rest/100
            rest = rest - 100*next
            text(at - 1:at) = pairs(2*rest + 1:2*rest + 2)
            rest = next
            at = at - 2
         end do
         text(at:at) = achar(iachar('0') + rest)
         at = at - 1
         rest = int(upper)
      end if
      do while (at > 2)
         next = rest/100
         rest = rest - 100*next
         text(at - 1:at) = pairs(2*rest + 1:2*rest + 2)
         rest = next
         at = at - 2
      end do
      if (at == 2) text(2:2) = achar(iachar('0') + rest)
   end subroutine put_figures

end module kyvadlo_decimal
