!> The motion of the pivot: harmonic along each axis, a table along a cubic spline, or both, added.
module kyvadlo_pivot
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_effects, only: effects_type
   implicit none
   private
   public :: pivot_motion, pivot_rates, next_knot

   real(wp), parameter :: two_pi = 2*acos(-1.0_wp)

contains

   !> Displacement of the pivot from the origin of the laboratory, and its first two derivatives. Beyond a table's ends the
   !> outermost cubic is continued; `advance` does not let a run get there.
   pure subroutine pivot_motion(effects, time, displacement, velocity, acceleration)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: time                          !! [s]
      real(wp), intent(out) :: displacement(3), velocity(3) !! [m], [m/s]
      real(wp), intent(out), optional :: acceleration(3)    !! [m/s2]
      real(wp) :: step, a, b, bend(3)
      integer :: k

      call pivot_rates(effects, time, bend, velocity)
      if (present(acceleration)) acceleration = bend
      displacement = effects%pivot_amplitude*cos(two_pi*effects%pivot_frequency*time + effects%pivot_phase)
      if (.not. allocated(effects%pivot_times)) return
      k = interval(effects%pivot_times, time)
      associate (t => effects%pivot_times, p => effects%pivot_displacements, c => effects%pivot_curvatures)
         step = t(k + 1) - t(k)
         a = (t(k + 1) - time)/step
         b = (time - t(k))/step
         displacement = displacement + a*p(:, k) + b*p(:, k + 1) &
            + step**2/6*((a**3 - a)*c(:, k) + (b**3 - b)*c(:, k + 1))
      end associate
   end subroutine pivot_motion

   !> The derivatives alone; where the first is not asked for it costs nothing.
   pure subroutine pivot_rates(effects, time, acceleration, velocity)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: time                     !! [s]
      real(wp), intent(out) :: acceleration(3)         !! [m/s2]
      real(wp), intent(out), optional :: velocity(3)   !! [m/s]
      real(wp) :: rate, angle, step, a, b
      integer :: i, k

      do i = 1, 3
         acceleration(i) = 0
         if (present(velocity)) velocity(i) = 0
         if (.not. abs(effects%pivot_amplitude(i)) > 0) cycle
         rate = two_pi*effects%pivot_frequency(i)
         angle = rate*time + effects%pivot_phase(i)
         acceleration(i) = -effects%pivot_amplitude(i)*rate**2*cos(angle)
         if (present(velocity)) velocity(i) = -effects%pivot_amplitude(i)*rate*sin(angle)
      end do
      if (.not. allocated(effects%pivot_times)) return
      k = interval(effects%pivot_times, time)
      associate (t => effects%pivot_times, p => effects%pivot_displacements, c => effects%pivot_curvatures)
         step = t(k + 1) - t(k)
         a = (t(k + 1) - time)/step
         b = (time - t(k))/step
         acceleration = acceleration + a*c(:, k) + b*c(:, k + 1)
         if (present(velocity)) velocity = velocity + (p(:, k + 1) - p(:, k))/step &
            + step/6*((3*b**2 - 1)*c(:, k + 1) - (3*a**2 - 1)*c(:, k))
      end associate
   end subroutine pivot_rates

   !> The knot of the table that comes next, where the third derivative jumps; huge without a table or after it [s].
   pure real(wp) function next_knot(effects, time)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: time

      next_knot = huge(next_knot)
      if (.not. allocated(effects%pivot_times)) return
      associate (t => effects%pivot_times)
         if (time < t(1)) then
            next_knot = t(1)
         else if (time < t(size(t))) then
            next_knot = t(interval(t, time) + 1)
         end if
      end associate
   end function next_knot

   !> The k with t(k) <= time < t(k + 1), at the ends the outermost.
   pure integer function interval(t, time) result(low)
      real(wp), intent(in) :: t(:), time
      integer :: high, middle

      low = 1
      high = size(t)
      do while (high - low > 1)
         middle = shiftr(low + high, 1)
         if (t(middle) <= time) then
            low = middle
         else
            high = middle
         end if
      end do
   end function interval

end module kyvadlo_pivot
