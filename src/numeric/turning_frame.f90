!> A motion seen from a frame that turns about the vertical through the pivot, in closed form.
module kyvadlo_turning_frame
   use kyvadlo_kinds, only: wp => real64
   implicit none
   private
   public :: seen_from_turning_frame

contains

   !> Position and velocity in axes that turn with `rate` and coincide with the resting ones at time 0: both turned by
   !> -rate*time, the velocity less that of the frame there. Any motion may be looked at so, integrated or not.
   pure subroutine seen_from_turning_frame(rate, time, position, velocity)
      real(wp), intent(in) :: rate              !! Counter-clockwise seen from above [rad/s]
      real(wp), intent(in) :: time              !! [s]
      real(wp), intent(inout) :: position(3)    !! At rest in, turning out [m]
      real(wp), intent(inout) :: velocity(3)    !! [m/s]
      real(wp) :: c, s

      c = cos(rate*time)
      s = sin(rate*time)
      velocity(:2) = velocity(:2) - rate*[-position(2), position(1)]
      position(:2) = [c*position(1) + s*position(2), c*position(2) - s*position(1)]
      velocity(:2) = [c*velocity(1) + s*velocity(2), c*velocity(2) - s*velocity(1)]
   end subroutine seen_from_turning_frame

end module kyvadlo_turning_frame
