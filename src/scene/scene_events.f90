!> The events that a scene asks for: a column of its quantities passes a value. On one orbit heights, and what depends
!> on the height alone, pass it at times in closed form; other quantities are followed by kyvadlo_crossings.
module kyvadlo_scene_events
   use kyvadlo_crossings
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_motion_kinds
   use kyvadlo_numbers, only: is_nan
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_pairs_real64, only: pair_type, pair, value, operator(+), operator(-), operator(*)
   use kyvadlo_pivot, only: pivot_motion
   use kyvadlo_quantities
   use kyvadlo_samples, only: scene_event_type
   use kyvadlo_scene_groups, only: moving_pivot_group
   use kyvadlo_scene_settings, only: event_request_type
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_simulation_path, only: path_closed_form, path_string, path_type
   implicit none
   private
   public :: event_search_type, begin_search, forget_found, search_orbit, search_string, search_stretch

   !> Times phase + n T less that of the start, one after the other.
   type :: sequence_type
      integer :: request = 0, direction = 0
      type(pair_type) :: phase           !! Since an upper turning point [s]
      real(wp) :: turns = 0              !! n of the next one
      real(wp) :: next = 0               !! [s]
      logical :: is_periodic = .true.    !! If not, there is one
   end type sequence_type

   type :: event_search_type
      type(event_request_type), allocatable :: requests(:)
      type(scene_event_type), allocatable :: found(:)  !! Since `forget_found`, in the order of time; so many:
      integer :: count = 0
      logical :: is_over = .false.                     !! The last one found ends the simulation
      type(extreme_type), allocatable :: extremes(:)
      type(watch_type), allocatable, private :: watches(:) !! Of column 0 where there is a formula, or nothing to see
      type(sequence_type), allocatable, private :: sequences(:)
      integer, private :: position = 0                 !! Column of x
      integer, private :: visible = 0                  !! Columns to hand over, the time first
      integer, private :: piece = 1                    !! Of a string
      real(wp), private :: point_distance = 0          !! Of a path in closed form [s]
      real(wp), private :: extremes_until = huge(1.0_wp) !! They are known from there on [s]
   end type event_search_type

   !> What is nearer to a value than so many epsilons of the quantity's size is not told from it.
   real(wp), parameter :: noise_part = 64*epsilon(1.0_wp)
   !> Points of a stretch of a path in closed form, at most, and their distance in the time in which the bob turns by 1.
   integer, parameter :: most_points = 512
   real(wp), parameter :: distance_part = 0.2_wp

contains

   !> Ready for the start of a scene.
   subroutine begin_search(search, simulation, path, column, visible)
      type(event_search_type), intent(inout) :: search        !! Its extremes know their quantities already
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      integer, intent(in) :: column(:)                        !! First column of a quantity
      integer, intent(in) :: visible
      real(wp) :: sizes(size(quantities), 3), bends(size(quantities), 3), displacement(3), velocity(3)
      integer :: i

      search%requests = simulation%settings%events
      allocate (search%watches(size(search%requests)), search%sequences(0), search%found(8))
      if (.not. allocated(search%extremes)) allocate (search%extremes(0))
      search%position = column(quantity_position)
      search%visible = visible
      search%piece = 1
      call find_sizes(path, simulation%settings%frame_rate, sizes, bends, search%point_distance)
      displacement = 0
      if (simulation%settings%given(moving_pivot_group) .and. .not. simulation%settings%relative) &
         call pivot_motion(path%effects, 0.0_wp, displacement, velocity)
      do i = 1, size(search%requests)
         associate (request => search%requests(i), watch => search%watches(i))
            watch%column = column(request%quantity) + request%component - 1
            watch%value = request%value
            watch%noise = noise_part*max(abs(request%value), sizes(request%quantity, request%component))
            watch%bend = bends(request%quantity, request%component)
            if (path%path /= path_closed_form) cycle
            if (conserves(path%orbit, request%quantity, simulation%settings%frame_rate)) watch%column = 0
            if (watch%column > 0 .and. has_formula(request, simulation%settings%frame_rate)) then
               call add_sequences(search, path, i, displacement(3), watch%noise)
               watch%column = 0
            end if
         end associate
      end do
      if (path%path == path_closed_form .and. path%orbit%period() < huge(1.0_wp)) &
         search%extremes_until = path%orbit%period()
   end subroutine begin_search

   !> How large quantities may be, bounds of their second derivatives (negative: none is known), and the distance of
   !> points that show the motion.
   pure subroutine find_sizes(path, rate, sizes, bends, distance)
      type(path_type), intent(in) :: path
      real(wp), intent(in) :: rate                            !! Of the frame [rad/s]
      real(wp), intent(out), dimension(:, :) :: sizes, bends
      real(wp), intent(out) :: distance
      real(wp) :: speed, radius, force, gravity, across, climb

      gravity = path%gravity
      if (path%path == path_closed_form) gravity = path%orbit%gravity
      if (path%path == path_string) gravity = path%string%gravity
      associate (l => path%length, w => abs(rate))
         speed = sqrt(max(dot_product(path%velocity, path%velocity) + 2*gravity*(path%position(3) + l), gravity*l))
         radius = l
         if (path%path == path_closed_form) then
            speed = path%orbit%speed(-value(path%orbit%start_phase) + path%orbit%period()/2)
            if (path%orbit%motion == motion_separatrix) speed = 2*sqrt(gravity*l)
            if (path%orbit%turning%upper < 0) radius = sqrt(path%orbit%turning%upper_rise*path%orbit%turning%upper_gap)
         end if
         ! Of the rod, per mass; the largest acceleration across, and the largest vertical speed.
         force = speed**2/l + gravity
         across = force*radius/l
         climb = speed*min(1.0_wp, radius/l)
         sizes = 1
         bends = -1
         sizes(quantity_position, :) = [radius, radius, l]
         sizes(quantity_velocity, :) = speed
         sizes(quantity_speed, :) = speed
         sizes(quantity_energy, :) = speed**2 + gravity*l
         sizes(quantity_drag_work, :) = speed**2
         sizes(quantity_pivot_work, :) = speed**2
         sizes(quantity_momentum, :) = l*speed
         sizes(quantity_tension, :) = force
         sizes(quantity_major, :) = l
         sizes(quantity_minor, :) = l
         distance = distance_part*sqrt(l/force)
         if (path%path /= path_closed_form .and. path%path /= path_string) return
         bends(quantity_position, :) = [across + 2*w*speed + w**2*radius, across + 2*w*speed + w**2*radius, &
            force + gravity]
         bends(quantity_velocity, :) = [force*speed/l + 3*gravity*climb*radius/l**2, &
            force*speed/l + 3*gravity*climb*radius/l**2, (force + 3*gravity)*climb/l]
         bends(quantity_velocity, :2) = bends(quantity_velocity, :2) + w*(3*across + w*(3*speed + w*radius))
         distance = min(distance, distance_part/max(w, tiny(w)))
      end associate
   end subroutine find_sizes

   !> Whether a quantity is a constant of one orbit.
   pure logical function conserves(orbit, quantity, rate)
      type(orbit_type), intent(in) :: orbit
      integer, intent(in) :: quantity
      real(wp), intent(in) :: rate

      conserves = any(quantity == [quantity_energy, quantity_momentum, quantity_drag_work, quantity_pivot_work, &
         quantity_major, quantity_minor, quantity_handedness])
      if (quantity == quantity_plane .and. orbit%motion == motion_plane_libration) conserves = .not. abs(rate) > 0
   end function conserves

   !> Whether a quantity passes a value at times in closed form.
   pure logical function has_formula(request, rate)
      type(event_request_type), intent(in) :: request
      real(wp), intent(in) :: rate

      select case (request%quantity)
      case (quantity_position)
         has_formula = request%component == 3
      case (quantity_velocity)
         has_formula = request%component == 3 .and. .not. abs(request%value) > 0
      case (quantity_tension, quantity_inclination)
         has_formula = .true.
      case (quantity_speed, quantity_azimuth)
         has_formula = .not. abs(rate) > 0
      case default
         has_formula = .false.
      end select
   end function has_formula

   !> The times of a request with a formula.
   subroutine add_sequences(search, path, i, shift, noise)
      type(event_search_type), intent(inout) :: search
      type(path_type), intent(in) :: path
      integer, intent(in) :: i                                !! Number of the request
      real(wp), intent(in) :: shift                           !! By how much heights are shown higher [m]
      real(wp), intent(in) :: noise
      real(wp) :: time, bottom, rise, low, wanted
      integer :: up, falling
      type(pair_type) :: phase

      associate (orbit => path%orbit, request => search%requests(i))
         if (orbit%motion == motion_separatrix) then   ! It has no period.
            bottom = -value(orbit%start_phase)
         else
            bottom = value(pair(orbit%period()/2) - orbit%start_phase)
         end if
         up = 1
         select case (request%quantity)
         case (quantity_velocity)
            if (orbit%motion == motion_separatrix) then
               call add_sequence(search, orbit, i, 1, pair(0.0_wp))
            else if (any(orbit%motion == [motion_generic, motion_plane_libration, motion_plane_rotation])) then
               call add_sequence(search, orbit, i, -1, pair(0.0_wp))
               call add_sequence(search, orbit, i, 1, orbit%period_pair*0.5_wp)
            end if
            return
         case (quantity_azimuth)
            time = orbit%time_to_azimuth(request%value)
            if (.not. is_nan(time)) call add_sequence(search, orbit, i, merge(-1, 1, orbit%is_mirrored), &
               pair(time) + orbit%start_phase, .false.)
            return
         case (quantity_position)
            wanted = request%value - shift
            if (.not. (wanted > orbit%turning%lower + noise .and. wanted < orbit%turning%upper - noise)) return
            time = orbit%time_to_height(wanted)
         case default
            select case (request%quantity)
            case (quantity_speed)
               up = -1
               low = orbit%speed(bottom)
               rise = orbit%turning%lower_rise + (low - request%value)*(low + request%value)/(2*orbit%gravity)
               if (request%value < 0) return
            case (quantity_tension)
               up = -1
               rise = orbit%turning%lower_rise + (orbit%rod_force(bottom) - request%value/path%inertia)*orbit%length &
                  /(3*orbit%gravity)
            case default
               if (.not. (request%value > 0 .and. request%value < acos(-1.0_wp))) return
               rise = 2*orbit%length*sin(request%value/2)**2
            end select
            associate (least => noise_part*orbit%turning%upper_rise)
               if (.not. (rise > orbit%turning%lower_rise + least .and. rise < orbit%turning%upper_rise - least)) return
            end associate
            time = orbit%time_to_rise(rise)
         end select
         if (is_nan(time) .or. .not. any(orbit%motion == [motion_generic, motion_plane_libration, &
            motion_plane_rotation, motion_separatrix])) return
         phase = pair(time) + orbit%start_phase
         falling = -1
         if (orbit%motion == motion_separatrix) then
            if (value(phase) > 0) falling = 1
         else if (modulo(value(phase), orbit%period()) > orbit%period()/2) then
            falling = 1
         end if
         call add_sequence(search, orbit, i, up*falling, phase)
         call add_sequence(search, orbit, i, -up*falling, pair(0.0_wp) - phase)
      end associate
   end subroutine add_sequences

   !> One sequence, if its direction is asked for, from its first time after the start on.
   subroutine add_sequence(search, orbit, i, direction, phase, is_periodic)
      type(event_search_type), intent(inout) :: search
      type(orbit_type), intent(in) :: orbit
      integer, intent(in) :: i, direction
      type(pair_type), intent(in) :: phase
      logical, intent(in), optional :: is_periodic
      type(sequence_type) :: sequence
      real(wp) :: period, start

      if (search%requests(i)%direction == -direction) return
      sequence%request = i
      sequence%direction = direction
      sequence%phase = phase
      period = orbit%period()
      sequence%is_periodic = period < huge(period)
      if (present(is_periodic)) sequence%is_periodic = sequence%is_periodic .and. is_periodic
      ! At the start, rounding decides nothing.
      start = noise_part*sqrt(orbit%length/orbit%gravity)
      if (sequence%is_periodic) then
         start = max(start, noise_part*period)
         sequence%turns = anint(value(orbit%start_phase - phase)/period) - 1
      end if
      sequence%next = time_of(sequence, orbit)
      do while (.not. sequence%next > start)
         if (.not. sequence%is_periodic) return
         sequence%turns = sequence%turns + 1
         sequence%next = time_of(sequence, orbit)
      end do
      search%sequences = [search%sequences, sequence]
   end subroutine add_sequence

   pure real(wp) function time_of(sequence, orbit) result(time)
      type(sequence_type), intent(in) :: sequence
      type(orbit_type), intent(in) :: orbit

      if (sequence%is_periodic) then
         time = value(sequence%phase + orbit%period_pair*sequence%turns - orbit%start_phase)
      else
         time = value(sequence%phase - orbit%start_phase)
      end if
   end function time_of

   !> Before the next block of samples.
   subroutine forget_found(search)
      type(event_search_type), intent(inout) :: search

      search%count = 0
   end subroutine forget_found

   !> What happens on one orbit after one time and not after another.
   subroutine search_orbit(search, orbit, probe, from, to)
      type(event_search_type), intent(inout) :: search
      type(orbit_type), intent(in) :: orbit
      class(probe_type), intent(inout) :: probe
      real(wp), intent(in) :: from, to                        !! [s]
      real(wp) :: low, high, next
      integer :: first, i

      low = from
      do while (low < to .and. .not. search%is_over)
         high = to
         first = search%count + 1
         if (any(search%watches%column > 0) .or. size(search%extremes) > 0 .and. low < search%extremes_until) then
            high = min(to, low + most_points*search%point_distance)
            call look_between(search, probe, low, high, sort=.false.)
         end if
         do
            i = 0
            next = huge(next)
            if (size(search%sequences) > 0) i = minloc(search%sequences%next, 1)
            if (i > 0) next = search%sequences(i)%next
            if (next > high) exit
            call add_found(search, crossing_type(next, search%sequences(i)%request, search%sequences(i)%direction))
            associate (sequence => search%sequences(i))
               sequence%turns = sequence%turns + 1
               sequence%next = huge(next)
               if (sequence%is_periodic) sequence%next = time_of(sequence, orbit)
            end associate
         end do
         call put_in_order(search, probe, first)
         low = high
      end do
   end subroutine search_orbit

   !> What happens on a string: its swings and flights one after the other.
   subroutine search_string(search, path, probe, from, to)
      type(event_search_type), intent(inout) :: search
      type(path_type), intent(in) :: path
      class(probe_type), intent(inout) :: probe
      real(wp), intent(in) :: from, to                        !! [s]
      real(wp) :: low, high

      low = from
      associate (pieces => path%string%pieces)
         do while (low < to .and. .not. search%is_over)
            high = min(to, low + most_points*search%point_distance)
            if (search%piece < size(pieces)) high = min(high, nearest(pieces(search%piece + 1)%start, -1.0_wp))
            if (high > low) call look_between(search, probe, low, high, sort=.true.)
            low = max(low, high)
            if (search%piece < size(pieces)) then
               if (low < nearest(pieces(search%piece + 1)%start, -1.0_wp)) cycle
               search%piece = search%piece + 1
               low = pieces(search%piece)%start
               call probe%settle(low)
            end if
         end do
      end associate
   end subroutine search_string

   !> Points of a stretch of a path in closed form, and what happens there.
   subroutine look_between(search, probe, from, to, sort)
      type(event_search_type), intent(inout) :: search
      class(probe_type), intent(inout) :: probe
      real(wp), intent(in) :: from, to
      logical, intent(in) :: sort
      real(wp), allocatable :: times(:)
      integer :: n, i

      n = min(most_points, max(4, ceiling((to - from)/search%point_distance)))
      allocate (times(0:n))
      do i = 0, n
         times(i) = from + (to - from)*(real(i, wp)/n)
      end do
      times(n) = to
      call search_stretch(search, probe, times, sort)
   end subroutine look_between

   !> What happens in a stretch, told by points of it.
   subroutine search_stretch(search, probe, times, sort)
      type(event_search_type), intent(inout) :: search
      class(probe_type), intent(inout) :: probe
      real(wp), intent(in) :: times(:)                        !! The first where the stretch before ended [s]
      logical, intent(in) :: sort                             !! .false.: others will be added
      real(wp), allocatable :: values(:, :), until_end(:)
      type(crossing_type), allocatable :: crossings(:)
      integer :: first, i

      allocate (values(size(times), probe%columns))
      call probe%at(times, values, .false.)
      call find_crossings(probe, times, values, search%watches, crossings)
      first = search%count + 1
      do i = 1, size(crossings)
         if (search%requests(crossings(i)%watch)%direction == -crossings(i)%direction) cycle
         call add_found(search, crossings(i))
      end do
      if (sort) call put_in_order(search, probe, first)
      if (size(search%extremes) == 0) return
      if (search%is_over) then
         until_end = [pack(times, times < search%found(search%count)%time), search%found(search%count)%time]
         deallocate (values)
         allocate (values(size(until_end), probe%columns))
         call probe%at(until_end, values, .false.)
         call find_extremes(probe, until_end, values, search%extremes)
      else
         call find_extremes(probe, times, values, search%extremes)
      end if
   end subroutine search_stretch

   subroutine add_found(search, crossing)
      type(event_search_type), intent(inout) :: search
      type(crossing_type), intent(in) :: crossing
      type(scene_event_type), allocatable :: larger(:)

      if (search%count == size(search%found)) then
         allocate (larger(2*size(search%found)))
         larger(:search%count) = search%found
         call move_alloc(larger, search%found)
      end if
      search%count = search%count + 1
      associate (event => search%found(search%count), request => search%requests(crossing%watch))
         event = scene_event_type(time=crossing%time, request=crossing%watch)
         event%what = request%names(merge(1, 2, crossing%direction > 0))
      end associate
   end subroutine add_found

   !> Events from one on in the order of time, with the quantities there; none behind one that ends the simulation.
   subroutine put_in_order(search, probe, first)
      type(event_search_type), intent(inout) :: search
      class(probe_type), intent(inout) :: probe
      integer, intent(in) :: first
      type(scene_event_type) :: event
      real(wp) :: values(1, probe%columns)
      integer :: i, j

      ! By insertion: they come in runs that are ordered, or few.
      do i = first + 1, search%count
         event = search%found(i)
         j = i - 1
         do while (j >= first)
            if (.not. search%found(j)%time > event%time) exit
            search%found(j + 1) = search%found(j)
            j = j - 1
         end do
         search%found(j + 1) = event
      end do
      do i = first, search%count
         associate (found => search%found(i))
            call probe%at([found%time], values, .true.)
            found%values = values(1, :search%visible)
            found%position = values(1, search%position:search%position + 2)
            if (.not. search%requests(found%request)%stops) cycle
         end associate
         search%is_over = .true.
         search%count = i
         exit
      end do
   end subroutine put_in_order

end module kyvadlo_scene_events
