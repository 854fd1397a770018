!> What a scene takes from its orbit, where that moves in closed form.
module kyvadlo_closed_form
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_motion_kinds
   use kyvadlo_orbit_real64, only: orbit_type
   implicit none
   private
   public :: closed_form_words, default_duration, lowest_tension

   real(wp), parameter :: pi = acos(-1.0_wp)

contains

   !> The tension over mass at the highest point of an orbit, (2 c1 - 3 g z1)/l [m/s2].
   pure real(wp) function lowest_tension(orbit)
      type(orbit_type), intent(in) :: orbit

      lowest_tension = (2*orbit%energy() - 3*orbit%gravity*orbit%turning%upper)/orbit%length
   end function lowest_tension

   !> One period: of the height, of a plane swing to and fro, of a revolution of a conical pendulum; for the motion that
   !> never reaches the top and for rest at it, 4 sqrt(l/g).
   pure real(wp) function default_duration(orbit) result(duration)
      type(orbit_type), intent(in) :: orbit

      select case (orbit%motion)
      case (motion_conical)
         duration = 2*pi*sqrt(-orbit%turning%upper/orbit%gravity)
      case (motion_plane_libration)
         duration = 2*orbit%period()
      case (motion_separatrix, motion_upright)
         duration = 4*sqrt(orbit%length/orbit%gravity)
      case default
         duration = orbit%period()
      end select
   end function default_duration

   !> How it is computed, in words, blanks behind.
   pure function closed_form_words(orbit) result(words)
      type(orbit_type), intent(in) :: orbit
      character(len=80) :: words

      select case (orbit%motion)
      case (motion_conical)
         words = 'closed form of the conical pendulum: a uniform circle, by the batch kernel'
      case (motion_plane_libration)
         words = 'closed form of the plane swing, by the batch kernel'
      case (motion_plane_rotation)
         words = 'closed form of the plane revolution, by the batch kernel'
      case (motion_separatrix)
         words = 'closed form of the motion towards the top, in hyperbolic functions'
      case default
         words = 'closed form of the spherical pendulum in theta functions, by the batch kernel'
      end select
   end function closed_form_words

end module kyvadlo_closed_form
