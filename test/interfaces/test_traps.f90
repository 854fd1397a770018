!> Every routine of the Fortran 77 and SLATEC interfaces under -ffpe-trap=invalid,zero,overflow: valid arguments, poles,
!> a quiet NaN in each place and a WORK of signalling NaNs end no program.
program test_traps
   use, intrinsic :: iso_fortran_env, only: int64, real32, real64
   implicit none
   integer, parameter :: n = 3, length = 300
   external :: kyvelk, kyvele, kyveld, kyvelb, kyveck, kyvece, kyvecd, kyvecb, kyvnom, kyvnoc, kyvelp, kyvecp, kyvelf, &
      kyvine, kyvind, kyvinb, kyvicf, kyvice, kyvicd, kyvicb, kyvrc, kyvzet, kyvzec, kyvheu, kyvhec, kyvam, kyvamc, &
      kyvel1, kyvinp, kyvicp, kyvrf, kyvrd, kyvrg, kyvel3, kyvrj, kyvcel, kyvel2, kyvscd, kyvscc, kyvthe, kyvthd, &
      kyvper, kyvroo, kyvset, kyvgap, kyvene, kyvsta, kyvpos, kyvmny, kyvmnv, kyvazi
   real(real64), external :: drc, drf, drd, drj
   real(real32), external :: rc, rf, rd, rj
   real(real64), parameter :: nan = transfer(9221120237041090560_int64, 0.0_real64)
   integer(int64), parameter :: signalling = 9219994337134247936_int64
   integer :: i, j

   do i = 1, 2
      call one(merge(0.5_real64, nan, i == 1))
   end do
   do i = 1, 4
      do j = 0, 5
         call many(value_at(1, i, j), value_at(2, i, j), value_at(3, i, j), value_at(4, i, j))
      end do
   end do
   call orbits([1.0_real64, 9.8_real64, 0.3_real64, -0.8_real64], 0.7_real64)
   call orbits([1.0_real64, 9.8_real64, 0.3_real64, -0.8_real64], nan)
   do i = 1, 4
      call orbits(merge([nan, nan, nan, nan], [1.0_real64, 9.8_real64, 0.3_real64, -0.8_real64], [1, 2, 3, 4] == i), &
         0.7_real64)
   end do
   call orbits([1.0_real64, 9.8_real64, 0.0_real64, -1.0_real64], 0.7_real64)
   call orbits([1.0_real64, 9.8_real64, -0.8_real64, -0.8_real64], 0.7_real64)
   call orbits([1.0_real64, 9.8_real64, -1.0_real64, -1.0_real64], 0.7_real64)
   print '(a)', 'nothing trapped'

contains

   !> Argument `place` of the call in which argument i is special: a NaN, 0, 1, a large, a small or a negative number.
   real(real64) function value_at(place, i, j) result(x)
      integer, intent(in) :: place, i, j
      real(real64), parameter :: special(0:5) = [nan, 0.0_real64, 1.0_real64, 1e300_real64, 1e-300_real64, -0.5_real64]

      x = 0.25_real64*place - 0.125_real64
      if (place == i) x = special(j)
   end function value_at

   subroutine one(x)
      real(real64), intent(in) :: x
      real(real64) :: y
      integer :: ier

      call kyvelk(x, y, ier); call kyvele(x, y, ier); call kyveld(x, y, ier); call kyvelb(x, y, ier)
      call kyveck(x, y, ier); call kyvece(x, y, ier); call kyvecd(x, y, ier); call kyvecb(x, y, ier)
      call kyvnom(x, y, ier); call kyvnoc(x, y, ier)
      call kyvelk(1.0_real64, y, ier); call kyveld(1.0_real64, y, ier); call kyveck(0.0_real64, y, ier)
   end subroutine one

   subroutine many(a, b, c, d)
      real(real64), intent(in) :: a, b, c, d
      real(real64) :: y, sn, cn, dn
      real(real32) :: s
      integer :: ier

      call one(a)
      call kyvelp(a, b, y, ier); call kyvecp(a, b, y, ier); call kyvelf(a, b, y, ier); call kyvine(a, b, y, ier)
      call kyvind(a, b, y, ier); call kyvinb(a, b, y, ier); call kyvicf(a, b, y, ier); call kyvice(a, b, y, ier)
      call kyvicd(a, b, y, ier); call kyvicb(a, b, y, ier); call kyvrc(a, b, y, ier); call kyvzet(a, b, y, ier)
      call kyvzec(a, b, y, ier); call kyvheu(a, b, y, ier); call kyvhec(a, b, y, ier); call kyvam(a, b, y, ier)
      call kyvamc(a, b, y, ier); call kyvel1(a, b, y, ier)
      call kyvinp(a, b, c, y, ier); call kyvicp(a, b, c, y, ier)
      call kyvrf(a, b, c, y, ier); call kyvrd(a, b, c, y, ier); call kyvrg(a, b, c, y, ier); call kyvel3(a, b, c, y, &
         ier)
      call kyvrj(a, b, c, d, y, ier); call kyvcel(a, b, c, d, y, ier); call kyvel2(a, b, c, d, y, ier)
      call kyvscd(a, b, sn, cn, dn, ier); call kyvscc(a, b, sn, cn, dn, ier)
      call kyvthe(3, a, b, y, ier); call kyvthd(1, a, b, y, ier)
      y = drc(a, b, ier) + drf(a, b, c, ier) + drd(a, b, c, ier) + drj(a, b, c, d, ier)
      if (any([a, b, c, d] == 1e300_real64)) return ! beyond single precision: the conversion overflows
      s = rc(real(a), real(b), ier) + rf(real(a), real(b), real(c), ier) + rd(real(a), real(b), real(c), ier) &
         + rj(real(a), real(b), real(c), real(d), ier)
   end subroutine many

   subroutine orbits(start, time)
      real(real64), intent(in) :: start(4), time
      real(real64) :: work(length), x(3), v(3), z(3), gap(7), times(n), xs(n, 6), y
      integer :: ier

      work = transfer(spread(signalling, 1, length), work)
      times = [time, 2*time, 0.5_real64]
      call kyvpos(work, time, x, v, ier)
      call kyvper(start(1), start(2), start(3), start(4), y, ier)
      call kyvroo(start(1), start(2), 2*start(3), start(4), z, gap, ier)
      call kyvgap(start(1), start(2), 1 - start(3), 1 + start(4), work, length, ier)
      call kyvene(start(1), start(2), 2*start(3), start(4), work, length, ier)
      call kyvsta(start(1), start(2), [0.6_real64, 0.0_real64, start(4)], [0.0_real64, start(3), 0.0_real64], work, &
         length, ier)
      call kyvset(start(1), start(2), start(3), start(4), work, length, ier)
      call kyvpos(work, time, x, v, ier)
      call kyvazi(work, time, y, ier)
      call kyvmny(work, n, times, xs(:, 1), xs(:, 2), xs(:, 3), ier)
      call kyvmnv(work, n, times, xs(:, 1), xs(:, 2), xs(:, 3), xs(:, 4), xs(:, 5), xs(:, 6), ier)
   end subroutine orbits
end program test_traps
