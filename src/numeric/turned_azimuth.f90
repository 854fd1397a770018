!> The azimuth of a bob that is followed from place to place, whole turns counted.
module kyvadlo_turned_azimuth
   use kyvadlo_kinds, only: wp => real64
   implicit none
   private
   public :: turned_azimuth

   real(wp), parameter :: two_pi = 2*acos(-1.0_wp)
   !> What rounding leaves of a half turn: the bob passed through the axis if less is missing.
   real(wp), parameter :: close_to_half = sqrt(epsilon(1.0_wp))

contains

   !> The azimuth of a place that is nearest to the one before. A half turn, through the axis, counts upwards, as in the closed
   !> form of the plane swing; on the axis the azimuth stays what it was.
   elemental real(wp) function turned_azimuth(x, y, before) result(azimuth)
      real(wp), intent(in) :: x, y      !! Of the place [m]
      real(wp), intent(in) :: before    !! [rad]

      azimuth = before
      if (.not. (abs(x) > 0 .or. abs(y) > 0)) return
      azimuth = atan2(y, x)
      azimuth = azimuth - two_pi*anint((azimuth - before - close_to_half)/two_pi)
   end function turned_azimuth

end module kyvadlo_turned_azimuth
