!> The azimuth of a bob that is followed from position to position, whole turns counted.
module kyvadlo_turned_azimuth
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers_real64, only: is_finite
   implicit none
   private
   public :: turned_azimuth, is_upright

   real(wp), parameter :: two_pi = 2*acos(-1.0_wp)
   !> What rounding leaves of a half turn: the bob passed through the axis if less is missing.
   real(wp), parameter :: close_to_half = sqrt(epsilon(1.0_wp))

contains

   !> The azimuth of a position that is nearest to the one before; on the axis that of the direction in which the bob
   !> moves. A half turn, through the axis, counts upwards, as in the closed form of the plane swing. A bob at rest on
   !> the axis keeps the azimuth it had; where none is known yet (NaN) the first is the angle between -pi and pi.
   elemental real(wp) function turned_azimuth(x, y, vx, vy, before) result(azimuth)
      real(wp), intent(in) :: x, y      !! Of the position [m]
      real(wp), intent(in) :: vx, vy    !! Of the velocity [m/s]
      real(wp), intent(in) :: before    !! [rad]

      azimuth = before
      ! A zero with a sign would be half a turn down.
      if (.not. is_upright(x, y)) then
         azimuth = atan2(y + 0, x)
      else if (.not. is_upright(vx, vy)) then
         azimuth = atan2(vy + 0, vx)
      else
         return
      end if
      if (is_finite(before)) azimuth = azimuth - two_pi*anint((azimuth - before - close_to_half)/two_pi)
   end function turned_azimuth

   !> Whether a horizontal vector has no direction.
   elemental logical function is_upright(x, y)
      real(wp), intent(in) :: x, y

      is_upright = .not. (abs(x) > 0 .or. abs(y) > 0)
   end function is_upright

end module kyvadlo_turned_azimuth
