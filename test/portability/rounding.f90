!> What is lost where a program rounds in another direction, and where it flushes subnormal numbers to zero: the figures of
!> doc/portability.md, against rounding to nearest. Fails where it is more than the page says.
program portable_rounding
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use, intrinsic :: ieee_arithmetic
   use kyvadlo
   implicit none
   integer, parameter :: n = 3000
   real(wp) :: nearest(13, n), other(13, n), functions, periods, places
   integer :: i, way

   functions = 0
   periods = 0
   places = 0
   call compute(nearest)
   do way = 1, 3
      if (way == 1) call ieee_set_rounding_mode(ieee_up)
      if (way == 2) call ieee_set_rounding_mode(ieee_down)
      if (way == 3) call ieee_set_rounding_mode(ieee_to_zero)
      call compute(other)
      call ieee_set_rounding_mode(ieee_nearest)
      do i = 1, n
         functions = max(functions, maxval(abs(other(:9, i) - nearest(:9, i))/max(1.0_wp, abs(nearest(:9, i)))))
         periods = max(periods, abs(other(10, i) - nearest(10, i))/nearest(10, i))
         places = max(places, maxval(abs(other(11:, i) - nearest(11:, i))))
      end do
   end do
   print '(a, es8.1)', 'functions, relative to 1 or themselves:  ', functions, &
      'period, relative to itself:              ', periods, &
      'position after 1000 s, relative to l:    ', places
   if (.not. (functions <= 4e-15_wp .and. periods <= 1e-15_wp .and. places <= 1e-9_wp)) &
      error stop 'more than the page says'

   if (ieee_support_underflow_control(1.0_wp)) then
      call ieee_set_underflow_mode(gradual=.false.)
      call compute(other)
      call ieee_set_underflow_mode(gradual=.true.)
      print '(a, i0)', 'other numbers where subnormal ones are 0: ', count(abs(other - nearest) > 0)
      if (any(abs(other - nearest) > 0)) error stop 'flushing to zero changes what is not small'
   end if

contains

   subroutine compute(r)
      real(wp), intent(out) :: r(13, n)
      type(orbit_type) :: orbit
      type(kyvadlo_error_type), allocatable :: error
      real(wp) :: u(6)
      integer :: i, k

      do i = 1, n
         ! Numbers between 0 and 1 that no rounding changes.
         u = [(real(modulo(i*(7919*k + 104729), 65536), wp)/65536, k=1, 6)] + 2.0_wp**(-20)
         r(1, i) = carlson_rf(u(1), u(2), u(3))
         r(2, i) = carlson_rj(u(1), u(2), u(3), u(4))
         r(3, i) = elliptic_k(u(1))
         r(4, i) = elliptic_pi(u(2), u(1)/2)
         r(5, i) = elliptic_f(8*u(5), u(1))
         call jacobi_functions(16*u(6), u(1), r(6, i), r(7, i), r(8, i))
         r(9, i) = theta_function(1 + modulo(i, 4), 4*u(2), u(3)/2)
         call new_orbit_from_rises(orbit, 1.0_wp, 9.75_wp, max(u(4), u(5))*1.75_wp, min(u(4), u(5))/4, error)
         if (allocated(error)) error stop 'no orbit'
         r(10, i) = orbit%period()
         call orbit%locate(1000.0_wp, r(11:13, i))
      end do
   end subroutine compute
end program portable_rounding
