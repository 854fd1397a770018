!> Results that use only + - * / sqrt and whole numbers, and their text: a checksum of their bits, which is the same wherever
!> operations are rounded as IEEE 754 says. With an argument the results themselves come first.
program bits
   use, intrinsic :: iso_fortran_env, only: int64, real64
   use kyvadlo_two_part, only: pair_type, pair, two_product, operator(+), operator(*), operator(/), sqrt
   use kyvadlo_cubic, only: cubic_roots
   use kyvadlo_number_text, only: padded_shortest
   implicit none
   integer, parameter :: draws = 20000
   integer(int64) :: state = 88172645463325252_int64, checksum = 0
   type(pair_type) :: a, b
   real(real64) :: x(3), roots(3)
   character(len=32) :: text
   integer :: i, j, count

   do i = 1, draws
      x = [draw(), draw(), draw()]
      a = pair(x(1)) + two_product(x(2), x(3))
      b = sqrt(a*a + pair(x(2))*x(2))/(pair(2.0_real64) + x(3))
      call cubic_roots(1.0_real64, -(x(1) + 1), -(x(2) + 1), x(1)*x(2)/4, roots, count)
      if (count /= 3) error stop 'three roots expected'
      text = padded_shortest(x(1)*2.0_real64**(mod(i, 200) - 100))
      if (command_argument_count() > 0) print '(7(z16.16, 1x), a)', a%high, a%low, b%high, b%low, roots, trim(text)
      call add(transfer([a%high, a%low, b%high, b%low, roots], [checksum]))
      call add([(int(iachar(text(j:j)), int64), j = 1, len_trim(text))])
   end do
   print '(a, z16.16)', 'checksum ', checksum

contains

   subroutine add(words)
      integer(int64), intent(in) :: words(:)
      integer :: k

      do k = 1, size(words)
         checksum = ieor(ishftc(checksum, 7), words(k))
      end do
   end subroutine add

   !> Marsaglia's xorshift: between 0 and 1, 53 bits.
   real(real64) function draw()
      state = ieor(state, ishft(state, 13))
      state = ieor(state, ishft(state, -7))
      state = ieor(state, ishft(state, 17))
      draw = real(ishft(state, -11), real64)*2.0_real64**(-53)
   end function draw
end program bits
