!> What may act on a real pendulum besides gravity and a rigid rod: one value, in which zero means off.
module kyvadlo_effects
   use kyvadlo_kinds, only: wp => real64
   implicit none
   private
   public :: effects_type, any_effect, applied_acceleration, drag_acceleration, pivot_acceleration

   !> The effects of a scene; each is off unless given. They add up.
   type :: effects_type
      real(wp) :: linear_drag = 0         !! Deceleration per speed through the air [1/s]
      real(wp) :: quadratic_drag = 0      !! Deceleration per square of that speed [1/m]
      real(wp) :: wind(3) = 0             !! Steady velocity of the air [m/s]
      real(wp) :: turn_rate(3) = 0        !! Rotation of the frame, as of the Earth; x east, y north, z up [rad/s]
      real(wp) :: pivot_amplitude(3) = 0  !! Of the pivot's displacement amplitude*cos(2 pi frequency t + phase) [m]
      real(wp) :: pivot_frequency(3) = 0  !! [Hz]
      real(wp) :: pivot_phase(3) = 0      !! [rad]
   end type effects_type

   real(wp), parameter :: two_pi = 2*acos(-1.0_wp)

contains

   !> Whether the closed form does not answer.
   elemental logical function any_effect(effects)
      type(effects_type), intent(in) :: effects

      any_effect = abs(effects%linear_drag) > 0 .or. abs(effects%quadratic_drag) > 0 .or. any(abs(effects%turn_rate) > 0) &
         .or. any(abs(effects%pivot_amplitude*effects%pivot_frequency) > 0)
   end function any_effect

   !> Everything but the force of the rod, in the frame of the pivot [m/s2].
   pure function applied_acceleration(effects, gravity, time, velocity) result(rates)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: gravity      !! Downwards [m/s2]
      real(wp), intent(in) :: time         !! [s]
      real(wp), intent(in) :: velocity(3)  !! Of the bob, relative to the pivot [m/s]
      real(wp) :: rates(3)

      rates = drag_acceleration(effects, time, velocity) - pivot_acceleration(effects, time)
      ! Coriolis; the constant centrifugal part belongs to the local gravity.
      associate (w => effects%turn_rate, v => velocity)
         rates(1) = rates(1) - 2*(w(2)*v(3) - w(3)*v(2))
         rates(2) = rates(2) - 2*(w(3)*v(1) - w(1)*v(3))
         rates(3) = rates(3) - 2*(w(1)*v(2) - w(2)*v(1)) - gravity
      end associate
   end function applied_acceleration

   !> Drag against the velocity through the air: of the bob, of its pivot, less the wind.
   pure function drag_acceleration(effects, time, velocity) result(rates)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: time, velocity(3)
      real(wp) :: rates(3)
      real(wp) :: through_air(3)

      through_air = velocity + pivot_velocity(effects, time) - effects%wind
      rates = -(effects%linear_drag + effects%quadratic_drag*norm2(through_air))*through_air
   end function drag_acceleration

   !> Second derivative of the pivot's displacement [m/s2].
   pure function pivot_acceleration(effects, time) result(rates)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: time
      real(wp) :: rates(3)

      associate (rate => two_pi*effects%pivot_frequency)
         rates = -effects%pivot_amplitude*rate**2*cos(rate*time + effects%pivot_phase)
      end associate
   end function pivot_acceleration

   !> First derivative of the pivot's displacement [m/s].
   pure function pivot_velocity(effects, time) result(rates)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: time
      real(wp) :: rates(3)

      associate (rate => two_pi*effects%pivot_frequency)
         rates = -effects%pivot_amplitude*rate*sin(rate*time + effects%pivot_phase)
      end associate
   end function pivot_velocity

end module kyvadlo_effects
