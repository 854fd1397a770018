!> Equidistant numbers between two decimals as they were typed: (A (n - i) + B i)/n in whole numbers, as a text that any
!> kind reads and rounds once. In floating point 0.9 in 18 steps of 0.1 does not pass through 0.8.
module kyvadlo_decimal_grid
   use, intrinsic :: iso_fortran_env, only: int64
   implicit none
   private
   public :: grid_type, new_grid, grid_point, longest_point, read_whole

   !> Whole numbers by their digits to the base 1000, the lowest first: a digit times a count of 4.5e15 fits into int64.
   integer, parameter :: base = 1000, base_figures = 3
   !> Digits of a point that are written: 63 figures at least 61 of which count. Quadruple precision rounds 34, and
   !> whether what follows is zero is known: the text ends in 1 if it is not.
   integer, parameter :: point_digits = 21
   integer, parameter :: longest_point = (point_digits + 2)*base_figures + 16
   !> Powers of ten beyond every kind.
   integer, parameter :: far = 6000

   type :: grid_type
      private
      integer(int64) :: parts = 1
      integer :: power = 0                     !! Of ten, of the lowest digit
      logical :: is_negative(2) = .false.      !! A, B
      integer, allocatable :: digits(:, :)     !! (digit, A or B)
   end type grid_type

contains

   !> The grid from A to B in n parts. Both are numbers that `read_number` takes.
   pure subroutine new_grid(grid, first, last, parts)
      type(grid_type), intent(out) :: grid
      character(len=*), intent(in) :: first, last  !! A, B
      integer(int64), intent(in) :: parts          !! n, 1 to 4.5e15
      character(len=len(first) + len(last)) :: figures(2)
      integer :: power(2), count(2), i

      grid%parts = parts
      call read_decimal(first, figures(1), count(1), power(1), grid%is_negative(1))
      call read_decimal(last, figures(2), count(2), power(2), grid%is_negative(2))
      ! A zero has no power of its own.
      do i = 1, 2
         if (count(i) == 0) power(i) = power(3 - i)
      end do
      grid%power = minval(power)
      allocate (grid%digits((maxval(count + power) - grid%power)/base_figures + 1, 2), source=0)
      do i = 1, 2
         call put_figures(figures(i)(:count(i)), power(i) - grid%power, grid%digits(:, i))
      end do
   end subroutine new_grid

   !> A number as it was typed, whole/10**places; whole is 0 where it is not positive, has more than 15 figures, or does
   !> not lie between 10**-15 and 10**15.
   pure subroutine read_whole(text, whole, places)
      character(len=*), intent(in) :: text
      integer(int64), intent(out) :: whole
      integer, intent(out) :: places            !! 0 to 15
      character(len=len(text)) :: figures
      logical :: is_negative
      integer :: count, used, power

      call read_decimal(text, figures, count, power, is_negative)
      whole = 0
      places = 0
      used = verify(figures(:count), '0', back=.true.)
      power = power + count - used
      if (is_negative .or. used < 1 .or. used > 15 .or. power < -15 .or. power + used > 15) return
      read (figures(:used), '(i15)') whole
      whole = whole*10_int64**max(power, 0)
      places = max(-power, 0)
   end subroutine read_whole

   !> Figures without leading zeros and point; the number is figures*10**power.
   pure subroutine read_decimal(text, figures, count, power, is_negative)
      character(len=*), intent(in) :: text
      character(len=*), intent(out) :: figures
      integer, intent(out) :: count, power
      logical, intent(out) :: is_negative
      logical :: is_behind_point
      integer :: i, status, written

      figures = ''
      count = 0
      power = 0
      is_negative = .false.
      is_behind_point = .false.
      do i = 1, len(text)
         select case (text(i:i))
         case ('-')
            is_negative = .true.
         case ('.')
            is_behind_point = .true.
         case ('0':'9')
            if (is_behind_point) power = power - 1
            if (count == 0 .and. text(i:i) == '0') cycle
            count = count + 1
            figures(count:count) = text(i:i)
         case ('e', 'E', 'd', 'D', 'q', 'Q')
            read (text(i + 1:), '(i10)', iostat=status) written
            if (status /= 0) written = merge(-far, far, index(text(i + 1:), '-') > 0)
            power = power + max(-far, min(written, far))
            exit
         end select
      end do
      if (power + count < -far) count = 0
   end subroutine read_decimal

   !> Digits to the base 1000 of figures with `zeros` behind them.
   pure subroutine put_figures(figures, zeros, digits)
      character(len=*), intent(in) :: figures
      integer, intent(in) :: zeros
      integer, intent(inout) :: digits(:)
      integer :: i, place

      do i = 1, len(figures)
         place = zeros + len(figures) - i
         digits(place/base_figures + 1) = digits(place/base_figures + 1) &
            + (iachar(figures(i:i)) - iachar('0'))*10**mod(place, base_figures)
      end do
   end subroutine put_figures

   !> Point i of 0 to n, blanks behind.
   pure function grid_point(grid, i) result(text)
      type(grid_type), intent(in) :: grid
      integer(int64), intent(in) :: i
      character(len=longest_point) :: text
      integer(int64) :: whole(size(grid%digits, 1) + 6), other(size(grid%digits, 1) + 6), rest, digit
      integer :: k, used, top, written
      logical :: is_negative

      call multiply(grid%digits(:, 1), grid%parts - i, whole)
      call multiply(grid%digits(:, 2), i, other)
      is_negative = grid%is_negative(1)
      if (grid%is_negative(1) .eqv. grid%is_negative(2)) then
         whole = whole + other
      else if (is_smaller(whole, other)) then
         whole = other - whole
         is_negative = .not. is_negative
      else
         whole = whole - other
      end if
      call carry(whole)

      ! Division from the top, as on paper, and on behind the point.
      text = merge('-', ' ', is_negative)
      used = 1
      rest = 0
      written = 0
      top = size(whole)
      k = top
      do while (k > 0 .or. (rest > 0 .and. written < point_digits))
         digit = rest*base
         if (k > 0) digit = digit + whole(k)
         rest = mod(digit, grid%parts)
         digit = digit/grid%parts
         k = k - 1
         if (written == 0 .and. digit == 0) cycle
         written = written + 1
         write (text(used + 1:used + base_figures), '(i3.3)') digit
         used = used + base_figures
         if (written >= point_digits .and. k < 1) exit
         if (written > point_digits) exit
      end do
      if (written == 0) then
         text = '0'
         return
      end if
      if (rest > 0 .or. any(whole(:max(k, 0)) > 0)) then
         write (text(used + 1:used + base_figures), '(i3.3)') 1
         used = used + base_figures
         k = k - 1
      end if
      write (text(used + 1:), '(a,i0)') 'e', grid%power + k*base_figures
      text = adjustl(text)
   end function grid_point

   pure subroutine multiply(digits, factor, product)
      integer, intent(in) :: digits(:)
      integer(int64), intent(in) :: factor
      integer(int64), intent(out) :: product(:)

      product = 0
      product(:size(digits)) = digits*factor
      call carry(product)
   end subroutine multiply

   !> Every digit between 0 and 999; those of a number that is not negative.
   pure subroutine carry(digits)
      integer(int64), intent(inout) :: digits(:)
      integer(int64) :: over
      integer :: i

      over = 0
      do i = 1, size(digits)
         digits(i) = digits(i) + over
         over = (digits(i) - modulo(digits(i), int(base, int64)))/base
         digits(i) = digits(i) - base*over
      end do
   end subroutine carry

   pure logical function is_smaller(one, other)
      integer(int64), intent(in) :: one(:), other(:)
      integer :: i

      is_smaller = .false.
      do i = size(one), 1, -1
         if (one(i) == other(i)) cycle
         is_smaller = one(i) < other(i)
         return
      end do
   end function is_smaller

end module kyvadlo_decimal_grid
