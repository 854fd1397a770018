!> The jump of derivatives where a string becomes taut, and what is too close to a touch to have any.
module kyvadlo_saltation
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_suspension, only: stretch, stretch_change, suspension_change_type, suspension_type
   implicit none
   private
   public :: jump_at_shock, is_tangential

contains

   !> A motion next to this one becomes taut later by `late`; until then it moves on as before, and where this one has
   !> gone on as after: saltation (doc/effects.md).
   pure subroutine jump_at_shock(suspension, change, before, after, back, softer, column)
      type(suspension_type), intent(in) :: suspension
      type(suspension_change_type), intent(in) :: change
      real(wp), intent(in) :: before(9)         !! Position, velocity, acceleration before the shock
      real(wp), intent(in) :: after(6)          !! Velocity, acceleration after it
      real(wp), intent(in) :: back              !! Part of the radial speed that comes back
      real(wp), intent(in) :: softer            !! Change of the restitution
      real(wp), intent(inout) :: column(6)      !! Changes of position and velocity
      real(wp), dimension(3) :: outward, outward_change, moved, turned
      real(wp) :: distance, bending, distance_change, bending_change, late, radial, radial_change

      associate (p => before(1:3), v => before(4:6), a => before(7:9))
         call stretch(suspension, p, v, distance, outward, bending)
         radial = dot_product(outward, v)
         moved = column(1:3)
         turned = column(4:6)
         call stretch_change(suspension, change, p, v, moved, turned, distance_change, outward_change, bending_change)
         late = (change%radius - distance_change)/radial
         moved = moved + v*late
         turned = turned + a*late
         call stretch_change(suspension, change, p, v, moved, turned, distance_change, outward_change, bending_change)
         radial_change = dot_product(outward_change, v) + dot_product(outward, turned)
         turned = turned - (1 + back)*(radial_change*outward + radial*outward_change)
         ! Without restitution a flight of a first rebound would end at once, with no rest of that order.
         if (back > 0) turned = turned - softer*radial*outward
      end associate
      column(1:3) = moved - after(1:3)*late
      column(4:6) = turned - after(4:6)*late
   end subroutine jump_at_shock

   !> Whether a distance that vanishes with this slope is one that its error and its bend could keep from vanishing.
   elemental logical function is_tangential(slope, bend, length, closeness)
      real(wp), intent(in) :: slope        !! [m/s]
      real(wp), intent(in) :: bend         !! Scale of its second derivative [m/s2]
      real(wp), intent(in) :: length       !! Its scale [m]
      real(wp), intent(in) :: closeness    !! Its error in that scale

      is_tangential = .not. abs(slope) > sqrt(2*closeness*bend*length)
   end function is_tangential

end module kyvadlo_saltation
