!> A motion seen from a frame that turns about the vertical through the pivot, in closed form.
module kyvadlo_turning_frame
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_pairs_real64, only: operator(*), operator(-), pair_type, pi_pair, scaled, two_product, value
   implicit none
   private
   public :: seen_from_turning_frame, frame_angle

contains

   !> Position and velocity in axes that turn with `rate` and coincide with the resting ones at time 0: both turned by
   !> -rate*time, the velocity less that of the frame there. Any motion may be looked at so, integrated or not.
   pure subroutine seen_from_turning_frame(rate, time, position, velocity)
      real(wp), intent(in) :: rate              !! Counter-clockwise seen from above [rad/s]
      real(wp), intent(in) :: time              !! [s]
      real(wp), intent(inout) :: position(3)    !! At rest in, turning out [m]
      real(wp), intent(inout) :: velocity(3)    !! [m/s]
      real(wp) :: c, s, angle

      angle = frame_angle(rate, time)
      c = cos(angle)
      s = sin(angle)
      velocity(:2) = velocity(:2) - rate*[-position(2), position(1)]
      position(:2) = [c*position(1) + s*position(2), c*position(2) - s*position(1)]
      velocity(:2) = [c*velocity(1) + s*velocity(2), c*velocity(2) - s*velocity(1)]
   end subroutine seen_from_turning_frame

   !> rate*time less whole turns, the product in two parts: rounded to one it would be off by an angle that grows with
   !> it [rad].
   elemental real(wp) function frame_angle(rate, time) result(angle)
      real(wp), intent(in) :: rate, time        !! [rad/s], [s]
      type(pair_type) :: whole
      real(wp), parameter :: two_pi = 2*acos(-1.0_wp)

      whole = two_product(rate, time)
      angle = value(whole)
      if (abs(angle) > two_pi) angle = value(whole - scaled(pi_pair, 1)*anint(angle/two_pi))
   end function frame_angle

end module kyvadlo_turning_frame
