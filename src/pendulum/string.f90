!> A bob on a string, which can only pull: swings on the sphere and free flights between them, every one exact.
!>
!> The string goes slack where its tension over the mass, (2 c1 - 3 g z)/l, reaches zero on the way up; the bob flies
!> freely until it is a length away from the pivot again. There it loses its radial velocity, or gets it back reversed
!> and times the coefficient of restitution, and swings on, or flies on.
module kyvadlo_string
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: is_finite, is_nan, quiet_nan_real64
   use kyvadlo_status, only: error_type, fail, code_domain
   use kyvadlo_cubic, only: cubic_roots
   use kyvadlo_orbit, only: orbit_type
   use kyvadlo_state, only: new_orbit_from_state
   implicit none
   private
   public :: string_motion_type, string_piece_type, string_event_type, new_string_motion, string_starts_in_flight
   public :: event_slack, event_taut, event_rebound, event_end_of_rattling

   integer, parameter :: event_slack = 1            !! The tension vanishes, the bob leaves the sphere
   integer, parameter :: event_taut = 2             !! The string is taut again, the radial velocity is lost
   integer, parameter :: event_rebound = 3          !! The string is taut, the bob rebounds into another flight
   integer, parameter :: event_end_of_rattling = 4  !! As event_taut, by the rule that ends ever smaller rebounds

   !> A stretch of one kind of motion, from `start` to the start of the next one.
   type :: string_piece_type
      real(wp) :: start = 0              !! [s]
      logical :: is_taut = .true.
      type(orbit_type) :: orbit          !! If taut: the swing, its time counted from `start`
      real(wp) :: position(3) = 0        !! At `start` [m]
      real(wp) :: velocity(3) = 0        !! At `start` [m/s]
      real(wp) :: depth = 0  !! Of a flight: (l**2 - |position|**2)/2, not zero only where the motion starts [m2]
   end type string_piece_type

   !> What happened between two pieces.
   type :: string_event_type
      real(wp) :: time = 0               !! [s]
      integer :: kind = 0                !! One of the `event_*` constants
      real(wp) :: position(3) = 0        !! [m]
      real(wp) :: energy_lost = 0        !! Per mass [m2/s2]
   end type string_event_type

   !> The whole motion, set up once; read-only after that.
   type :: string_motion_type
      real(wp) :: length = 0, gravity = 0                  !! [m], [m/s2]
      real(wp) :: rests(2) = 0                             !! What of l and g their rounding took off [m, m/s2]
      real(wp) :: until = -1                               !! The motion is known from 0 to this time [s]
      type(string_piece_type), allocatable :: pieces(:)
      type(string_event_type), allocatable :: events(:)    !! events(i) lies between pieces(i) and pieces(i+1)
      logical :: is_complete = .true.                      !! .false.: ended at the largest number of events
   contains
      procedure, non_overridable :: locate => locate_on_string
   end type string_motion_type

   !> Rebounds end, as if inelastic, when the radial speed is below this part of sqrt(g l): the bob then would come off
   !> by less than its square, an epsilon of the length.
   real(wp), parameter :: rattling = sqrt(epsilon(1.0_wp))
   !> A start further off the sphere, or with a larger part of its speed inwards, begins a flight: as in kyvadlo_gaps.
   real(wp), parameter :: most_off = 1e-3_wp
   !> What rounding leaves of a distance.
   real(wp), parameter :: rounding = 8*epsilon(1.0_wp)
   !> A motion of more pieces than this is cut and says so.
   integer, parameter :: most_events = 100000

contains

   !> Follows the bob from a start on or in the sphere for a duration, event by event.
   pure subroutine new_string_motion(motion, length, gravity, position, velocity, restitution, duration, error, rests)
      type(string_motion_type), intent(out) :: motion
      real(wp), intent(in) :: length, gravity         !! l [m], g [m/s2]
      real(wp), intent(in) :: position(3)             !! At t = 0 [m]
      real(wp), intent(in) :: velocity(3)             !! At t = 0, on the sphere not outwards [m/s]
      real(wp), intent(in) :: restitution             !! Of the radial speed at re-tension, 0 (inelastic) to 1
      real(wp), intent(in) :: duration                !! Events after it are left out [s]
      type(error_type), allocatable, intent(out) :: error
      !> What of l and g their rounding took off, which swings feel after a time [m, m/s2]
      real(wp), intent(in), optional :: rests(2)
      type(string_piece_type) :: piece
      type(string_event_type) :: event
      character(len=24) :: got
      integer :: count

      motion%length = length
      motion%gravity = gravity
      if (present(rests)) motion%rests = rests
      allocate (motion%pieces(8), motion%events(8))
      if (.not. (restitution >= 0 .and. restitution <= 1)) then
         write (got, '(es10.3)') restitution
         call fail(error, code_domain, 'string: restitution must lie between 0 and 1, got '//trim(adjustl(got)))
         return
      end if
      if (string_starts_in_flight(length, position, velocity)) then
         call begin_flight(piece, length, gravity, position, velocity, error)
         if (allocated(error)) return
      else
         ! The set-up checks the rest, and puts the start exactly on the sphere.
         call new_orbit_from_state(piece%orbit, length, gravity, position, velocity, error, rests)
         if (allocated(error)) return
         call piece%orbit%locate(0.0_wp, piece%position, piece%velocity)
         piece%is_taut = .not. piece%orbit%rod_force(0.0_wp) < 0
      end if

      count = 0
      do
         call append_piece(motion%pieces, count + 1, piece)
         if (count == most_events) then
            motion%is_complete = .false.
            exit
         end if
         if (piece%is_taut) then
            call leave(motion, piece, event)
         else
            call arrive(motion, restitution, piece, event, error)
            if (allocated(error)) return
         end if
         if (is_nan(event%time)) exit
         if (event%time > duration) exit
         count = count + 1
         call append_event(motion%events, count, event)
      end do
      motion%pieces = motion%pieces(:count + 1)
      motion%events = motion%events(:count)
      motion%until = merge(duration, piece%start, motion%is_complete)
   end subroutine new_string_motion

   !> Whether a string is slack because its bob starts inside the sphere or moves inwards. Next to the sphere, to the
   !> three digits that people type, a bob that moves along it is on it; and there it may be slack because it is slow.
   pure logical function string_starts_in_flight(length, position, velocity)
      real(wp), intent(in) :: length, position(3), velocity(3)
      real(wp) :: radius, outward, most

      radius = norm2(position)
      outward = dot_product(position, velocity)
      most = most_off*length*norm2(velocity)
      string_starts_in_flight = radius - length <= -most_off*length .or. outward < 0 .and. outward <= -most .or. &
         radius < (1 - rounding)*length .and. outward > 0 .and. outward >= most
   end function string_starts_in_flight

   !> The flight from a start in the sphere, or on it and inwards.
   pure subroutine begin_flight(piece, length, gravity, position, velocity, error)
      type(string_piece_type), intent(out) :: piece
      real(wp), intent(in) :: length, gravity, position(3), velocity(3)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: radius

      radius = norm2(position)
      if (.not. (length > 0 .and. gravity > 0 .and. is_finite(length) .and. is_finite(gravity))) then
         call fail(error, code_domain, 'string: length and gravity must be positive and finite')
      else if (.not. all(is_finite([position, velocity]))) then
         call fail(error, code_domain, 'string: position and velocity must be finite')
      else if (.not. radius <= (1 + most_off)*length) then
         call fail(error, code_domain, 'string: the position must not lie outside the sphere')
      end if
      if (allocated(error)) return
      piece%is_taut = .false.
      piece%position = position
      piece%velocity = velocity
      if (radius >= (1 - rounding)*length) then
         piece%position = position*(length/radius)
      else
         piece%depth = (length - radius)*(length + radius)/2
      end if
   end subroutine begin_flight

   !> The end of a taut piece: the flight that follows. The event's time is NaN if the string stays taut.
   pure subroutine leave(motion, piece, event)
      type(string_motion_type), intent(in) :: motion
      type(string_piece_type), intent(inout) :: piece
      type(string_event_type), intent(out) :: event
      real(wp) :: after

      ! 2 c1 = 3 g z; on the way up the first passage, as the tension is not negative at the start of the piece.
      after = piece%orbit%time_to_height(2*piece%orbit%energy()/(3*motion%gravity))
      event%kind = event_slack
      event%time = piece%start + after
      if (is_nan(after)) return
      call piece%orbit%locate(after, event%position, piece%velocity)
      if (.not. piece%velocity(3) > 0) then
         ! A swing that only touches zero tension at its highest point stays taut.
         event%time = quiet_nan_real64
         return
      end if
      piece%position = event%position
      piece%start = event%time
      piece%is_taut = .false.
   end subroutine leave

   !> The end of a flight: where the bob is a length away from the pivot again, and what it does there. The distance
   !> along p + v t - g t**2/2 is l where g**2 t**3/4 - g vz t**2 + (v**2 - g z) t + 2 p.v = 0; leaving at zero tension,
   !> v**2 = g z and p.v = 0, that is t = 4 vz/g.
   pure subroutine arrive(motion, restitution, piece, event, error)
      type(string_motion_type), intent(in) :: motion
      real(wp), intent(in) :: restitution
      type(string_piece_type), intent(inout) :: piece
      type(string_event_type), intent(out) :: event
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: after, radial, outward(3)

      after = flight_time(motion, piece)
      if (is_nan(after)) then
         call fail(error, code_domain, 'string: no number tells when a flight ends')
         return
      end if
      event%time = piece%start + after
      event%position = piece%position + piece%velocity*after
      event%position(3) = event%position(3) - motion%gravity*after**2/2
      piece%velocity(3) = piece%velocity(3) - motion%gravity*after
      outward = event%position/norm2(event%position)
      event%position = motion%length*outward
      radial = dot_product(piece%velocity, outward)
      piece%velocity = piece%velocity - radial*outward
      piece%position = event%position
      piece%depth = 0
      piece%start = event%time
      if (restitution*radial > rattling*sqrt(motion%gravity*motion%length)) then
         event%kind = event_rebound
         event%energy_lost = (1 - restitution)*(1 + restitution)*radial**2/2
         piece%velocity = piece%velocity - restitution*radial*outward
         return
      end if
      event%kind = merge(event_end_of_rattling, event_taut, restitution > 0)
      event%energy_lost = radial**2/2
      call new_orbit_from_state(piece%orbit, motion%length, motion%gravity, piece%position, piece%velocity, error, &
         motion%rests)
      if (allocated(error)) return
      ! Without radial velocity the bob may still be too slow for its height: then it falls at once.
      piece%is_taut = .not. piece%orbit%rod_force(0.0_wp) < 0
   end subroutine arrive

   !> The first time after the start of a flight at which the string is taut again.
   pure real(wp) function flight_time(motion, piece) result(after)
      type(string_motion_type), intent(in) :: motion
      type(string_piece_type), intent(in) :: piece
      real(wp) :: roots(3), inward, slack, scale_of_speed
      integer :: count, i

      if (piece%depth > 0) then
         after = time_from_inside(motion%gravity, piece)
         return
      end if
      associate (g => motion%gravity, v => piece%velocity)
         inward = 2*dot_product(piece%position, v)
         slack = dot_product(v, v) - g*piece%position(3)
         scale_of_speed = dot_product(v, v) + g*motion%length
         ! A flight that leaves tangentially has v.p = 0 up to the rounding of v.
         if (abs(inward) <= 64*epsilon(g)*motion%length*sqrt(scale_of_speed)) inward = 0
         ! A flight from zero tension has v**2 = g z up to rounding.
         if (abs(inward) <= 0 .and. abs(slack) <= 64*epsilon(g)*scale_of_speed) slack = 0
         call cubic_roots(g**2/4, -g*v(3), slack, inward, roots, count)
         after = quiet_nan_real64
         do i = count, 1, -1
            if (roots(i) > 0) after = roots(i)
         end do
      end associate
   end function flight_time

   !> The first time at which a flight from inside the sphere meets it: the first root of h = depth - p.v t - (v**2 - g
   !> z) t**2/2 + g vz t**3/2 - g**2 t**4/8, between two of its stationary points, by bisection that Newton's method
   !> cuts short.
   pure real(wp) function time_from_inside(gravity, piece) result(after)
      real(wp), intent(in) :: gravity
      type(string_piece_type), intent(in) :: piece
      real(wp) :: roots(3), low, high, next, value, slope, a(4)
      integer :: count, i
      integer, parameter :: most_halvings = 4*digits(1.0_wp)

      associate (g => gravity, p => piece%position, v => piece%velocity)
         a = [dot_product(p, v), (dot_product(v, v) - g*p(3))/2, -g*v(3)/2, g**2/8]
         call cubic_roots(4*a(4), 3*a(3), 2*a(2), a(1), roots, count)
      end associate
      low = 0
      do i = 1, count
         if (.not. roots(i) > 0) cycle
         if (inside(roots(i)) < 0) exit
         low = roots(i)
      end do
      if (i <= count) then
         high = roots(i)
      else
         ! Beyond the last stationary point it falls.
         high = max(2*low, sqrt(sqrt(piece%depth/a(4))))
         do while (inside(high) > 0)
            high = 2*high
         end do
      end if
      after = (low + high)/2
      do i = 1, most_halvings
         value = inside(after)
         if (value > 0) then
            low = after
         else
            high = after
         end if
         slope = -(a(1) + after*(2*a(2) + after*(3*a(3) + after*4*a(4))))
         next = (low + high)/2
         if (slope < 0) next = after - value/slope
         if (.not. (next > low .and. next < high)) next = (low + high)/2
         if (abs(next - after) <= epsilon(after)*after .or. high - low <= epsilon(after)*high) exit
         after = next
      end do

   contains

      pure real(wp) function inside(t)
         real(wp), intent(in) :: t

         inside = piece%depth - t*(a(1) + t*(a(2) + t*(a(3) + t*a(4))))
      end function inside
   end function time_from_inside

   !> Position, velocity and tension over mass at a time within the motion; NaN outside it, and of a motion that failed.
   pure subroutine locate_on_string(motion, time, position, velocity, tension)
      class(string_motion_type), intent(in) :: motion
      real(wp), intent(in) :: time              !! 0 to the duration, of an incomplete motion to its last event [s]
      real(wp), intent(out) :: position(3)      !! [m]
      real(wp), intent(out) :: velocity(3)      !! [m/s]
      real(wp), intent(out) :: tension          !! Per mass [m/s2]; zero in flight
      integer :: low, high, middle
      real(wp) :: since

      if (.not. (time >= 0 .and. time <= motion%until)) then
         tension = quiet_nan_real64
         position = tension
         velocity = tension
         return
      end if
      low = 1
      high = size(motion%pieces)
      do while (low < high)
         middle = (low + high + 1)/2
         if (motion%pieces(middle)%start <= time) then
            low = middle
         else
            high = middle - 1
         end if
      end do
      associate (piece => motion%pieces(low))
         since = time - piece%start
         if (piece%is_taut) then
            call piece%orbit%locate(since, position, velocity)
            tension = piece%orbit%rod_force(since)
         else
            position = piece%position + piece%velocity*since
            position(3) = position(3) - motion%gravity*since**2/2
            velocity = piece%velocity
            velocity(3) = velocity(3) - motion%gravity*since
            tension = 0
         end if
      end associate
   end subroutine locate_on_string

   pure subroutine append_piece(pieces, place, piece)
      type(string_piece_type), allocatable, intent(inout) :: pieces(:)
      integer, intent(in) :: place
      type(string_piece_type), intent(in) :: piece
      type(string_piece_type), allocatable :: larger(:)

      if (place > size(pieces)) then
         allocate (larger(2*size(pieces)))
         larger(:size(pieces)) = pieces
         call move_alloc(larger, pieces)
      end if
      pieces(place) = piece
   end subroutine append_piece

   pure subroutine append_event(events, place, event)
      type(string_event_type), allocatable, intent(inout) :: events(:)
      integer, intent(in) :: place
      type(string_event_type), intent(in) :: event
      type(string_event_type), allocatable :: larger(:)

      if (place > size(events)) then
         allocate (larger(2*size(events)))
         larger(:size(events)) = events
         call move_alloc(larger, events)
      end if
      events(place) = event
   end subroutine append_event

end module kyvadlo_string
