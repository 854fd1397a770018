!> The motion of the pivot: harmonic along each axis, a table along a cubic spline, or both, added.
module kyvadlo_pivot
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_effects, only: effects_type
   implicit none
   private
   public :: pivot_motion, pivot_rates, next_knot

contains

   !> Displacement of the pivot from the origin of the laboratory, and its first two derivatives. Beyond a table's ends
   !> the outermost cubic is continued; `advance` does not let a run get there.
   pure subroutine pivot_motion(effects, time, displacement, velocity, acceleration)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: time                          !! [s]
      real(wp), intent(out) :: displacement(3), velocity(3) !! [m], [m/s]
      real(wp), intent(out), optional :: acceleration(3)    !! [m/s2]
      real(wp), parameter :: two_pi = 2*acos(-1.0_wp)
      real(wp) :: step, a, b, bend(3)
      integer :: k

      call pivot_rates(effects, time, bend, velocity, .true.)
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

#include "pivot_rates.inc"

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

end module kyvadlo_pivot
