!> What is measured of one state, and how it changes: columns of a table, one by one.
module kyvadlo_fit_observation
   use kyvadlo_fit_data
   use kyvadlo_fit_physics, only: acceleration_of, camera_type, direction_type, &
      gravity_felt, moved, physics_type, plane_of, &
      tension_of, unit_period
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_state_real64, only: new_orbit_from_state
   use kyvadlo_status, only: error_type
   implicit none
   private
   public :: observe, observe_moved, to_event, period_of, camera_scale, camera_angle, camera_offset

   !> What of a camera an unknown is; 0: nothing; an offset along u or v: that and 0 or 1.
   integer, parameter :: camera_scale = 1, camera_angle = 2, camera_offset = 3

   real(wp), parameter :: pi = acos(-1.0_wp), degree = pi/180

contains

   !> What a position shows: its rate, and its derivatives but for what moves the time.
   subroutine observe(parts, axes, column, value, length, slopes, camera, state, h, rate, matrix, derivatives)
      integer, intent(in) :: parts(:)                    !! Of the camera, that the unknowns are
      integer, intent(in) :: axes(2), column
      real(wp), intent(in) :: value                      !! Measured; angles count from the nearest turn
      real(wp), intent(in) :: length
      real(wp), intent(in) :: slopes(:)                  !! Of the numbers of unknowns that are scalars
      type(camera_type), intent(in) :: camera
      real(wp), intent(in) :: state(6)
      real(wp), intent(out) :: h, rate
      real(wp), intent(in), optional :: matrix(:, :)     !! (6, unknowns)
      real(wp), intent(inout), optional :: derivatives(:)
      real(wp) :: slope(3), c, s, a, b, square
      integer :: j

      slope = 0
      select case (column)
      case (column_x:column_z)
         h = state(column)
         slope(column) = 1
      case (column_azimuth)
         square = max(state(1)**2 + state(2)**2, 1e-12_wp*length**2)
         h = atan2(state(2), state(1))
         h = h + 2*pi*anint((value - h)/(2*pi))
         slope(1:2) = [-state(2), state(1)]/square
      case (column_angle)
         square = max(state(1)**2 + state(3)**2, 1e-12_wp*length**2)
         h = atan2(state(1), -state(3))
         h = h + 2*pi*anint((value - h)/(2*pi))
         slope([1, 3]) = [-state(3), state(1)]/square
      case default
         c = camera%scale*cos(camera%angle)
         s = camera%scale*sin(camera%angle)
         a = state(axes(1)) + camera%offset(1)
         b = state(axes(2)) + camera%offset(2)
         if (column == column_u) then
            slope(axes) = [c, -s]
            h = c*a - s*b
         else
            slope(axes) = [s, c]
            h = s*a + c*b
         end if
      end select
      rate = dot_product(slope, state(4:6))
      if (.not. present(derivatives)) return
      do j = 1, size(derivatives)
         derivatives(j) = slope(1)*matrix(1, j) + slope(2)*matrix(2, j) + slope(3)*matrix(3, j)
      end do
      if (column /= column_u .and. column /= column_v) return
      do j = 1, size(derivatives)
         select case (parts(j))
         case (camera_scale)
            derivatives(j) = derivatives(j) + slopes(j)*h/camera%scale
         case (camera_angle)
            derivatives(j) = derivatives(j) + slopes(j)*degree*merge(-(s*a + c*b), c*a - s*b, column == column_u)
         case (camera_offset:)
            derivatives(j) = derivatives(j) + slopes(j)*slope(axes(1 + parts(j) - camera_offset))
         end select
      end do
   end subroutine observe

   !> Tension and plane, which follow from forces: of a state relative to the pivot, in resting axes. Their derivatives
   !> are central differences of short closed forms.
   subroutine observe_moved(column, value, physics, directions, time, state, h, rate, matrix, derivatives)
      integer, intent(in) :: column
      real(wp), intent(in) :: value                      !! Measured; planes count from the nearest half turn
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)
      real(wp), intent(in) :: time, state(6)
      real(wp), intent(out) :: h, rate
      real(wp), intent(in), optional :: matrix(:, :)     !! (6, unknowns)
      real(wp), intent(inout), optional :: derivatives(:)
      real(wp), parameter :: small = 1e-6_wp             !! Of natural sizes: differences keep nine digits
      real(wp) :: step, acceleration(3), tension, speed
      integer :: j

      h = of(physics, time, state, value)
      call acceleration_of(physics, time, state, acceleration, tension)
      speed = sqrt(physics%length*physics%gravity)
      step = small*physics%length/speed
      associate (m => [state(4:6), acceleration])
         rate = (of(physics, time + step, state + step*m, h) - of(physics, time - step, state - step*m, h))/(2*step)
      end associate
      if (.not. present(derivatives)) return
      do j = 1, size(directions)
         associate (m => matrix(:, j))
            step = small/max(maxval(abs(m(1:3)))/physics%length, maxval(abs(m(4:6)))/speed, 1.0_wp)
            derivatives(j) = (of(moved(physics, directions(j), step), time, state + step*m, h) - &
               of(moved(physics, directions(j), -step), time, state - step*m, h))/(2*step)
         end associate
      end do

   contains

      real(wp) function of(physics, time, state, next_to)
         type(physics_type), intent(in) :: physics
         real(wp), intent(in) :: time, state(6), next_to

         if (column == column_tension) then
            of = tension_of(physics, time, state)
         else
            of = plane_of(physics, time, state, next_to)
         end if
      end function of
   end subroutine observe_moved

   !> From the time of a state on to the event next to it: by the orbit that gravity alone would make of it,
   !> then by Newton's steps.
   subroutine to_event(physics, is_low, pass, state, time, lift, failed)
      type(physics_type), intent(in) :: physics
      logical, intent(in) :: is_low                      !! The lowest point, else the highest
      integer, intent(in) :: pass
      real(wp), intent(in) :: state(6)                   !! Relative to the pivot
      real(wp), intent(inout) :: time
      real(wp), intent(out) :: lift                      !! Vertical acceleration there
      logical, intent(out) :: failed
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      real(wp) :: felt, step, acceleration(3), tension, natural

      failed = .false.
      felt = gravity_felt(physics)
      if (physics%is_exact) then
         lift = -felt - (dot_product(state(4:6), state(4:6)) - felt*state(3))*state(3)/dot_product(state(1:3), &
            state(1:3))
      else
         call acceleration_of(physics, time, state, acceleration, tension)
         lift = acceleration(3)
      end if
      natural = sqrt(physics%length/physics%gravity)
      if (pass == 1 .or. (pass == 2 .and. (lift > 0 .neqv. is_low))) then
         call new_orbit_from_state(orbit, norm2(state(1:3)), felt, state(1:3), state(4:6), error)
         failed = allocated(error)
         if (failed) return
         step = orbit%next_turning_time(0.0_wp)
         associate (half => orbit%period()/2)
            failed = .not. (step <= huge(step) .and. half <= huge(half))
            if (failed) return
            if ((orbit%rise(step) < orbit%rise(step + half)) .neqv. is_low) step = step + half
            if (step > half) step = step - 2*half
            ! Before the motion began there was none; what noise lets seem so was at its beginning.
            if (.not. physics%is_exact .and. time + step < -half/2) step = step + 2*half
         end associate
      else
         step = 0
         if (abs(lift) > 0) step = -state(6)/lift
         step = max(-0.1_wp, min(0.1_wp, step/natural))*natural
      end if
      time = time + step
   end subroutine to_event

   !> The period to and fro of a plane swing.
   subroutine period_of(physics, directions, amplitude, h, derivatives)
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)
      real(wp), intent(in) :: amplitude                  !! [rad]
      real(wp), intent(out) :: h
      real(wp), intent(inout), optional :: derivatives(:)
      real(wp) :: r, a, gravity
      integer :: j

      h = sqrt(physics%length/gravity_felt(physics))*unit_period(amplitude)
      if (.not. present(derivatives)) return
      r = physics%effects%density_ratio
      a = physics%effects%added_mass
      do j = 1, size(directions)
         associate (change => directions(j)%change)
            gravity = change%gravity/physics%gravity - change%effects%density_ratio*(1/(1 - r) + a/(1 + a*r)) - &
               change%effects%added_mass*r/(1 + a*r)
            derivatives(j) = h/2*(change%length/physics%length - gravity)
         end associate
      end do
   end subroutine period_of

end module kyvadlo_fit_observation
