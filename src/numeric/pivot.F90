!> The motion of the pivot: harmonic along each axis, a table along a cubic spline, or both, added.
module kyvadlo_pivot
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_curves, only: look_up, next_joint
   use kyvadlo_effects, only: effects_type
   implicit none
   private
   public :: pivot_motion, pivot_rates, pivot_jerk, pivot_change, pivot_speed, next_knot, last_time

contains

   !> Displacement of the pivot from the origin of the laboratory, and its first two derivatives. Beyond a table's ends
   !> the outermost cubic is continued; `advance` does not let a run get there.
   pure subroutine pivot_motion(effects, time, displacement, velocity, acceleration)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: time                          !! [s]
      real(wp), intent(out) :: displacement(3), velocity(3) !! [m], [m/s]
      real(wp), intent(out), optional :: acceleration(3)    !! [m/s2]
      real(wp), parameter :: two_pi = 2*acos(-1.0_wp)
      real(wp) :: step, a, b, bend(3), place(3, 0:0)
      integer :: k

      call pivot_rates(effects, time, bend, velocity, .true., huge(time))
      if (present(acceleration)) acceleration = bend
      displacement = effects%pivot_amplitude*cos(two_pi*effects%pivot_frequency*time + effects%pivot_phase)
      if (allocated(effects%pivot_curve%times)) then
         call look_up(effects%pivot_curve, time, place)
         displacement = displacement + place(:, 0)
      end if
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

#include "pivot_rates.inc"

   !> The third derivative of its displacement; at a knot of the table that behind it [m/s3].
   pure function pivot_jerk(effects, time) result(jerk)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: time                          !! [s]
      real(wp) :: jerk(3), rates(3, 0:3)
      real(wp), parameter :: two_pi = 2*acos(-1.0_wp)
      integer :: k

      associate (rate => two_pi*effects%pivot_frequency)
         jerk = effects%pivot_amplitude*rate**3*sin(rate*time + effects%pivot_phase)
      end associate
      if (allocated(effects%pivot_curve%times)) then
         call look_up(effects%pivot_curve, time, rates)
         jerk = jerk + rates(:, 3)
      end if
      if (.not. allocated(effects%pivot_times)) return
      k = interval(effects%pivot_times, time)
      associate (t => effects%pivot_times, c => effects%pivot_curvatures)
         jerk = jerk + (c(:, k + 1) - c(:, k))/(t(k + 1) - t(k))
      end associate
   end function pivot_jerk

   !> The changes of what `pivot_motion` gives with amplitude, frequency and phase.
   pure subroutine pivot_change(effects, change, time, displacement, velocity, acceleration)
      type(effects_type), intent(in) :: effects
      type(effects_type), intent(in) :: change              !! Changes of its numbers
      real(wp), intent(in) :: time                          !! [s]
      real(wp), intent(out), dimension(3) :: displacement, velocity, acceleration
      real(wp), parameter :: two_pi = 2*acos(-1.0_wp)
      real(wp) :: rate, rate_change, angle_change, c, s
      integer :: i

      displacement = 0
      velocity = 0
      acceleration = 0
      do i = 1, 3
         rate_change = two_pi*change%pivot_frequency(i)
         angle_change = rate_change*time + change%pivot_phase(i)
         associate (amplitude => effects%pivot_amplitude(i), grown => change%pivot_amplitude(i))
            if (.not. (abs(grown) > 0 .or. abs(angle_change) > 0 .or. abs(rate_change) > 0)) cycle
            rate = two_pi*effects%pivot_frequency(i)
            c = cos(rate*time + effects%pivot_phase(i))
            s = sin(rate*time + effects%pivot_phase(i))
            displacement(i) = grown*c - amplitude*s*angle_change
            velocity(i) = -(grown*rate + amplitude*rate_change)*s - amplitude*rate*c*angle_change
            acceleration(i) = -(grown*rate + 2*amplitude*rate_change)*rate*c + amplitude*rate**2*s*angle_change
         end associate
      end do
   end subroutine pivot_change

   !> The knot that comes next of the tables of pivot and winch, where a derivative jumps; huge if there is none [s].
   pure real(wp) function next_knot(effects, time)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: time

      next_knot = min(next_joint(effects%hoist, time), next_joint(effects%pivot_curve, time))
      if (.not. allocated(effects%pivot_times)) return
      associate (t => effects%pivot_times)
         if (time < t(1)) then
            next_knot = min(next_knot, t(1))
         else if (time < t(size(t))) then
            next_knot = min(next_knot, t(interval(t, time) + 1))
         end if
      end associate
   end function next_knot

   !> The end of the tables of pivot and winch, or of all length; huge if there is none [s].
   pure real(wp) function last_time(effects, length)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: length                        !! At time 0 [m]

      last_time = huge(last_time)
      if (allocated(effects%pivot_times)) last_time = effects%pivot_times(size(effects%pivot_times))
      if (allocated(effects%pivot_curve%times)) last_time = min(last_time, &
         effects%pivot_curve%times(size(effects%pivot_curve%times)))
      if (allocated(effects%hoist%times)) last_time = min(last_time, effects%hoist%times(size(effects%hoist%times)))
      if (effects%hoist_rate < 0) last_time = min(last_time, length/abs(effects%hoist_rate))
   end function last_time

   !> Scale of the speed of the pivot.
   pure real(wp) function pivot_speed(effects)
      type(effects_type), intent(in) :: effects
      real(wp), parameter :: two_pi = 2*acos(-1.0_wp)
      integer :: k

      pivot_speed = norm2(two_pi*effects%pivot_frequency*effects%pivot_amplitude)
      if (allocated(effects%pivot_curve%times)) then
         do k = 1, size(effects%pivot_curve%terms, 3)
            pivot_speed = max(pivot_speed, norm2(effects%pivot_curve%terms(:, 1, k)))
         end do
      end if
      if (.not. allocated(effects%pivot_times)) return
      associate (t => effects%pivot_times, p => effects%pivot_displacements)
         do k = 2, size(t)
            pivot_speed = max(pivot_speed, norm2(p(:, k) - p(:, k - 1))/(t(k) - t(k - 1)))
         end do
      end associate
   end function pivot_speed

end module kyvadlo_pivot
