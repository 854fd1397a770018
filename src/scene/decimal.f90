!> The shortest decimal text that reads back as a given double, fast: by whole numbers of 126 bits.
!>
!> Schubfach (R. Giulietti, The Schubfach way to render doubles, 2021): a double is c 2**q, with k such that 10**k is
!> the greatest power of ten not above the width of its rounding interval; of the multiples of 10**k and 10**(k+1) in
!> that interval one is the shortest text, and the nearest to the value. Ends of the interval and value come over 10**k,
!> times four, by one product each with a power of ten rounded up to 126 bits, which is proved to be enough.
module kyvadlo_decimal
   use, intrinsic :: iso_fortran_env, only: int64, real64
   implicit none
   private
   public :: put_shortest, longest_decimal

   integer, parameter :: bits = digits(1.0_real64)
   !> The longest text: sign, 17 figures, point, exponent of three figures.
   integer, parameter :: longest_decimal = 24
   !> Written out: the index of an implied loop would be a variable of the module.
   integer(int64), parameter :: powers_of_ten(0:16) = &
      10_int64**[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16]
   !> 00 01 02 ... 99
   character(len=*), parameter :: pairs = &
      '0001020304050607080910111213141516171819202122232425262728293031323334353637383940414243444546474849'// &
      '5051525354555657585960616263646566676869707172737475767778798081828384858687888990919293949596979899'
   integer, parameter :: piece = 31
   integer(int64), parameter :: piece_mask = 2_int64**piece - 1, half = 2_int64**62
   include 'decimal_powers.inc'

contains

   !> Writes the text of a value into the first `length` places: `-1.5e+00`, as `shortest_text` does. `length` is 0
   !> where this does not serve: zero, infinities, NaN.
   pure subroutine put_shortest(value, text, length)
      real(real64), intent(in) :: value
      character(len=*), intent(inout) :: text    !! At least `longest_decimal` places
      integer, intent(out) :: length
      integer(int64) :: pattern, c, number, next
      integer :: biased, power, count, order

      length = 0
      pattern = transfer(value, pattern)
      biased = int(ibits(pattern, bits - 1, 11))
      c = ibits(pattern, 0, bits - 1)
      if (biased == 2047 .or. (biased == 0 .and. c == 0)) return
      if (biased > 0) c = ior(c, shiftl(1_int64, bits - 1))
      call find_shortest(c, max(biased, 1) - 1075, biased > 1 .and. c == shiftl(1_int64, bits - 1), number, power)
      do
         next = number/10
         if (10*next /= number) exit
         number = next
         power = power + 1
      end do

      count = 17
      do while (count > 1)
         if (number >= powers_of_ten(count - 1)) exit
         count = count - 1
      end do
      if (pattern < 0) then
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
      order = count - 1 + power
      text(length + 1:length + 2) = merge('e-', 'e+', order < 0)
      order = abs(order)
      length = length + 2
      if (order > 99) then
         length = length + 1
         text(length:length) = achar(iachar('0') + order/100)
         order = mod(order, 100)
      end if
      text(length + 1:length + 2) = pairs(2*order + 1:2*order + 2)
      length = length + 2
   end subroutine put_shortest

   !> The shortest decimal in the rounding interval of c 2**q.
   pure subroutine find_shortest(c, q, is_power, number, k)
      integer(int64), intent(in) :: c
      integer, intent(in) :: q
      logical, intent(in) :: is_power             !! Of two: below it the interval is half as long
      integer(int64), intent(out) :: number
      integer, intent(out) :: k                   !! The decimal is number 10**k
      integer(int64) :: high, low, odd, centre, below, above, tens
      integer :: h
      logical :: lower_is_in, upper_is_in

      ! floor(log10(2**q)), of a power of two floor(log10(3/4 2**q)); h with floor(log2(10**-k)), of which all is exact.
      k = int(shifta(q*661971961083_int64 - merge(274743187321_int64, 0_int64, is_power), 41))
      h = q + int(shifta(-k*913124641741_int64, 38)) + 2
      high = power_high(k)
      low = power_low(k)
      below = over_power(high, low, shiftl(4*c - 2 + merge(1, 0, is_power), h))
      centre = over_power(high, low, shiftl(4*c, h))
      above = over_power(high, low, shiftl(4*c + 2, h))
      odd = iand(c, 1_int64)                      ! The ends belong to it if c is even
      number = shiftr(centre, 2)
      if (number >= 10) then
         tens = number/10
         lower_is_in = below + odd <= 40*tens
         upper_is_in = 40*tens + 40 + odd <= above
         if (lower_is_in .neqv. upper_is_in) then
            number = merge(tens, tens + 1, lower_is_in)
            k = k + 1
            return
         end if
      end if
      lower_is_in = below + odd <= 4*number
      upper_is_in = 4*number + 4 + odd <= above
      if (lower_is_in .neqv. upper_is_in) then
         if (upper_is_in) number = number + 1
      else
         ! Both are: the nearer one, of two the even one.
         centre = centre - (4*number + 2)
         if (centre > 0 .or. (centre == 0 .and. iand(number, 1_int64) == 1)) number = number + 1
      end if
   end subroutine find_shortest

   !> factor times a power of ten over 2**127, the last bit set if anything was cut off.
   pure integer(int64) function over_power(upper_half, lower_half, factor) result(rounded)
      integer(int64), intent(in) :: upper_half, lower_half, factor   !! Of 63 bits; below 2**60
      integer(int64) :: b_low, b_high, a_low, a_high, first, second, middle, carried, high, low

      b_low = iand(factor, piece_mask)
      b_high = shiftr(factor, piece)
      a_low = iand(lower_half, piece_mask)
      a_high = shiftr(lower_half, piece)
      ! The upper 64 bits of a product of 123: what is below them does not count.
      first = a_high*b_low
      second = a_low*b_high + shiftr(a_low*b_low, piece)
      middle = iand(first, piece_mask) + iand(second, piece_mask)
      carried = shiftr(a_high*b_high + shiftr(first, piece) + shiftr(second, piece) + shiftr(middle, piece), 2)
      ! All of the other one but its last bit.
      a_low = iand(upper_half, piece_mask)
      a_high = shiftr(upper_half, piece)
      low = a_low*b_low
      first = a_high*b_low
      second = a_low*b_high + shiftr(low, piece)
      middle = iand(first, piece_mask) + iand(second, piece_mask)
      high = a_high*b_high + shiftr(first, piece) + shiftr(second, piece) + shiftr(middle, piece)
      low = ior(shiftl(iand(high, 3_int64), 61), shiftr(ior(shiftl(iand(middle, piece_mask), piece), &
         iand(low, piece_mask)), 1))
      low = (low - half) + (carried - half)       ! Less 2**63, which a carry makes up for
      rounded = shiftr(high, 2) + merge(1, 0, low >= 0)
      if (ibits(low, 0, 63) /= 0) rounded = ior(rounded, 1_int64)
   end function over_power

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
