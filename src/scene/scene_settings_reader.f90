!> How the groups of a scene beside &pendulum become its settings. Every name and value is checked.
module kyvadlo_scene_settings_reader
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_curves, only: move_curve
   use kyvadlo_decimal_grid, only: read_whole
   use kyvadlo_effects, only: air_coefficients, earth_turn_rate, effects_type, put_coefficient, sphere_coefficients
   use kyvadlo_group_values, only: read_group, set_defaults
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: group_type, place_of
   use kyvadlo_quantities, only: default_quantities, has_derivatives, quantities, quantity_derivatives, &
      quantity_position, quantity_velocity
   use kyvadlo_scene_groups
   use kyvadlo_scene_settings, only: event_request_type, is_extended, settings_type, value_of_name_type
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: integer_text, lower_case, shown, split_words
   implicit none
   private
   public :: settings_from_groups, set_effects

   !> Two names of a group that exclude each other.
   type :: contradiction_type
      integer :: group = 0
      character(len=14) :: one = '', other = ''
   end type contradiction_type

   type(contradiction_type), parameter :: contradictions(*) = [ &
      contradiction_type(air_group, 'linear', 'drag'), contradiction_type(air_group, 'quadratic', 'drag'), &
      contradiction_type(air_group, 'linear', 'diameter'), contradiction_type(air_group, 'quadratic', 'diameter'), &
      contradiction_type(air_group, 'linear', 'mass'), contradiction_type(air_group, 'quadratic', 'mass'), &
      contradiction_type(air_group, 'linear', 'density'), contradiction_type(air_group, 'quadratic', 'density'), &
      contradiction_type(air_group, 'linear', 'viscosity'), contradiction_type(air_group, 'quadratic', 'viscosity'), &
      contradiction_type(moving_pivot_group, 'table', 'amplitude'), &
      contradiction_type(moving_pivot_group, 'table', 'move_to'), &
      contradiction_type(moving_pivot_group, 'table', 'circle_radius'), &
      contradiction_type(moving_pivot_group, 'move_to', 'amplitude'), &
      contradiction_type(moving_pivot_group, 'move_to', 'circle_radius'), &
      contradiction_type(moving_pivot_group, 'amplitude', 'circle_radius'), &
      contradiction_type(moving_pivot_group, 'table', 'frequency'), contradiction_type(moving_pivot_group, 'table', &
      'phase'), contradiction_type(output_group, 'samples', 'rate'), contradiction_type(hoist_group, 'table', 'rate'), &
      contradiction_type(body_group, 'inertia', 'bob_diameter'), &
      contradiction_type(body_group, 'inertia', 'wire_mass'), &
      contradiction_type(body_group, 'distance', 'bob_diameter'), &
      contradiction_type(body_group, 'distance', 'wire_mass')]

   real(wp), parameter :: degree = acos(-1.0_wp)/180

contains

   !> The settings of all groups but &pendulum.
   !>
   !> Errors (`code_input`), with file and line: an unknown group or name, a group given twice, a missing name, a value
   !> that breaks its rule, groups that contradict each other.
   pure subroutine settings_from_groups(groups, file, chosen, error)
      type(group_type), intent(in) :: groups(:)
      character(len=*), intent(in) :: file
      type(settings_type), intent(out) :: chosen
      type(error_type), allocatable, intent(out) :: error
      type(value_of_name_type) :: values(size(settings))
      integer :: i, place

      chosen%file = file
      allocate (chosen%events(0))
      call set_defaults(values)
      do i = 1, size(groups)
         place = findloc(group_names == groups(i)%name, .true., 1)
         if (place == pendulum_group) cycle
         if (place == 0) then
            call fail(error, code_input, place_of(file, groups(i)%line)//'unknown group &'//shown(groups(i)%name) &
               //'; known are '//known_groups())
         else if (place == event_group) then
            call take_event(groups(i), chosen, error)
         else if (chosen%given(place)) then
            call fail(error, code_input, place_of(file, groups(i)%line)//'&'//groups(i)%name &
               //' given twice, first on line '//integer_text(chosen%line(place)))
         else
            chosen%given(place) = .true.
            chosen%line(place) = groups(i)%line
            if (place == fit_group) then
               call read_group(without_bounds(groups(i)), place, values, error)
            else
               call read_group(groups(i), place, values, error)
            end if
         end if
         if (allocated(error)) return
      end do
      call take_values(values, chosen, error)
      if (.not. allocated(error)) call check_together(values, chosen, error)
   end subroutine settings_from_groups

   !> One &event; a scene may have any number of them. Errors: those of `read_group`; a column that is none.
   pure subroutine take_event(group, chosen, error)
      type(group_type), intent(in) :: group
      type(settings_type), intent(inout) :: chosen
      type(error_type), allocatable, intent(out) :: error
      type(value_of_name_type) :: values(size(settings))
      type(event_request_type) :: event
      character(len=:), allocatable :: word
      integer :: i

      call set_defaults(values)
      call read_group(group, event_group, values, error)
      if (allocated(error)) return
      if (.not. chosen%given(event_group)) chosen%line(event_group) = group%line
      chosen%given(event_group) = .true.
      associate (asked => values(setting_place(event_group, 'quantity')), &
         value => values(setting_place(event_group, 'value')))
         word = trim(lower_case(asked%text(1)%text))
         do i = 1, size(quantities)
            event%component = findloc(quantities(i)%column_names(:quantities(i)%columns) == word, .true., 1)
            if (event%component > 0) event%quantity = i
            if (event%component > 0) exit
         end do
         if (event%quantity == 0) then
            call fail(error, code_input, place_of(chosen%file, asked%line(1))// &
               '&event: quantity must be a column, got '//shown(word)//'; known are '//known_columns())
            return
         end if
         event%value = value%number(1)
         if (value%line(1) > 0) then
            if (len(value%text(1)%text) <= len(event%typed)) event%typed = value%text(1)%text
         end if
         event%names = [character(len=len(event%names)) :: word//' rises through ', word//' falls through ']
         do i = 1, 2
            if (value%line(1) > 0) then
               event%names(i) = trim(event%names(i))//' '//value%text(1)%text
            else
               event%names(i) = trim(event%names(i))//' 0'
            end if
         end do
      end associate
      event%direction = nint(values(setting_place(event_group, 'direction'))%number(1))
      event%stops = values(setting_place(event_group, 'stop'))%number(1) > 0
      event%line = group%line
      chosen%events = [chosen%events, event]
   end subroutine take_event

   !> &fit without the names that begin with another setting's bound or prior: kyvadlo_fit_request reads them.
   pure function without_bounds(group) result(rest)
      type(group_type), intent(in) :: group
      type(group_type) :: rest
      integer :: i

      rest = group
      rest%entries = group%entries(pack([(i, i=1, size(group%entries))], [(index(group%entries(i)%name, 'least_') /= 1 &
         .and. index(group%entries(i)%name, 'most_') /= 1 .and. index(group%entries(i)%name, 'prior_') /= 1, &
         i=1, size(group%entries))]))
   end function without_bounds

   !> Puts the values where they belong.
   pure subroutine take_values(values, chosen, error)
      type(value_of_name_type), intent(in) :: values(size(settings))
      type(settings_type), intent(inout) :: chosen
      type(error_type), allocatable, intent(out) :: error
      integer(int64) :: whole
      integer :: i, places

      do i = 1, size(settings)
         chosen%number(:, i) = values(i)%number
      end do
      chosen%duration = chosen%number(1, setting_place(output_group, 'duration'))
      i = setting_place(output_group, 'duration')
      chosen%duration_typed = ''
      if (values(i)%line(1) > 0) chosen%duration_typed = values(i)%text(1)%text
      chosen%samples = nint(chosen%number(1, setting_place(output_group, 'samples')), int64)
      i = setting_place(output_group, 'rate')
      chosen%sample_rate = ''
      if (values(i)%line(1) > 0) then
         chosen%sample_rate = values(i)%text(1)%text
         chosen%samples = 0
         call read_whole(chosen%sample_rate, whole, places)
         if (whole == 0) call fail(error, code_input, place_of(chosen%file, values(i)%line(1))// &
            '&output: rate must lie between 1e-15 and 1e15 and have at most 15 figures, got '// &
            shown(chosen%sample_rate))
         if (allocated(error)) return
      end if
      chosen%relative = chosen%number(1, setting_place(moving_pivot_group, 'relative')) > 0
      i = setting_place(air_group, 'drag')
      if (values(i)%line(1) > 0) then
         chosen%is_sphere = lower_case(values(i)%text(1)%text) == 'sphere'
         if (.not. chosen%is_sphere) call fail(error, code_input, place_of(chosen%file, values(i)%line(1))// &
            '&air: drag must be sphere, got '//shown(values(i)%text(1)%text))
         if (allocated(error)) return
      end if
      call set_effects(chosen)
      call take_table(values, moving_pivot_group, chosen, chosen%table, error)
      if (.not. allocated(error)) call take_kind_of_table(values, chosen, error)
      if (.not. allocated(error)) call take_table(values, hoist_group, chosen, chosen%hoist_table, error)
      if (allocated(error)) return
      associate (words => values(setting_place(output_group, 'quantities')))
         if (words%line(1) == 0) then
            call read_quantities(default_quantities, '', chosen%quantities, error)
         else
            call read_quantities(words%text(1)%text, place_of(chosen%file, words%line(1))//'&output: ', &
               chosen%quantities, error)
         end if
      end associate
      if (.not. allocated(error)) call take_derivatives(values(setting_place(output_group, 'derivatives')), chosen, &
         error)
   end subroutine take_values

   !> What the table of the pivot has, and how it goes on between its lines.
   pure subroutine take_kind_of_table(values, chosen, error)
      type(value_of_name_type), intent(in) :: values(size(settings))
      type(settings_type), intent(inout) :: chosen
      type(error_type), allocatable, intent(out) :: error
      character(len=12), parameter :: kinds(0:2) = [character(len=12) :: 'displacement', 'velocity', 'acceleration']

      associate (of => values(setting_place(moving_pivot_group, 'table_of')), &
         between => values(setting_place(moving_pivot_group, 'between')))
         if (of%line(1) > 0) then
            chosen%table_order = findloc(kinds, lower_case(of%text(1)%text), 1) - 1
            if (chosen%table_order < 0) call fail(error, code_input, place_of(chosen%file, of%line(1))// &
               '&moving_pivot: table_of must be displacement, velocity or acceleration, got '//shown(of%text(1)%text))
         end if
         if (between%line(1) == 0 .or. allocated(error)) return
         chosen%table_is_linear = lower_case(between%text(1)%text) == 'linear'
         if (.not. chosen%table_is_linear .and. lower_case(between%text(1)%text) /= 'spline') then
            call fail(error, code_input, place_of(chosen%file, between%line(1))// &
               '&moving_pivot: between must be spline or linear, got '//shown(between%text(1)%text))
         end if
      end associate
   end subroutine take_kind_of_table

   !> The file of a table; not allocated where none is given.
   pure subroutine take_table(values, group, chosen, table, error)
      type(value_of_name_type), intent(in) :: values(size(settings))
      integer, intent(in) :: group
      type(settings_type), intent(in) :: chosen
      character(len=:), allocatable, intent(out) :: table
      type(error_type), allocatable, intent(out) :: error

      associate (value => values(setting_place(group, 'table')))
         if (value%line(1) == 0) return
         table = trim(value%text(1)%text)
         if (table == '') call fail(error, code_input, place_of(chosen%file, value%line(1))//'&'// &
            trim(group_names(group))//': table needs the name of a file')
      end associate
   end subroutine take_table

   !> What of the quantities is differentiated; position and velocity if none of them is asked for. By what, is read
   !> once the start is known.
   pure subroutine take_derivatives(words, chosen, error)
      type(value_of_name_type), intent(in) :: words
      type(settings_type), intent(inout) :: chosen
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      allocate (chosen%derivatives(0))
      chosen%derivatives_typed = ''
      chosen%derivatives_line = words%line(1)
      if (words%line(1) > 0) chosen%derivatives_typed = words%text(1)%text
      associate (asked => chosen%quantities)
         chosen%differentiated = pack(asked, [(any(has_derivatives == asked(i)), i=1, size(asked))])
         if (size(chosen%differentiated) == 0) chosen%differentiated = [quantity_position, quantity_velocity]
         if (any(asked == quantity_derivatives)) return
      end associate
      chosen%differentiated = [integer ::]
      if (words%line(1) > 0) call fail(error, code_input, place_of(chosen%file, words%line(1))// &
         '&output: derivatives needs the word derivatives among quantities')
   end subroutine take_derivatives

   !> The effects that follow from the numbers of a scene, and the rate of the frame.
   pure subroutine set_effects(chosen)
      type(settings_type), intent(inout) :: chosen
      integer :: i, j
      logical :: is_put

      chosen%frame_rate = number(turning_frame_group, 'rate')
      associate (effects => chosen%effects)
         do i = 1, size(settings)
            do j = 1, settings(i)%values
               call put_coefficient(effects, trim(group_names(settings(i)%group))//'.'//trim(settings(i)%name), j, &
                  chosen%number(j, i), is_put)
            end do
         end do
         effects%is_string = chosen%given(string_group)
         effects%sphere_speed = 0
         if (.not. (number(air_group, 'mass') > 0 .and. number(air_group, 'diameter') > 0)) then
            continue   ! No bob, or one that is refused later.
         else if (chosen%is_sphere) then
            call sphere_coefficients(number(air_group, 'diameter'), number(air_group, 'mass'), &
               number(air_group, 'density'), number(air_group, 'viscosity'), effects%linear_drag, &
               effects%quadratic_drag, effects%sphere_speed)
         else
            call air_coefficients(number(air_group, 'diameter'), number(air_group, 'mass'), &
               number(air_group, 'density'), number(air_group, 'viscosity'), effects%linear_drag, &
               effects%quadratic_drag)
         end if
         if (chosen%given(earth_rotation_group)) effects%turn_rate = &
            earth_turn_rate(number(earth_rotation_group, 'latitude'), number(earth_rotation_group, 'rate'))
         if (number(moving_pivot_group, 'circle_radius') > 0) then
            effects%pivot_amplitude(:2) = number(moving_pivot_group, 'circle_radius')
            effects%pivot_frequency(:2) = abs(number(moving_pivot_group, 'circle_rate'))
            effects%pivot_phase(2) = -sign(90*degree, number(moving_pivot_group, 'circle_rate'))
         end if
         effects%pivot_curve = move_curve(vector(moving_pivot_group, 'move_to'), number(moving_pivot_group, 'speed'), &
            number(moving_pivot_group, 'acceleration'), number(moving_pivot_group, 'jerk'))
         if (chosen%given(elastic_group)) effects%stiffness = number(elastic_group, 'stiffness')/number(elastic_group, &
            'mass')
      end associate

   contains

      pure real(wp) function number(group, name)
         integer, intent(in) :: group
         character(len=*), intent(in) :: name

         number = chosen%number(1, setting_place(group, name))
      end function number

      pure function vector(group, name)
         integer, intent(in) :: group
         character(len=*), intent(in) :: name
         real(wp) :: vector(3)

         vector = chosen%number(:, setting_place(group, name))
      end function vector
   end subroutine set_effects

   !> Groups and names that need or exclude each other.
   pure subroutine check_together(values, chosen, error)
      type(value_of_name_type), intent(in) :: values(size(settings))
      type(settings_type), intent(in) :: chosen
      type(error_type), allocatable, intent(out) :: error
      type(contradiction_type) :: pair
      integer :: i, restitution

      call exclude(error, rod_group, string_group)
      call exclude(error, rod_group, elastic_group)
      call exclude(error, string_group, hoist_group)
      if (is_given(body_group, 'inertia') .or. is_given(body_group, 'distance')) then
         call need(error, body_group, ['inertia ', 'distance', 'mass    '], '; its length is inertia/(mass distance)')
      else if (.not. is_given(body_group, 'bob_diameter') .or. is_given(body_group, 'wire_mass')) then
         call need(error, body_group, ['mass'], '')
      end if
      if (is_extended(chosen)) then
         call exclude(error, body_group, string_group)
         call exclude(error, body_group, elastic_group)
         call exclude(error, body_group, hoist_group)
         call exclude(error, body_group, anisotropic_support_group)
      end if
      restitution = setting_place(string_group, 'restitution')
      if (chosen%given(elastic_group) .and. is_given(string_group, 'restitution')) call complain(error, &
         values(restitution)%line(1), '&string: restitution and &elastic exclude each other')
      if (chosen%given(wind_group) .and. .not. chosen%given(air_group)) &
         call complain(error, chosen%line(wind_group), '&wind needs &air')
      do i = 1, size(contradictions)
         pair = contradictions(i)
         if (is_given(pair%group, pair%one) .and. is_given(pair%group, pair%other)) &
            call complain(error, maxval(values(setting_place(pair%group, pair%other))%line), &
            '&'//trim(group_names(pair%group))//': '//trim(pair%one)//' and '//trim(pair%other)//' exclude each other')
      end do
      if (.not. (is_given(air_group, 'linear') .or. is_given(air_group, 'quadratic'))) call need(error, air_group, &
         ['diameter', 'mass    '], '; give linear or quadratic, or diameter and mass of a sphere')
      if (is_given(moving_pivot_group, 'move_to')) then
         call need(error, moving_pivot_group, ['speed       ', 'acceleration'], ' beside move_to')
      else if (is_given(moving_pivot_group, 'circle_radius')) then
         call need(error, moving_pivot_group, ['circle_rate'], ' beside circle_radius')
      else if (.not. allocated(chosen%table)) then
         call need(error, moving_pivot_group, ['amplitude', 'frequency'], &
            '; give amplitude and frequency, or table, move_to or circle_radius')
      end if
      if (.not. allocated(chosen%hoist_table)) call need(error, hoist_group, ['rate'], ', or table')
      if (.not. is_given(anisotropic_support_group, 'extra_length_y')) &
         call need(error, anisotropic_support_group, ['extra_length_x'], ', or extra_length_y')

   contains

      pure logical function is_given(group, name)
         integer, intent(in) :: group
         character(len=*), intent(in) :: name

         is_given = any(values(setting_place(group, name))%line > 0)
      end function is_given

      !> Keeps the first complaint.
      pure subroutine complain(error, line, message)
         type(error_type), allocatable, intent(inout) :: error
         integer, intent(in) :: line
         character(len=*), intent(in) :: message

         if (.not. allocated(error)) call fail(error, code_input, place_of(chosen%file, line)//message)
      end subroutine complain

      pure subroutine exclude(error, one, other)
         type(error_type), allocatable, intent(inout) :: error
         integer, intent(in) :: one, other

         if (chosen%given(one) .and. chosen%given(other)) call complain(error, &
            max(chosen%line(one), chosen%line(other)), '&'//trim(group_names(one))//' and &'// &
            trim(group_names(other))//' exclude each other')
      end subroutine exclude

      pure subroutine need(error, group, names, remedy)
         type(error_type), allocatable, intent(inout) :: error
         integer, intent(in) :: group
         character(len=*), intent(in) :: names(:), remedy
         integer :: j

         do j = 1, size(names)
            if (chosen%given(group) .and. .not. is_given(group, names(j))) call complain(error, chosen%line(group), &
               '&'//trim(group_names(group))//': '//trim(names(j))//' is missing'//remedy)
         end do
      end subroutine need
   end subroutine check_together

   !> The words of `quantities`, separated by blanks or commas.
   pure subroutine read_quantities(text, place, chosen, error)
      character(len=*), intent(in) :: text
      character(len=*), intent(in) :: place                  !! For messages
      integer, allocatable, intent(out) :: chosen(:)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: blank
      integer, allocatable :: first(:), last(:)
      integer :: i, count, found

      allocate (chosen(0))
      blank = text
      do i = 1, len(blank)
         if (blank(i:i) == ',') blank(i:i) = ' '
      end do
      call split_words(blank, first, last, count)
      if (count == 0) call fail(error, code_input, place//'quantities names none; known are '//known_quantities())
      do i = 1, count
         associate (word => blank(first(i):last(i)))
            found = findloc(quantities%name == lower_case(word), .true., 1)
            if (found == 0) then
               call fail(error, code_input, place//'unknown quantity '//shown(word)//'; known are '//known_quantities())
            else if (any(chosen == found)) then
               call fail(error, code_input, place//'quantity '//shown(word)//' given twice')
            end if
            if (allocated(error)) return
            chosen = [chosen, found]
         end associate
      end do
   end subroutine read_quantities

   !> Blanks behind.
   pure function known_groups() result(text)
      character(len=size(group_names)*(len(group_names) + 3)) :: text
      integer :: i

      text = '&'//group_names(1)
      do i = 2, size(group_names)
         text = trim(text)//', &'//group_names(i)
      end do
   end function known_groups

   !> Blanks behind.
   pure function known_columns() result(text)
      character(len=40*size(quantities)) :: text
      integer :: i, j

      text = ''
      do i = 1, size(quantities)
         do j = 1, quantities(i)%columns
            text = trim(text)//', '//quantities(i)%column_names(j)
         end do
      end do
      text = text(3:)
   end function known_columns

   !> Blanks behind.
   pure function known_quantities() result(text)
      character(len=16*size(quantities)) :: text
      integer :: i

      text = quantities(1)%name
      do i = 2, size(quantities)
         text = trim(text)//', '//quantities(i)%name
      end do
   end function known_quantities

end module kyvadlo_scene_settings_reader
