!> The ellipse of a swing: that of the orbit which the bob would follow if from now on nothing acted but gravity and the
!> rod. It is found from position and velocity, and its line of apsides is followed from sample to sample.
module kyvadlo_swing_ellipse
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_motion_kinds
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_pairs_real64, only: value
   use kyvadlo_state_real64, only: new_orbit_from_state
   use kyvadlo_status, only: error_type
   implicit none
   private
   public :: ellipse_type, apsides_type, next_ellipse

   type :: ellipse_type
      real(wp) :: major = 0        !! Horizontal radius at the upper turning height [m]
      real(wp) :: minor = 0        !! ... at the lower one [m]
      real(wp) :: plane = 0        !! Azimuth of the nearest upper turning point, half turns taken off [rad]; NaN: none
      real(wp) :: handedness = 0   !! 1 anticlockwise seen from above, -1 clockwise, 0 in a plane
   end type ellipse_type

   !> The line of apsides of the sample before: a line that turns at the mean rate of the orbit does not jump where
   !> another upper turning point comes to be the nearest.
   type :: apsides_type
      private
      real(wp) :: line = 0, time = 0   !! [rad], [s]
      logical :: is_known = .false.
   end type apsides_type

   real(wp), parameter :: pi = acos(-1.0_wp)
   !> What the roundings of positions and velocities make of a circle, or of a plane: parts of the larger radius.
   real(wp), parameter :: noise = 64*epsilon(1.0_wp)

contains

   !> The ellipse at a time not earlier than the one before. NaN where the bob is at the pivot.
   pure subroutine next_ellipse(apsides, time, position, velocity, gravity, ellipse)
      type(apsides_type), intent(inout) :: apsides
      real(wp), intent(in) :: time                      !! [s]
      real(wp), intent(in) :: position(3), velocity(3)  !! Relative to the pivot [m], [m/s]; what is radial is left out
      real(wp), intent(in) :: gravity                   !! Effective [m/s2]
      type(ellipse_type), intent(out) :: ellipse
      type(error_type), allocatable :: error
      type(orbit_type) :: orbit
      real(wp) :: length, since, rate, line, along(3)
      logical :: is_circle, is_rotation

      ellipse = ellipse_type(quiet_nan_real64, quiet_nan_real64, quiet_nan_real64, quiet_nan_real64)
      length = norm2(position)
      if (.not. length > 0) return
      along = velocity - dot_product(velocity, position/length)*(position/length)
      call new_orbit_from_state(orbit, length, gravity, position, along, error)
      if (allocated(error)) return
      ellipse%major = sqrt(orbit%turning%upper_rise*orbit%turning%upper_gap)
      ellipse%minor = sqrt(orbit%turning%lower_rise*orbit%turning%lower_gap)
      ellipse%handedness = 0
      is_circle = abs(ellipse%major - ellipse%minor) <= noise*ellipse%major
      is_rotation = orbit%energy() > gravity*length .and. ellipse%minor <= noise*length
      if (is_rotation .or. ellipse%minor <= noise*ellipse%major) ellipse%minor = 0
      if (is_rotation) ellipse%major = 0
      if (ellipse%minor > 0) ellipse%handedness = sign(1.0_wp, orbit%momentum())
      if (is_circle .or. is_rotation .or. .not. ellipse%major > 0) return
      if (.not. any(orbit%motion == [motion_generic, motion_plane_libration])) return
      since = value(orbit%start_phase)
      rate = orbit%apsidal_rate()
      line = orbit%azimuth(-since) + rate*since
      if (apsides%is_known) line = line - pi*anint((line - apsides%line - rate*(time - apsides%time))/pi)
      apsides = apsides_type(line, time, .true.)
      ellipse%plane = line - rate*(since - orbit%period()*anint(since/orbit%period()))
   end subroutine next_ellipse

end module kyvadlo_swing_ellipse
