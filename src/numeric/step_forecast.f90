!> How many steps an integration will take, about: what has to be resolved fastest, and what part of it a step takes.
module kyvadlo_step_forecast
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: infinity_real64, product_or_infinity
   use kyvadlo_buoyancy, only: effective_gravity, effective_inertia
   use kyvadlo_curves, only: least_value
   use kyvadlo_effects, only: effects_type, has_drag, has_hoist, has_moving_pivot
   implicit none
   private
   public :: forecast_error, forecast_steps
   public :: cause_gravity, cause_start, cause_drag, cause_wind, cause_turning, cause_pivot, cause_stiffness, &
      cause_hoist

   !> What asks for the most steps.
   integer, parameter :: cause_gravity = 1, cause_start = 2, cause_drag = 3, cause_wind = 4, cause_turning = 5, &
      cause_pivot = 6, cause_stiffness = 7, cause_hoist = 8
   !> Steps to the radian at a tolerance of 1e-12: 5 to 8 were counted. A step of order 8 grows with the ninth root of
   !> the tolerance. Where the drag is stiff, a step is what stays stable, whatever the tolerance: 0.25 were counted in
   !> its time.
   real(wp), parameter :: steps_per_radian = 5, measured_tolerance = 1e-12_wp, steps_per_decay = 0.25_wp
   real(wp), parameter :: two_pi = 2*acos(-1.0_wp)

contains

   !> Infinite where the forces are beyond all numbers.
   pure subroutine forecast_steps(effects, length, gravity, speed, duration, tolerance, steps, cause)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: length, gravity, speed   !! [m], [m/s2]; at the start [m/s]
      real(wp), intent(in) :: duration                 !! [s]
      real(wp), intent(in) :: tolerance                !! Of the error of a step
      real(wp), intent(out) :: steps
      integer, intent(out) :: cause                    !! One of the `cause_*` constants
      real(wp) :: rates(cause_hoist), through, decay, inertia, fall, shortest

      inertia = effective_inertia(effects%density_ratio, effects%added_mass)
      fall = effective_gravity(gravity, effects%density_ratio, effects%added_mass)
      rates = 0
      rates(cause_gravity) = sqrt(fall/length)
      rates(cause_start) = speed/length
      rates(cause_turning) = 2*norm2(effects%turn_rate)
      associate (turning => two_pi*pack(effects%pivot_frequency, abs(effects%pivot_amplitude) > 0), &
         amplitude => pack(effects%pivot_amplitude, abs(effects%pivot_amplitude) > 0))
         if (size(turning) > 0) rates(cause_pivot) = max(maxval(turning), &
            maxval(product_or_infinity(turning, sqrt(abs(amplitude)/length))))
      end associate
      rates(cause_stiffness) = sqrt(effects%stiffness/inertia)
      if (has_hoist(effects)) then
         shortest = length + min(0.0_wp, effects%hoist_rate*duration)
         if (allocated(effects%hoist%times)) shortest = shortest + least_value(effects%hoist, 1, 0.0_wp, duration)
         ! The momentum stays as the length shrinks.
         if (shortest < length) rates(cause_hoist) = max(sqrt(fall/shortest), speed*length/shortest**2)
      end if
      if (has_drag(effects)) then
         through = norm2(effects%wind)
         decay = (effects%linear_drag + product_or_infinity(effects%quadratic_drag, through))/inertia
         rates(cause_wind) = max(product_or_infinity(decay, steps_per_decay/steps_per_radian), &
               sqrt(product_or_infinity(decay, through/length)))
         ! Through still air, soon no faster than a fall in it.
         decay = effects%linear_drag/inertia + min(product_or_infinity(effects%quadratic_drag/inertia, max(speed, &
            sqrt(2*fall)*sqrt(length))), sqrt(effects%quadratic_drag/inertia*fall))
         rates(cause_drag) = product_or_infinity(decay, steps_per_decay/steps_per_radian)
      end if
      rates(:cause_start) = product_or_infinity(rates(:cause_start), (measured_tolerance/tolerance)**(1.0_wp/9))
      rates(cause_wind:) = product_or_infinity(rates(cause_wind:), (measured_tolerance/tolerance)**(1.0_wp/9))
      cause = maxloc(rates, 1)
      steps = product_or_infinity(duration, product_or_infinity(rates(cause), steps_per_radian))
      if (allocated(effects%pivot_times)) steps = steps + size(effects%pivot_times)
      if (allocated(effects%pivot_curve%times)) steps = steps + size(effects%pivot_curve%times)
      if (allocated(effects%hoist%times)) steps = steps + size(effects%hoist%times)
      steps = max(steps, 1.0_wp)
      if (.not. steps <= huge(steps)) steps = infinity_real64
   end subroutine forecast_steps

   !> How far positions of a conservative scene will be off at the end, in units of the length, about; 0 for others.
   !> Every step takes a part of the tolerance from the energy, much the same each time, so that the rate is off by a
   !> part that grows with the time and the phase with its square. From 1 to 10 000 periods 0.01 to 0.1 of the tolerance
   !> was measured times the square of the periods (`bench/integrated_beside_heyoka.py`).
   pure real(wp) function forecast_error(effects, length, gravity, duration, tolerance)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: length, gravity          !! [m], [m/s2]
      real(wp), intent(in) :: duration                 !! [s]
      real(wp), intent(in) :: tolerance                !! Of the error of a step
      real(wp) :: periods

      forecast_error = 0
      if (has_drag(effects) .or. has_moving_pivot(effects) .or. has_hoist(effects)) return
      periods = duration*sqrt(effective_gravity(gravity, effects%density_ratio, effects%added_mass)/length)/two_pi
      forecast_error = 0.03_wp*tolerance*max(periods, 1.0_wp)**2
   end function forecast_error

end module kyvadlo_step_forecast
