!> How the groups of a scene beside &pendulum become its settings. Every name and value is checked.
module kyvadlo_scene_settings_reader
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_group_numbers, only: take_numbers
   use kyvadlo_group_values, only: entry_place, take_text, take_truth
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: group_type, place_of
   use kyvadlo_number_text, only: shortest_text
   use kyvadlo_quantities, only: default_quantities, quantities
   use kyvadlo_scene_groups
   use kyvadlo_scene_settings, only: settings_type
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: integer_text, lower_case, shown, split_words
   implicit none
   private
   public :: settings_from_groups

   !> The values of all names, by place in `settings`.
   type :: values_type
      real(wp) :: numbers(3, size(settings)) = 0
      integer :: line(size(settings)) = 0          !! 0: not given
   end type values_type

contains

   !> The settings of all groups but &pendulum.
   !>
   !> Errors (`code_input`), with file and line: an unknown group or name, a group given twice, a missing name, a value that
   !> breaks its rule, groups that contradict each other.
   pure subroutine settings_from_groups(groups, file, chosen, error)
      type(group_type), intent(in) :: groups(:)
      character(len=*), intent(in) :: file
      type(settings_type), intent(out) :: chosen
      type(error_type), allocatable, intent(out) :: error
      type(values_type) :: values
      integer :: i, place

      chosen%file = file
      chosen%duration_typed = ''
      if (size(groups) > 0) chosen%file = groups(1)%file
      do i = 1, size(groups)
         if (groups(i)%name == 'pendulum') cycle
         place = group_place(groups(i)%name)
         if (place == 0) then
            call fail(error, code_input, place_of(chosen%file, groups(i)%line)//'unknown group &'//shown(groups(i)%name) &
               //'; known are '//known_groups())
         else if (chosen%given(place)) then
            call fail(error, code_input, place_of(chosen%file, groups(i)%line)//'&'//groups(i)%name &
               //' given twice, first on line '//integer_text(chosen%line(place)))
         else
            chosen%given(place) = .true.
            chosen%line(place) = groups(i)%line
            call read_group(groups(i), place, chosen, values, error)
         end if
         if (allocated(error)) return
      end do
      call take_values(values, chosen)
      if (.not. allocated(chosen%quantities)) then
         call read_quantities(default_quantities, file, chosen%quantities, error)
         if (allocated(error)) return
      end if
      call check_together(values, chosen, error)
   end subroutine settings_from_groups

   !> The values of one group, each checked by its rule.
   pure subroutine read_group(group, place, chosen, values, error)
      type(group_type), intent(in) :: group
      integer, intent(in) :: place                     !! In `group_names`
      type(settings_type), intent(inout) :: chosen
      type(values_type), intent(inout) :: values
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text
      integer :: i, found

      do i = 1, size(group%entries)
         if (setting_place(place, group%entries(i)%name) > 0) cycle
         call fail(error, code_input, place_of(group%file, group%entries(i)%line)//'&'//group%name//': unknown name ' &
            //shown(group%entries(i)%name)//known_names(place))
         return
      end do
      do i = 1, size(settings)
         if (settings(i)%group /= place) cycle
         found = entry_place(group, trim(settings(i)%name))
         if (found == 0) then
            if (settings(i)%is_required) call fail(error, code_input, place_of(group%file, group%line)//'&'//group%name &
               //': '//trim(settings(i)%name)//' is missing')
            if (allocated(error)) return
            cycle
         end if
         values%line(i) = group%entries(found)%line
         select case (settings(i)%rule)
         case (rule_text)
            text = ''
            call take_text(group, trim(settings(i)%name), text, error)
            if (allocated(error)) return
            if (settings(i)%name == 'quantities') then
               call read_quantities(text, place_of(group%file, values%line(i))//'&output: ', chosen%quantities, error)
            else if (text == '') then
               call fail(error, code_input, place_of(group%file, values%line(i))//'&'//group%name//': ' &
                  //trim(settings(i)%name)//' needs the name of a file')
            else
               chosen%table = text
            end if
         case (rule_truth)
            call take_truth(group, trim(settings(i)%name), chosen%relative, error)
         case default
            call take_numbers(group, trim(settings(i)%name), settings(i)%values, values%numbers(:, i), found, error)
            if (.not. allocated(error)) call check_rule(group, settings(i), values%line(i), values%numbers(:, i), error)
            if (.not. allocated(error) .and. settings(i)%name == 'duration') &
               chosen%duration_typed = group%entries(found)%values(1)%text
         end select
         if (allocated(error)) return
      end do
   end subroutine read_group

   !> Whether every value of a name is what it may be.
   pure subroutine check_rule(group, setting, line, numbers, error)
      type(group_type), intent(in) :: group
      type(setting_type), intent(in) :: setting
      integer, intent(in) :: line
      real(wp), intent(in) :: numbers(3)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: rule
      logical :: holds
      integer :: i

      do i = 1, setting%values
         select case (setting%rule)
         case (rule_positive)
            holds = numbers(i) > 0
            rule = 'be positive'
         case (rule_not_negative)
            holds = numbers(i) >= 0
            rule = 'not be negative'
         case (rule_fraction)
            holds = numbers(i) >= 0 .and. numbers(i) <= 1
            rule = 'lie between 0 and 1'
         case (rule_part)
            holds = numbers(i) >= 0 .and. numbers(i) < 1
            rule = 'be at least 0 and less than 1'
         case (rule_latitude)
            holds = abs(numbers(i)) <= 90
            rule = 'lie between -90 and 90 degrees'
         case (rule_count)
            ! Whole numbers are exact in a double up to 1/epsilon.
            holds = numbers(i) >= 2 .and. numbers(i) <= 1/epsilon(1.0_wp) .and. abs(numbers(i) - anint(numbers(i))) <= 0
            rule = 'be a whole number from 2 to 4.5e15'
         case default
            holds = .true.
            rule = ''
         end select
         if (holds) cycle
         call fail(error, code_input, place_of(group%file, line)//'&'//group%name//': '//trim(setting%name)//' must '//rule &
            //', got '//shortest_text(numbers(i)))
         return
      end do
   end subroutine check_rule

   !> Puts the numbers where they belong, or what holds without them.
   pure subroutine take_values(values, chosen)
      type(values_type), intent(in) :: values
      type(settings_type), intent(inout) :: chosen
      !> Of air at 20 degrees Celsius and 101325 Pa: ISO 2533 gives 1.225 and 1.789e-5 at 15 degrees, ideal gas and Sutherland's
      !> law these at 20.
      real(wp), parameter :: air_density = 1.204_wp, air_viscosity = 1.813e-5_wp
      real(wp), parameter :: sidereal_rate = 7.292115e-5_wp  ! of the Earth, IERS

      chosen%duration = number(output_group, 'duration', 0.0_wp)
      chosen%samples = nint(number(output_group, 'samples', 201.0_wp), int64)
      chosen%restitution = number(string_group, 'restitution', 0.0_wp)
      chosen%density_ratio = number(buoyancy_group, 'density_ratio', 0.0_wp)
      chosen%added_mass = number(buoyancy_group, 'added_mass', 0.0_wp)
      chosen%frame_rate = number(turning_frame_group, 'rate', 0.0_wp)
      chosen%linear_drag = number(air_group, 'linear', 0.0_wp)
      chosen%quadratic_drag = number(air_group, 'quadratic', 0.0_wp)
      chosen%diameter = number(air_group, 'diameter', 0.0_wp)
      chosen%mass = number(air_group, 'mass', 0.0_wp)
      chosen%density = number(air_group, 'density', air_density)
      chosen%viscosity = number(air_group, 'viscosity', air_viscosity)
      chosen%wind = vector(wind_group, 'velocity')
      chosen%latitude = number(earth_rotation_group, 'latitude', 0.0_wp)
      chosen%earth_rate = number(earth_rotation_group, 'rate', sidereal_rate)
      chosen%amplitude = vector(moving_pivot_group, 'amplitude')
      chosen%frequency = vector(moving_pivot_group, 'frequency')
      chosen%phase = vector(moving_pivot_group, 'phase')
      chosen%stiffness = number(elastic_group, 'stiffness', 0.0_wp)
      chosen%elastic_mass = number(elastic_group, 'mass', 0.0_wp)
      chosen%extra_length(1) = number(anisotropic_support_group, 'extra_length_x', 0.0_wp)
      chosen%extra_length(2) = number(anisotropic_support_group, 'extra_length_y', 0.0_wp)

   contains

      pure real(wp) function number(group, name, default)
         integer, intent(in) :: group
         character(len=*), intent(in) :: name
         real(wp), intent(in) :: default

         number = merge(values%numbers(1, setting_place(group, name)), default, is_given(values, group, name))
      end function number

      pure function vector(group, name)
         integer, intent(in) :: group
         character(len=*), intent(in) :: name
         real(wp) :: vector(3)

         vector = values%numbers(:, setting_place(group, name))
      end function vector
   end subroutine take_values

   !> Groups and names that need or exclude each other.
   pure subroutine check_together(values, chosen, error)
      type(values_type), intent(in) :: values
      type(settings_type), intent(in) :: chosen
      type(error_type), allocatable, intent(out) :: error
      integer :: i
      character(len=9), parameter :: of_sphere(4) = [character(len=9) :: 'diameter', 'mass', 'density', 'viscosity'], &
         of_drive(3) = [character(len=9) :: 'amplitude', 'frequency', 'phase']

      call exclude(error, rod_group, string_group)
      call exclude(error, rod_group, elastic_group)
      if (chosen%given(elastic_group) .and. is_given(values, string_group, 'restitution')) call complain(error, &
         values%line(setting_place(string_group, 'restitution')), '&string: restitution and &elastic exclude each other: '// &
         'an elastic string loses nothing where it becomes taut')
      if (chosen%given(wind_group) .and. .not. chosen%given(air_group)) call complain(error, chosen%line(wind_group), &
         '&wind needs &air')
      do i = 1, size(of_sphere)
         call exclude_names(error, air_group, 'linear', of_sphere(i))
         call exclude_names(error, air_group, 'quadratic', of_sphere(i))
      end do
      if (chosen%given(air_group) .and. .not. (is_given(values, air_group, 'linear') &
         .or. is_given(values, air_group, 'quadratic'))) then
         do i = 1, 2
            if (.not. is_given(values, air_group, of_sphere(i))) call complain(error, chosen%line(air_group), &
               '&air: '//trim(of_sphere(i))//' is missing; give linear or quadratic, or diameter and mass of a sphere')
         end do
      end if
      do i = 1, size(of_drive)
         call exclude_names(error, moving_pivot_group, 'table', of_drive(i))
      end do
      if (chosen%given(moving_pivot_group) .and. .not. allocated(chosen%table)) then
         do i = 1, 2
            if (.not. is_given(values, moving_pivot_group, of_drive(i))) call complain(error, chosen%line(moving_pivot_group), &
               '&moving_pivot: '//trim(of_drive(i))//' is missing; give amplitude and frequency, or table')
         end do
      end if
      if (chosen%given(anisotropic_support_group) .and. .not. (is_given(values, anisotropic_support_group, 'extra_length_x') &
         .or. is_given(values, anisotropic_support_group, 'extra_length_y'))) &
         call complain(error, chosen%line(anisotropic_support_group), &
         '&anisotropic_support: extra_length_x or extra_length_y is missing')

   contains

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

         if (chosen%given(one) .and. chosen%given(other)) call complain(error, max(chosen%line(one), chosen%line(other)), &
            '&'//trim(group_names(one))//' and &'//trim(group_names(other))//' exclude each other')
      end subroutine exclude

      pure subroutine exclude_names(error, group, one, other)
         type(error_type), allocatable, intent(inout) :: error
         integer, intent(in) :: group
         character(len=*), intent(in) :: one, other

         if (is_given(values, group, one) .and. is_given(values, group, other)) &
            call complain(error, values%line(setting_place(group, other)), '&'//trim(group_names(group))//': '//one//' and ' &
            //trim(other)//' exclude each other')
      end subroutine exclude_names
   end subroutine check_together

   pure logical function is_given(values, group, name)
      type(values_type), intent(in) :: values
      integer, intent(in) :: group
      character(len=*), intent(in) :: name

      is_given = values%line(setting_place(group, name)) > 0
   end function is_given

   !> The words of `quantities`, separated by blanks or commas.
   pure subroutine read_quantities(text, place, chosen, error)
      character(len=*), intent(in) :: text
      character(len=*), intent(in) :: place                  !! For messages
      integer, allocatable, intent(out) :: chosen(:)
      type(error_type), allocatable, intent(out) :: error
      character(len=len(text)) :: blank
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

   pure function known_groups() result(text)
      character(len=(size(group_names) + 1)*(len(group_names) + 3)) :: text
      integer :: i

      text = '&pendulum'
      do i = 1, size(group_names)
         text = trim(text)//', &'//group_names(i)
      end do
   end function known_groups

   pure function known_names(group) result(text)
      integer, intent(in) :: group
      character(len=16*size(settings)) :: text
      integer :: i

      text = ''
      do i = 1, size(settings)
         if (settings(i)%group == group) text = trim(text)//', '//settings(i)%name
      end do
      if (text == '') then
         text = '; it takes none'
      else
         text = '; known are '//text(3:)
      end if
   end function known_names

   pure function known_quantities() result(text)
      character(len=16*size(quantities)) :: text
      integer :: i

      text = quantities(1)%name
      do i = 2, size(quantities)
         text = trim(text)//', '//quantities(i)%name
      end do
   end function known_quantities

end module kyvadlo_scene_settings_reader
