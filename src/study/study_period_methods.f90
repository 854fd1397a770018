!> The period T by what a user might program instead: iterations stopped early, and series.
!>
!> T = 2 sqrt(2/g) l R_F(0, z3 - z1, z3 - z2) = pi sqrt(2/g) l/agm(sqrt(z3 - z1), sqrt(z3 - z2)), (16).
module kyvadlo_study_period_methods
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_study_set_up, only: study_start_type
   implicit none
   private
   public :: swings_type, swings_of, unit_time, agm_period, carlson_period, amplitude_series, sine_series, &
      ellipse_series

   !> What T depends on, formed by sums without cancellation, [S6.1].
   type :: swings_type
      real(real64) :: upper_rise = 0, lower_rise = 0, upper_gap = 0, lower_gap = 0 !! l + z1, l + z2, l - z1, l - z2 [m]
      real(real64) :: outer_gap = 0, outer_swing = 0                             !! z3 - z1, z3 - z2 [m]
   end type swings_type

   real(real64), parameter :: pi = acos(-1.0_real64)

contains

   pure type(swings_type) function swings_of(start) result(swings)
      type(study_start_type), intent(in) :: start
      real(real64) :: deficit, outer_excess

      swings%lower_rise = start%second
      swings%lower_gap = 2*start%length - start%second
      if (start%by_rises) then
         swings%upper_rise = start%first
         swings%upper_gap = 2*start%length - start%first
      else
         swings%upper_gap = start%first
         swings%upper_rise = 2*start%length - start%first
      end if
      deficit = swings%upper_gap - swings%lower_rise
      outer_excess = swings%upper_rise*swings%lower_rise/deficit
      swings%outer_gap = outer_excess + swings%upper_gap
      swings%outer_swing = outer_excess + swings%lower_gap
   end function swings_of

   !> 2 sqrt(2/g) l [s sqrt(m)].
   pure real(real64) function unit_time(start)
      type(study_start_type), intent(in) :: start

      unit_time = 2*sqrt(2/start%gravity)*start%length
   end function unit_time

   !> The mean after a number of iterations.
   pure real(real64) function agm_period(start, iterations) result(period)
      type(study_start_type), intent(in) :: start
      integer, intent(in) :: iterations
      type(swings_type) :: swings
      real(real64) :: a, b, old
      integer :: i

      swings = swings_of(start)
      a = sqrt(swings%outer_swing)
      b = sqrt(swings%outer_gap)
      do i = 1, iterations
         old = a
         a = (a + b)/2
         b = sqrt(old*b)
      end do
      period = unit_time(start)*pi/(2*a)
   end function agm_period

   !> R_F by Carlson's duplication (Numer. Math. 33 (1979) 1) and his series of degree 5, after a number of
   !> duplications.
   pure real(real64) function carlson_period(start, duplications) result(period)
      type(study_start_type), intent(in) :: start
      integer, intent(in) :: duplications
      type(swings_type) :: swings
      real(real64) :: x, y, z, lambda, mean, e2, e3
      integer :: i

      swings = swings_of(start)
      x = 0
      y = swings%outer_gap
      z = swings%outer_swing
      do i = 1, duplications
         lambda = sqrt(x)*(sqrt(y) + sqrt(z)) + sqrt(y)*sqrt(z)
         x = (x + lambda)/4
         y = (y + lambda)/4
         z = (z + lambda)/4
      end do
      mean = (x + y + z)/3
      x = (mean - x)/mean
      y = (mean - y)/mean
      z = -x - y
      e2 = x*y - z*z
      e3 = x*y*z
      period = unit_time(start)*(1 + (e2/24 - 0.1_real64 - 3*e3/44)*e2 + e3/14)/sqrt(mean)
   end function carlson_period

   !> Half the swing of a plane pendulum by the textbook's series in the amplitude, up to the power 2 `highest`.
   pure real(real64) function amplitude_series(start, highest) result(period)
      type(study_start_type), intent(in) :: start
      integer, intent(in) :: highest  !! 0 ... 6
      !> 1 + a**2/16 + 11 a**4/3072 + 173 a**6/737280 + ...: (2/pi) K(sin(a/2)**2) by powers of a.
      real(real64), parameter :: coefficients(0:6) = [1.0_real64, 1/16.0_real64, 11/3072.0_real64, &
         173/737280.0_real64, 22931/1321205760.0_real64, 1319183/951268147200.0_real64, &
         233526463/2009078326886400.0_real64]
      type(swings_type) :: swings
      real(real64) :: amplitude, sum
      integer :: i

      swings = swings_of(start)
      amplitude = 2*asin(sqrt(swings%upper_rise/(2*start%length)))
      sum = coefficients(highest)
      do i = highest - 1, 0, -1
         sum = sum*amplitude**2 + coefficients(i)
      end do
      period = pi*sqrt(start%length/start%gravity)*sum
   end function amplitude_series

   !> The same by powers of sin(amplitude/2)**2: the sum of ((2n-1)!!/(2n)!!)**2 k**(2n) for n < terms.
   pure real(real64) function sine_series(start, terms) result(period)
      type(study_start_type), intent(in) :: start
      integer, intent(in) :: terms  !! 1 or more
      type(swings_type) :: swings
      real(real64) :: term, sum
      integer :: n

      swings = swings_of(start)
      term = 1
      sum = 1
      do n = 1, terms - 1
         term = term*((2*n - 1)/(2.0_real64*n))**2*(swings%upper_rise/(2*start%length))
         sum = sum + term
      end do
      period = pi*sqrt(start%length/start%gravity)*sum
   end function sine_series

   !> The small ellipse with half axes a, b: T = pi sqrt(l/g) [1 + (a**2 + b**2)/16 l**2 + (25 (a**2 + b**2)**2 - 76
   !> a**2 b**2)/1024 l**4], up to the power 2 `highest`.
   pure real(real64) function ellipse_series(start, highest) result(period)
      type(study_start_type), intent(in) :: start
      integer, intent(in) :: highest  !! 0, 1, 2
      type(swings_type) :: swings
      real(real64) :: a2, b2, sum

      swings = swings_of(start)
      a2 = swings%upper_rise*swings%upper_gap/start%length**2
      b2 = swings%lower_rise*swings%lower_gap/start%length**2
      sum = 1
      if (highest > 0) sum = sum + (a2 + b2)/16
      if (highest > 1) sum = sum + (25*(a2 + b2)**2 - 76*a2*b2)/1024
      period = pi*sqrt(start%length/start%gravity)*sum
   end function ellipse_series

end module kyvadlo_study_period_methods
