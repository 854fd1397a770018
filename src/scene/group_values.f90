!> The values of a group of a scene, checked by the table of settings: names, how many, numbers, ranges.
module kyvadlo_group_values
   use kyvadlo_namelist_file, only: entry_type, group_type, place_of
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_number_text, only: read_number
   use kyvadlo_quoting, only: is_printable
   use kyvadlo_scene_groups
   use kyvadlo_scene_settings, only: value_of_name_type
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: integer_text, shown
   implicit none
   private
   public :: read_group, refuse, set_defaults

   character(len=*), parameter :: letters = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ'

contains

   !> The numbers that hold without a name.
   pure subroutine set_defaults(values)
      type(value_of_name_type), intent(out) :: values(size(settings))
      character(len=:), allocatable :: what
      integer :: i

      do i = 1, size(settings)
         if (verify(settings(i)%default(:1), '0123456789') > 0) cycle
         call read_number(trim(settings(i)%default), values(i)%number(1), what)
         values(i)%number = values(i)%number(1)
      end do
   end subroutine set_defaults

   !> Takes the values of one group. Errors: an unknown name, one given twice or missing, a value that breaks its rule.
   pure subroutine read_group(group, place, values, error)
      type(group_type), intent(in) :: group
      integer, intent(in) :: place                     !! In `group_names`
      type(value_of_name_type), intent(inout) :: values(size(settings))
      type(error_type), allocatable, intent(out) :: error
      integer :: i, j, count

      do i = 1, size(group%entries)
         j = setting_place(place, group%entries(i)%name)
         if (j == 0) then
            call refuse(error, group, group%entries(i)%line, 'unknown name '//shown(group%entries(i)%name)// &
               known_names(place))
         else
            call take_entry(group, group%entries(i), settings(j), values(j), error)
         end if
         if (allocated(error)) return
      end do
      do i = 1, size(settings)
         if (settings(i)%group /= place) cycle
         associate (line => values(i)%line(:settings(i)%values))
            count = size(line)
            if (all(line == 0)) then
               if (settings(i)%default == 'required') &
                  call refuse(error, group, group%line, trim(settings(i)%name)//' is missing')
            else if (any(line == 0)) then
               call refuse(error, group, maxval(line), takes(settings(i))//', got fewer')
            end if
         end associate
         if (allocated(error)) return
      end do
   end subroutine read_group

   !> `name = value ...` or some of the elements of a vector.
   pure subroutine take_entry(group, entry, setting, value, error)
      type(group_type), intent(in) :: group
      type(entry_type), intent(in) :: entry
      type(setting_type), intent(in) :: setting
      type(value_of_name_type), intent(inout) :: value
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: what
      integer :: i, element, last

      last = max(entry%first, 1) + size(entry%values) - 1
      if (last > setting%values) then
         what = ''
         if (size(entry%values) > 1) then
            if (scan(entry%values(2)%text, letters) == 1) what = '; units are not written'
         end if
         call refuse(error, group, entry%line, takes(setting)//', got more'//what)
         return
      else if (entry%last > 0 .and. entry%last /= last) then
         call refuse(error, group, entry%line, trim(setting%name)//'('//integer_text(entry%first)//':'// &
            integer_text(entry%last) //') takes '//integer_text(entry%last - entry%first + 1)//' values, got '// &
            integer_text(size(entry%values)))
         return
      end if
      do i = 1, size(entry%values)
         element = last - size(entry%values) + i
         if (value%line(element) > 0) then
            call refuse(error, group, entry%line, trim(setting%name)//' given twice, first on line ' &
               //integer_text(value%line(element)))
            return
         end if
         associate (given => entry%values(i))
            value%line(element) = given%line
            value%text(element)%text = given%text
            call take_word(given%text, given%quoted, setting, value%number(element), what)
            if (.not. allocated(what)) cycle
            call refuse(error, group, given%line, trim(setting%name)//' must '//what)
            return
         end associate
      end do
   end subroutine take_entry

   !> One value: its number (a truth value is 1 or 0), or what it must be.
   pure subroutine take_word(word, is_quoted, setting, number, what)
      character(len=*), intent(in) :: word
      logical, intent(in) :: is_quoted
      type(setting_type), intent(in) :: setting
      real(wp), intent(out) :: number
      character(len=:), allocatable, intent(out) :: what   !! Allocated on failure
      logical :: holds
      integer :: i

      number = 0
      select case (setting%rule)
      case (rule_text)
         holds = is_quoted
         if (holds .and. .not. is_printable(word)) what = "be UTF-8 without control characters, got '"//shown(word)//"'"
      case (rule_truth)
         ! As Fortran reads it: a point perhaps, then t or f, then anything.
         i = merge(2, 1, index(word, '.') == 1)
         holds = .not. is_quoted .and. scan(word(i:), 'tTfF') == 1
         if (holds) number = merge(1, 0, scan(word(i:), 'tT') == 1)
      case default
         call take_number(word, is_quoted, setting, number, what)
         holds = is_in_range(setting, number)
      end select
      if (.not. holds .and. .not. allocated(what)) what = trim(rules(setting%rule))//', got '//shown(word)
   end subroutine take_word

   !> A number; one beyond the double kind may be one of the kind in which a pendulum is computed.
   pure subroutine take_number(word, is_quoted, setting, number, what)
      character(len=*), intent(in) :: word
      logical, intent(in) :: is_quoted
      type(setting_type), intent(in) :: setting
      real(wp), intent(out) :: number
      character(len=:), allocatable, intent(out) :: what
      integer :: i

      number = 0
      if (is_quoted) then
         what = 'a text'
      else
         call read_number(word, number, what)
      end if
      if (.not. allocated(what)) return
      if (what == 'not a number') then
         i = verify(word, '0123456789.+-')
         if (i > 1 .and. (scan(word(max(i, 1):), letters) == 1 .or. iachar(word(max(i, 1):max(i, 1))) > 127)) &
            what = 'units are not written'
      else if (.not. is_quoted .and. setting%group == pendulum_group) then
         deallocate (what)
         return
      end if
      what = trim(rules(rule_any))//", got '"//shown(word)//"' ("//what//')'
   end subroutine take_number

   !> Whether a number is what it may be. Length and gravity are looked at in their kind.
   pure logical function is_in_range(setting, number) result(holds)
      type(setting_type), intent(in) :: setting
      real(wp), intent(in) :: number

      holds = .true.
      select case (setting%rule)
      case (rule_positive)
         holds = number > 0 .or. setting%group == pendulum_group
      case (rule_not_negative)
         holds = number >= 0
      case (rule_fraction)
         holds = number >= 0 .and. number <= 1
      case (rule_part)
         holds = number >= 0 .and. number < 1
      case (rule_latitude)
         holds = abs(number) <= 90
      case (rule_half_turn)
         holds = abs(number) <= 180
      case (rule_count)
         ! Whole numbers are exact in a double up to 1/epsilon.
         holds = number >= 2 .and. number <= 1/epsilon(1.0_wp) .and. abs(number - anint(number)) <= 0
      case (rule_direction)
         holds = abs(number) <= 1 .and. abs(number - anint(number)) <= 0
      end select
   end function is_in_range

   !> An error of a group.
   pure subroutine refuse(error, group, line, message)
      type(error_type), allocatable, intent(out) :: error
      type(group_type), intent(in) :: group
      integer, intent(in) :: line
      character(len=*), intent(in) :: message

      call fail(error, code_input, place_of(group%file, line)//'&'//group%name//': '//message)
   end subroutine refuse

   pure integer function length_of_takes(setting)
      type(setting_type), intent(in) :: setting

      length_of_takes = len_trim(setting%name) + len(' takes one number')
      if (setting%values /= 1 .and. setting%rule /= rule_text) length_of_takes = length_of_takes - 1
   end function length_of_takes

   !> `length takes one number`
   pure function takes(setting) result(text)
      type(setting_type), intent(in) :: setting
      character(len=length_of_takes(setting)) :: text

      text = trim(setting%name)//' takes '//merge('one number', integer_text(setting%values)//' numbers ', &
         setting%values == 1)
      if (setting%rule == rule_text) text = trim(setting%name)//' takes one text'
   end function takes

   !> The names of a group, blanks behind.
   pure function known_names(group) result(text)
      integer, intent(in) :: group
      character(len=22*size(settings)) :: text
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

end module kyvadlo_group_values
