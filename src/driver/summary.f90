!> What a person wants to know of a simulation, in some ten lines of text or as JSON: period, precession and its parts,
!> decay, extremes, slack phases, energy account. It looks at every sample and at the highest points of all swings,
!> which are events.
module kyvadlo_summary
   use kyvadlo_buoyancy, only: effective_gravity
   use kyvadlo_crossings, only: extreme_type
   use kyvadlo_effects, only: effects_type, has_drag
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_motion_kinds
   use kyvadlo_number_text, only: digits_text, shortest_text
   use kyvadlo_numbers, only: is_finite, quiet_nan_real64
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_pairs_real64, only: value
   use kyvadlo_pivot, only: pivot_motion
   use kyvadlo_quantities
   use kyvadlo_sample_block, only: columns_of, in_laboratory
   use kyvadlo_samples, only: column_type, sample_sink_type, scene_event_type
   use kyvadlo_scene_groups, only: air_group, elastic_group, group_names, hoist_group, moving_pivot_group, &
      string_group, wind_group
   use kyvadlo_scene_settings, only: event_request_type
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_simulation_path, only: path_closed_form, path_type
   use kyvadlo_state_real64, only: new_orbit_from_state
   use kyvadlo_status, only: error_type
   use kyvadlo_text, only: integer_text, text_sink_type
   use kyvadlo_turning_frame, only: seen_from_turning_frame
   implicit none
   private
   public :: summary_type, new_summary, write_summary

   integer, parameter :: area = 1, earth = 2, support = 3, frame = 4
   character(len=*), parameter :: part_names(4) = [character(len=19) :: 'area of the ellipse', 'Earth', &
      'support', 'turning frame']
   character(len=*), parameter :: part_keys(4) = [character(len=13) :: 'area', 'earth', 'support', 'turning_frame']
   character(len=*), parameter :: extreme_columns(3) = [character(len=7) :: 'z', 'speed', 'tension']
   character(len=*), parameter :: extreme_names(3) = [character(len=7) :: 'height', 'speed', 'tension']
   character(len=*), parameter :: extreme_units(3) = [character(len=4) :: 'm', 'm/s', 'm/s2']

   type, extends(sample_sink_type) :: summary_type
      type(extreme_type), allocatable :: extremes(:)   !! For `simulate`: the largest and least of three columns
      integer, private :: top = 0                      !! Number of the event of a highest point
      integer, private :: columns(10) = 0  !! x vx major minor plane handedness energy drag_work pivot_work azimuth
      integer, private :: swings = 0, tops = 0, samples = 0, flights = 0
      real(wp), private :: swing_times(2) = 0          !! Of the first and the last highest point, in flight too
      real(wp), private :: times(2) = 0, planes(2) = 0, radii(2) = 0 !! ... of a swing
      real(wp), private :: area_sum = 0, support_turn = 0
      !> Of the highest point before: radii, sense, plane in the resting frame.
      real(wp), private :: ellipse(4) = 0
      real(wp), private :: first(3) = 0, last(3) = 0   !! Columns 7 to 9 of the first and the last sample
      real(wp), private :: ends(2) = 0, azimuths(2) = 0 !! Times and azimuths of these
      real(wp), private :: slack_since = -1, slack_time = 0, lost = 0
      real(wp), private :: gravity = 0, frame_rate = 0, frequencies(2) = 0
      logical, private :: moves = .false.              !! With the pivot, what is shown
      type(effects_type), private :: effects
   contains
      procedure :: begin => begin_summary
      procedure :: take => take_summary
      procedure :: note => note_summary
   end type summary_type

   real(wp), parameter :: pi = acos(-1.0_wp)

contains

   !> A summary, and what a simulation must give it: its own quantities and events behind those asked for.
   subroutine new_summary(summary, simulation, path, wanted)
      type(summary_type), intent(out) :: summary
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(simulation_type), intent(inout) :: wanted
      integer, parameter :: needed(*) = [quantity_position, quantity_velocity, quantity_speed, quantity_tension, &
         quantity_energy, quantity_drag_work, quantity_pivot_work, quantity_major, quantity_minor, quantity_plane, &
         quantity_handedness, quantity_azimuth]
      type(column_type), allocatable :: columns(:)
      integer :: i, place

      ! One orbit is told by its constants, not by its highest points.
      do i = 1, merge(7, size(needed), path%path == path_closed_form)
         if (all(wanted%settings%quantities /= needed(i))) &
            wanted%settings%quantities = [wanted%settings%quantities, needed(i)]
      end do
      if (path%path /= path_closed_form) then
         wanted%settings%events = [simulation%settings%events, event_request_type(quantity=quantity_velocity, &
            component=3, direction=-1, names=[character(len=64) :: '', 'highest point'])]
         summary%top = size(wanted%settings%events)
      end if
      allocate (columns, source=columns_of(wanted))
      allocate (summary%extremes(6))
      do i = 1, 3
         place = findloc(columns%name == extreme_columns(i), .true., 1)
         summary%extremes(2*i - 1:2*i) = [extreme_type(column=place, sense=-1), extreme_type(column=place, sense=1)]
      end do
      summary%gravity = effective_gravity(path%gravity, path%effects%density_ratio, path%effects%added_mass)
      summary%frame_rate = simulation%settings%frame_rate
      summary%frequencies = sqrt(summary%gravity/(path%length + path%effects%extra_length))
      summary%moves = in_laboratory(simulation)
      summary%effects = path%effects
   end subroutine new_summary

   subroutine begin_summary(sink, columns)
      class(summary_type), intent(inout) :: sink
      type(column_type), intent(in) :: columns(:)
      character(len=*), parameter :: names(10) = [character(len=10) :: 'x', 'vx', 'major', 'minor', 'plane', &
         'handedness', 'energy', 'drag_work', 'pivot_work', 'azimuth']
      integer :: i

      sink%columns = [(findloc(columns%name == names(i), .true., 1), i=1, size(names))]
   end subroutine begin_summary

   subroutine take_summary(sink, values, goes_on)
      class(summary_type), intent(inout) :: sink
      real(wp), intent(in) :: values(:, :)
      logical, intent(out) :: goes_on
      integer :: n

      goes_on = .true.
      n = size(values, 1)
      if (n == 0) return
      if (sink%samples == 0) then
         sink%first = values(1, sink%columns(7:9))
         if (sink%columns(10) > 0) sink%azimuths(1) = values(1, sink%columns(10))
         sink%ends(1) = values(1, 1)
      end if
      sink%last = values(n, sink%columns(7:9))
      if (sink%columns(10) > 0) sink%azimuths(2) = values(n, sink%columns(10))
      sink%ends(2) = values(n, 1)
      sink%samples = sink%samples + n
   end subroutine take_summary

   subroutine note_summary(sink, event)
      class(summary_type), intent(inout) :: sink
      type(scene_event_type), intent(in) :: event

      if (event%request > 0 .and. event%request == sink%top) then
         call take_top(sink, event%time, event%values)
      else if (event%request == 0) then
         sink%lost = sink%lost + event%energy_lost
         if (sink%slack_since >= 0) sink%slack_time = sink%slack_time + event%time - sink%slack_since
         sink%slack_since = -1
         if (any(event%what == [character(len=7) :: 'slack', 'rebound'])) then
            sink%slack_since = event%time
            sink%flights = sink%flights + 1
         end if
      end if
   end subroutine note_summary

   !> A highest point: when, in which direction, how far out; and how the ellipse turns there.
   subroutine take_top(sink, time, values)
      class(summary_type), intent(inout) :: sink
      real(wp), intent(in) :: time, values(:)
      real(wp) :: position(3), velocity(3), displacement(3), pivot_velocity(3)
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error

      associate (major => values(sink%columns(3)), minor => values(sink%columns(4)), plane => values(sink%columns(5)), &
         hand => values(sink%columns(6)))
         if (is_finite(plane) .or. sink%slack_since >= 0) then
            sink%swings = sink%swings + 1
            if (sink%swings == 1) sink%swing_times = time
            sink%swing_times(2) = time
         end if
         if (.not. is_finite(plane)) return
         sink%tops = sink%tops + 1
         if (sink%tops > 1) sink%support_turn = sink%support_turn + turn_of_support(sink%ellipse, &
            sink%frequencies*(time - sink%times(2)), plane + sink%frame_rate*time)
         sink%ellipse = [major, minor, hand, plane + sink%frame_rate*time]
         if (sink%tops == 1) then
            sink%times = time
            sink%planes = plane
            sink%radii = major
         end if
         sink%times(2) = time
         sink%planes(2) = plane
         sink%radii(2) = major
         position = values(sink%columns(1):sink%columns(1) + 2)
         velocity = values(sink%columns(2):sink%columns(2) + 2)
         if (sink%moves) then
            call pivot_motion(sink%effects, time, displacement, pivot_velocity)
            call seen_from_turning_frame(sink%frame_rate, time, displacement, pivot_velocity)
            position = position - displacement
            velocity = velocity - pivot_velocity
         end if
         ! In the resting frame, whose axes are those of the turning one now.
         velocity(:2) = velocity(:2) + sink%frame_rate*[-position(2), position(1)]
         velocity = velocity - position*(dot_product(position, velocity)/dot_product(position, position))
         call new_orbit_from_state(orbit, norm2(position), sink%gravity, position, velocity, error)
         if (allocated(error)) return
         sink%area_sum = sink%area_sum + orbit%apsidal_rate()
      end associate
   end subroutine take_top

   !> By how much the swings along x and y, that come out of step, turn the plane of an ellipse (doc/effects.md) [rad]:
   !> exactly, as it turns fast where the ellipse passes a circle.
   pure real(wp) function turn_of_support(ellipse, phases, seen) result(turn)
      real(wp), intent(in) :: ellipse(4)  !! Radii, sense, plane [rad]
      real(wp), intent(in) :: phases(2)   !! By which the swings along x and y go on [rad]
      real(wp), intent(in) :: seen        !! The plane that is seen afterwards: it tells half turns [rad]
      real(wp) :: squares
      complex(wp) :: product

      ! The squares' difference, and the product of the amplitude along y and the conjugate of the one along x.
      squares = (ellipse(1)**2 - ellipse(2)**2)*cos(2*ellipse(4))
      product = cmplx((ellipse(1)**2 - ellipse(2)**2)*sin(2*ellipse(4))/2, -ellipse(3)*ellipse(1)*ellipse(2), wp)
      turn = -atan2(2*product%re, squares)/2
      product = product*exp(cmplx(0, phases(2) - phases(1), wp))
      turn = turn + atan2(2*product%re, squares)/2
      turn = turn - pi*anint((turn - (seen - ellipse(4)))/pi)
   end function turn_of_support

   !> Everything, after the last sample.
   subroutine write_summary(summary, simulation, path, as_json, sink)
      type(summary_type), intent(inout) :: summary
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      logical, intent(in) :: as_json
      class(text_sink_type), intent(inout) :: sink
      real(wp) :: period, precession, parts(4), decay, quality, found(3, 2), when(3, 2), account(5)
      integer :: i

      call find_rates(summary, path, period, precession, parts)
      decay = quiet_nan_real64
      if (summary%tops > 1 .and. has_drag(path%effects)) then
         if (summary%radii(2) < summary%radii(1)) decay = (summary%times(2) - summary%times(1)) &
            /log(summary%radii(1)/summary%radii(2))
      end if
      quality = pi*decay/period
      do i = 1, 3
         found(i, :) = summary%extremes(2*i - 1:2*i)%value*[-1, 1]
         when(i, :) = summary%extremes(2*i - 1:2*i)%time
      end do
      if (summary%slack_since >= 0) summary%slack_time = summary%slack_time + summary%ends(2) - summary%slack_since
      account = [summary%first(1), summary%last, summary%lost]
      if (as_json) then
         call write_json()
      else
         call write_text()
      end if

   contains

      subroutine write_text()
         character(len=:), allocatable :: line

         line = 'pendulum:   '//simulation%pendulum%name
         call sink%put(line)
         call sink%put('path:       '//path%method)
         call sink%put('time:       '//number(summary%ends(2))//' s, '//integer_text(summary%samples)//' samples')
         if (period == period) then
            call sink%put('period:     '//number(period)//trim(merge(' s, a revolution', ' s to and fro   ', &
               revolves()))//counted())
         else
            call sink%put('period:     none found: fewer than two highest points, no revolution')
         end if
         line = 'precession: none found'
         if (precession == precession) line = 'precession: '//in_degrees(precession)//' ('//number(precession)// &
            ' rad/s)'
         do i = 1, merge(4, 0, precession == precession)
            if (abs(parts(i)) > 0) line = line//'; '//trim(part_names(i))//' '//in_degrees(parts(i))
         end do
         if (precession == precession) then
            if (abs(precession - sum(parts)) > 0) line = line//'; rest '//in_degrees(precession - sum(parts))//' ('// &
               trim(untold(simulation))//')'
         end if
         call sink%put(line)
         if (decay == decay) then
            call sink%put('decay:      of the radius from '//number(summary%radii(1))//' to '// &
               number(summary%radii(2))//' m: 1/e in '//number(decay)//' s, Q = '//number(quality))
         else
            call sink%put('decay:      none'//trim(merge(' found', '      ', has_drag(path%effects))))
         end if
         do i = 1, 3
            line = trim(extreme_names(i))//':'
            line = line//repeat(' ', 12 - len(line))
            call sink%put(line//number(found(i, 1))//' to '//number(found(i, 2))//' '//trim(extreme_units(i))// &
               ', at '//number(when(i, 1))//' and '//number(when(i, 2))//' s')
         end do
         if (summary%flights > 0) call sink%put('slack:      '//integer_text(summary%flights)//' times, '// &
            number(summary%slack_time)//' s in all')
         line = 'energy:     '//number(account(1))//' to '//number(account(2))//' m2/s2'
         if (abs(account(3)) > 0) line = line//'; air '//number(account(3))
         if (abs(account(4)) > 0) line = line//'; pivot '//number(account(4))
         if (account(5) > 0) line = line//'; string '//number(-account(5))
         call sink%put(line//'; left over '//trim(digits_text(unexplained(), 2))//', '// &
            trim(digits_text(unexplained()/(path%gravity*path%length), 2))//' of g l')
      end subroutine write_text

      subroutine write_json()
         call sink%put('{"pendulum": "'//escaped(simulation%pendulum%name)//'",')
         call sink%put(' "path": "'//escaped(path%method)//'",')
         call sink%put(' "duration_s": '//json(summary%ends(2))//', "samples": '//integer_text(summary%samples)//',')
         call sink%put(' "period_to_and_fro_s": '//json(period)//', "highest_points": '//tops_text()//',')
         call sink%put(' "precession_rad_per_s": '//json(precession)//',')
         call sink%put(' "precession_parts_rad_per_s": {')
         do i = 1, 4
            call sink%put('   "'//trim(part_keys(i))//'": '//json(parts(i))//',')
         end do
         call sink%put('   "rest": '//json(precession - sum(parts))//'},')
         call sink%put(' "decay_time_s": '//json(decay)//', "quality": '//json(quality)//',')
         do i = 1, 3
            call sink%put(' "'//trim(extreme_names(i))//'": {"least": '//json(found(i, 1))//', "at_s": '// &
               json(when(i, 1))//', "most": '//json(found(i, 2))//', "most_at_s": '//json(when(i, 2))//'},')
         end do
         call sink%put(' "slack_phases": '//integer_text(summary%flights)//', "slack_s": '// &
            json(summary%slack_time)//',')
         call sink%put(' "energy_m2_per_s2": {"first": '//json(account(1))//', "last": '//json(account(2))// &
            ', "air": '//json(account(3))//', "pivot": '//json(account(4))//', "lost_by_string": '//json(account(5))// &
            ', "left_over": '//json(unexplained())//', "g_l": '//json(path%gravity*path%length)//'}}')
      end subroutine write_json

      !> How many highest points there were; of one orbit by its period, null where that has not the digits.
      function tops_text()
         character(len=:), allocatable :: tops_text
         real(wp) :: turns

         turns = 0
         if (path%path == path_closed_form .and. any(path%orbit%motion == [motion_generic, motion_plane_libration, &
            motion_plane_rotation])) turns = (summary%ends(2) + value(path%orbit%start_phase))/path%orbit%period()
         tops_text = integer_text(summary%swings)
         if (turns >= huge(0)) tops_text = 'null'
         if (turns > 0 .and. turns < huge(0)) tops_text = integer_text(floor(turns))
      end function tops_text

      logical function revolves()
         revolves = path%path /= path_closed_form .and. summary%swings < 2
         if (path%path == path_closed_form) revolves = any(path%orbit%motion == [motion_conical, motion_plane_rotation])
      end function revolves

      !> What the works do not account for.
      real(wp) function unexplained()
         unexplained = account(2) - account(1) - account(3) - account(4) + account(5)
      end function unexplained

      function counted()
         character(len=:), allocatable :: counted

         counted = ''
         if (path%path == path_closed_form) return
         counted = ', mean of '//integer_text(summary%swings - 1)//' half swings'
         if (summary%swings < 2) counted = ', mean of '// &
            trim(digits_text((summary%ends(2) - summary%ends(1))/period, 4))//' revolutions'
      end function counted
   end subroutine write_summary

   !> Period to and fro, precession and its parts: of one orbit by its constants, else from the highest points.
   subroutine find_rates(summary, path, period, precession, parts)
      type(summary_type), intent(in) :: summary
      type(path_type), intent(in) :: path
      real(wp), intent(out) :: period, precession   !! [s], [rad/s]; NaN: none
      real(wp), intent(out) :: parts(:)             !! [rad/s]
      real(wp) :: turned

      period = quiet_nan_real64
      precession = quiet_nan_real64
      parts = 0
      if (path%path == path_closed_form) then
         select case (path%orbit%motion)
         case (motion_generic, motion_plane_libration)
            period = 2*path%orbit%period()
            parts(area) = path%orbit%apsidal_rate()
            parts(frame) = 0 - summary%frame_rate
            precession = parts(area) + parts(frame)
         case (motion_conical)
            period = 2*pi*sqrt(-path%orbit%turning%upper/path%orbit%gravity)
         case (motion_plane_rotation)
            period = path%orbit%period()
         end select
         return
      end if
      if (summary%swings > 1) then
         period = 2*(summary%swing_times(2) - summary%swing_times(1))/(summary%swings - 1)
      else if (all(is_finite(summary%azimuths))) then
         ! A cone that air lets sink has no highest point, but goes round.
         turned = abs(summary%azimuths(2) - summary%azimuths(1))/(2*pi)
         if (turned >= 1) period = (summary%ends(2) - summary%ends(1))/turned
      end if
      if (summary%tops > 1) then
         precession = (summary%planes(2) - summary%planes(1))/(summary%times(2) - summary%times(1))
         parts(area) = summary%area_sum/summary%tops
         parts(earth) = 0 - path%effects%turn_rate(3)
         parts(support) = summary%support_turn/(summary%times(2) - summary%times(1))
         parts(frame) = 0 - summary%frame_rate
      end if
   end subroutine find_rates

   !> What may turn the plane and has no part of its own.
   pure function untold(simulation) result(text)
      type(simulation_type), intent(in) :: simulation
      character(len=100) :: text
      integer, parameter :: groups(*) = [string_group, air_group, wind_group, moving_pivot_group, elastic_group, &
         hoist_group]
      integer :: i

      text = ''
      do i = 1, size(groups)
         if (simulation%settings%given(groups(i))) text = trim(text)//' &'//trim(group_names(groups(i)))//','
      end do
      text = adjustl(trim(text)//' higher orders')
   end function untold

   function number(value)
      real(wp), intent(in) :: value
      character(len=:), allocatable :: number

      number = trim(digits_text(value, 6))
   end function number

   function in_degrees(rate) result(text)
      real(wp), intent(in) :: rate                  !! [rad/s]
      character(len=:), allocatable :: text

      text = trim(digits_text(rate*(180/pi)*3600, 6))//' degrees/hour'
   end function in_degrees

   !> In the shortest form that reads back exactly; null: there is none.
   function json(value)
      real(wp), intent(in) :: value
      character(len=:), allocatable :: json

      json = 'null'
      if (is_finite(value)) json = shortest_text(value)
   end function json

   !> Names are UTF-8 without control characters.
   function escaped(text)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: escaped
      integer :: i

      escaped = ''
      do i = 1, len_trim(text)
         if (scan(text(i:i), '"\') > 0) escaped = escaped//'\'
         escaped = escaped//text(i:i)
      end do
   end function escaped

end module kyvadlo_summary
