!> How a scene file becomes pendulums.
module kyvadlo_scene_reader
   use kyvadlo_group_values, only: read_group, refuse
   use kyvadlo_namelist_file, only: entry_type, group_type, parse_groups, place_of, read_groups
   use kyvadlo_scene, only: body_inertia, body_names, pendulum_type
   use kyvadlo_scene_groups
   use kyvadlo_scene_settings, only: settings_type, value_of_name_type
   use kyvadlo_scene_settings_reader, only: settings_from_groups
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: integer_text, shown, text_type
   implicit none
   private
   public :: read_scene, parse_scene, pendulums_from_groups, choose_pendulum, keep_pendulum

contains

   !> Reads the pendulums of a scene file.
   !>
   !> Errors (`code_file`, `code_input`): the file cannot be read, is empty or binary; syntax; unknown group or name; a
   !> name given twice; a start that is missing, incomplete or given in two ways; a value that is no finite number; an
   !> effect, which only `simulate` computes, unless a note is asked for. Each names file, line, rule and value.
   subroutine read_scene(path, pendulums, error, note)
      character(len=*), intent(in) :: path                       !! `-`: standard input
      type(pendulum_type), allocatable, intent(out) :: pendulums(:)
      type(error_type), allocatable, intent(out) :: error
      type(text_type), intent(out), optional :: note             !! Allocated where the pendulums are without an effect
      type(group_type), allocatable :: groups(:)

      call read_groups(path, groups, error)
      if (.not. allocated(error)) call scene_from_groups(groups, path, pendulums, error, note)
      if (.not. allocated(pendulums)) allocate (pendulums(0))
   end subroutine read_scene

   !> The pendulums of a text in the form of a scene file.
   pure subroutine parse_scene(text, file, pendulums, error, note)
      character(len=*), intent(in) :: text
      character(len=*), intent(in) :: file                       !! Name for messages
      type(pendulum_type), allocatable, intent(out) :: pendulums(:)
      type(error_type), allocatable, intent(out) :: error
      type(text_type), intent(out), optional :: note
      type(group_type), allocatable :: groups(:)

      call parse_groups(text, file, groups, error)
      if (.not. allocated(error)) call scene_from_groups(groups, file, pendulums, error, note)
      if (.not. allocated(pendulums)) allocate (pendulums(0))
   end subroutine parse_scene

   !> Only what a pendulum without effects is: &output, &rod, &fit and &camera change nothing about it, &body its
   !> length.
   pure subroutine scene_from_groups(groups, file, pendulums, error, note)
      type(group_type), intent(in) :: groups(:)
      character(len=*), intent(in) :: file
      type(pendulum_type), allocatable, intent(out) :: pendulums(:)
      type(error_type), allocatable, intent(out) :: error
      type(text_type), intent(out), optional :: note
      type(settings_type) :: settings
      character(len=:), allocatable :: what
      integer :: i

      call settings_from_groups(groups, file, settings, error)
      if (.not. allocated(error)) call pendulums_from_groups(groups, file, pendulums, error)
      if (allocated(error)) return
      do i = 1, size(group_names)
         ! The length of the orbit is that of a rod, which is what the tables show anyway.
         if (.not. settings%given(i) .or. any(i == [output_group, rod_group, fit_group, camera_group, &
            event_group, body_group])) cycle
         what = place_of(file, settings%line(i))//'&'//trim(group_names(i))//' is computed by kyvadlo simulate'
         if (present(note)) then
            note%text = what//'; a table is of the motion without it'
         else
            call fail(error, code_input, what)
         end if
         return
      end do
   end subroutine scene_from_groups

   !> The pendulums among the groups, with their &body; the others are left alone. Error: there is none.
   pure subroutine pendulums_from_groups(groups, file, pendulums, error)
      type(group_type), intent(in) :: groups(:)
      character(len=*), intent(in) :: file
      type(pendulum_type), allocatable, intent(out) :: pendulums(:)
      type(error_type), allocatable, intent(out) :: error
      type(value_of_name_type) :: body(size(settings))
      integer :: i, count, line

      count = 0
      line = 0
      do i = 1, size(groups)
         if (groups(i)%name == 'pendulum') count = count + 1
         if (groups(i)%name /= 'body') cycle
         call read_group(groups(i), body_group, body, error)
         if (allocated(error)) return
         line = groups(i)%line
      end do
      allocate (pendulums(count))
      count = 0
      do i = 1, size(groups)
         if (groups(i)%name /= 'pendulum') cycle
         count = count + 1
         call pendulum_from_group(groups(i), line, body, pendulums(count), error)
         if (allocated(error)) return
         if (pendulums(count)%name == '') pendulums(count)%name = 'pendulum '//integer_text(count)
      end do
      if (count == 0) call fail(error, code_input, file//': no &pendulum group')
   end subroutine pendulums_from_groups

   !> Leaves only the pendulum of that name, or of that number if none has that name. Error: there is none, or there are
   !> several.
   pure subroutine choose_pendulum(pendulums, choice, error)
      type(pendulum_type), allocatable, intent(inout) :: pendulums(:)
      character(len=*), intent(in) :: choice
      type(error_type), allocatable, intent(out) :: error
      type(text_type) :: names(size(pendulums))
      integer :: i, found

      do i = 1, size(pendulums)
         names(i)%text = pendulums(i)%name
      end do
      call find_choice(names, choice, found, error)
      if (.not. allocated(error)) pendulums = pendulums(found:found)
   end subroutine choose_pendulum

   !> The same among the groups of a file, which keep all others. Error too: there are several and no choice.
   pure subroutine keep_pendulum(groups, file, error, choice)
      type(group_type), allocatable, intent(inout) :: groups(:)
      character(len=*), intent(in) :: file
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in), optional :: choice
      type(text_type), allocatable :: names(:)
      type(entry_type), allocatable :: longer(:)
      integer, allocatable :: places(:)
      integer :: i, j, found

      places = pack([(i, i=1, size(groups))], [(groups(i)%name == 'pendulum', i=1, size(groups))])
      if (.not. present(choice)) then
         if (size(places) > 1) call fail(error, code_input, place_of(file, groups(places(2))%line)// &
            'a second &pendulum; choose it by --pendulum')
         return
      end if
      allocate (names(size(places)))
      do i = 1, size(places)
         associate (group => groups(places(i)))
            do j = 1, size(group%entries)
               if (group%entries(j)%name == 'name' .and. size(group%entries(j)%values) == 1) &
                  names(i)%text = trim(group%entries(j)%values(1)%text)
            end do
            if (allocated(names(i)%text)) cycle
            ! As it is called beside the others.
            names(i)%text = 'pendulum '//integer_text(i)
            allocate (longer(size(group%entries) + 1))
            longer(:size(group%entries)) = group%entries
            associate (name => longer(size(longer)))
               name%name = 'name'
               name%line = group%line
               allocate (name%values(1))
               name%values(1)%text = names(i)%text
               name%values(1)%quoted = .true.
               name%values(1)%line = group%line
            end associate
            call move_alloc(longer, group%entries)
         end associate
      end do
      call find_choice(names, choice, found, error)
      if (allocated(error)) return
      groups = pack(groups, [(all(places /= i) .or. i == places(found), i=1, size(groups))])
   end subroutine keep_pendulum

   !> The place of the name, or of the number if there is no such name.
   pure subroutine find_choice(names, choice, found, error)
      type(text_type), intent(in) :: names(:)
      character(len=*), intent(in) :: choice
      integer, intent(out) :: found
      type(error_type), allocatable, intent(out) :: error
      integer :: i, count, status

      found = 0
      count = 0
      do i = 1, size(names)
         if (names(i)%text /= choice) cycle
         found = i
         count = count + 1
      end do
      if (count == 0 .and. choice /= '' .and. len(choice) < 10 .and. verify(choice, '0123456789') == 0) then
         read (choice, '(i9)', iostat=status) found
         if (status == 0 .and. found >= 1 .and. found <= size(names)) count = 1
      end if
      if (count /= 1) call fail(error, code_input, 'option --pendulum: '// &
         trim(merge('none is named    ', 'several are named', count == 0)) //" '"//shown(choice)// &
         "'; give another name, or a number from 1 to "//integer_text(size(names)))
   end subroutine find_choice

   !> Takes the values of a group and finds its start.
   pure subroutine pendulum_from_group(given, body_line, body, pendulum, error)
      type(group_type), intent(in) :: given
      integer, intent(in) :: body_line                  !! Of &body; 0: there is none
      type(value_of_name_type), intent(in) :: body(size(settings))
      type(pendulum_type), intent(out) :: pendulum
      type(error_type), allocatable, intent(out) :: error
      type(value_of_name_type) :: values(size(settings))
      type(group_type) :: group
      integer :: i, line

      group = given
      do i = 1, size(group%entries)
         associate (entry => group%entries(i), old => findloc(old_names, group%entries(i)%name, 1))
            if (old == 0) cycle
            entry%name = trim(new_names(old))
            if (allocated(pendulum%note)) then
               pendulum%note = pendulum%note//', '
            else
               pendulum%note = place_of(group%file, entry%line)//'&pendulum: '
            end if
            pendulum%note = pendulum%note//trim(old_names(old))//' is now '//entry%name
         end associate
      end do
      pendulum%file = group%file
      pendulum%line = group%line
      pendulum%body_line = body_line
      do i = 1, merge(size(body_names), 0, body_line > 0)
         associate (value => body(setting_place(body_group, trim(body_names(i)))))
            if (value%line(1) > 0) pendulum%body(i) = value%text(1)
         end associate
      end do
      if (allocated(pendulum%body(body_inertia)%text)) call leave_length(group, error)
      if (allocated(error)) return
      call read_group(group, pendulum_group, values, error)
      if (allocated(error)) return
      pendulum%name = ''
      i = setting_place(pendulum_group, 'name')
      if (values(i)%line(1) > 0) pendulum%name = trim(values(i)%text(1)%text)
      call take('length', pendulum%length, pendulum%length_line)
      call take('gravity', pendulum%gravity, pendulum%gravity_line)
      call choose_start(group, values, pendulum%start, error)
      if (allocated(error)) return
      pendulum%values = starts(pendulum%start)%values
      do i = 1, pendulum%values
         call take(starts(pendulum%start)%second, pendulum%second(i), line, i)
         call take(starts(pendulum%start)%first, pendulum%first(i), pendulum%start_line, i)
      end do

   contains

      !> A number as it was written, or the default.
      pure subroutine take(name, text, line, element)
         character(len=*), intent(in) :: name
         type(text_type), intent(out) :: text
         integer, intent(out) :: line
         integer, intent(in), optional :: element
         integer :: place, j

         j = 1
         if (present(element)) j = element
         place = setting_place(pendulum_group, name)
         line = values(place)%line(j)
         if (line > 0) then
            text = values(place)%text(j)
         else
            text%text = trim(settings(place)%default)
         end if
      end subroutine take
   end subroutine pendulum_from_group

   !> A body has the length that it makes: none may be given, and a number that nothing comes of stands for it.
   pure subroutine leave_length(group, error)
      type(group_type), intent(inout) :: group
      type(error_type), allocatable, intent(out) :: error
      type(entry_type), allocatable :: entries(:)
      integer :: i, n

      n = size(group%entries)
      do i = 1, n
         if (group%entries(i)%name == 'length') call refuse(error, group, group%entries(i)%line, &
            'length and inertia of &body exclude each other')
         if (allocated(error)) return
      end do
      allocate (entries(n + 1))
      entries(:n) = group%entries
      entries(n + 1)%name = 'length'
      entries(n + 1)%line = group%line
      allocate (entries(n + 1)%values(1))
      entries(n + 1)%values(1)%text = '1'
      entries(n + 1)%values(1)%line = group%line
      call move_alloc(entries, group%entries)
   end subroutine leave_length

   !> Finds the one start whose names the group gives.
   pure subroutine choose_start(group, values, start, error)
      type(group_type), intent(in) :: group
      type(value_of_name_type), intent(in) :: values(size(settings))
      integer, intent(out) :: start               !! Place in `starts`
      type(error_type), allocatable, intent(out) :: error
      integer :: i, j, other

      start = 0
      do i = 1, size(group%entries)
         do j = 1, size(starts)
            if (starts(j)%first /= group%entries(i)%name .and. &
               (starts(j)%second /= group%entries(i)%name .or. count(starts%second == starts(j)%second) > 1)) cycle
            if (start /= 0 .and. start /= j) then
               call refuse(error, group, group%entries(i)%line, &
                  'two starts: '//pair(start)//' and '//pair(j)//'; give exactly one')
               return
            end if
            start = j
         end do
      end do
      ! A second name that several starts have tells nothing.
      other = 0
      do j = 1, size(starts)
         if (line_of(starts(j)%second) == 0) cycle
         if (start == 0) then
            other = j
         else if (starts(j)%second /= starts(start)%second) then
            other = j
         end if
      end do
      if (start == 0 .and. other > 0) then
         call refuse(error, group, line_of(starts(other)%second), trim(starts(other)%second)//' without '// &
            firsts(starts(other)%second))
      else if (start == 0) then
         call refuse(error, group, group%line, 'no start; give exactly one of '//all_starts())
      else if (line_of(starts(start)%first) == 0) then
         call refuse(error, group, group%line, trim(starts(start)%second)//' without '//trim(starts(start)%first))
      else if (line_of(starts(start)%second) == 0 .and. start /= start_release) then
         call refuse(error, group, group%line, trim(starts(start)%first)//' without '//trim(starts(start)%second))
      else if (other > 0) then
         call refuse(error, group, line_of(starts(other)%second), 'two starts: '//pair(start)//' and '// &
            trim(starts(other)%second)//'; give exactly one')
      end if

   contains

      pure integer function line_of(name)
         character(len=*), intent(in) :: name

         line_of = values(setting_place(pendulum_group, name))%line(1)
      end function line_of
   end subroutine choose_start

   pure function pair(start) result(text)
      integer, intent(in) :: start
      character(len=len_trim(starts(start)%first) + 2 + len_trim(starts(start)%second)) :: text

      text = trim(starts(start)%first)//', '//trim(starts(start)%second)
   end function pair

   !> The first names of the starts with a second name, blanks behind: `a, b or c`.
   pure function firsts(second) result(text)
      character(len=*), intent(in) :: second
      character(len=25*size(starts)) :: text
      integer :: i, last

      text = ''
      last = findloc(starts%second, second, 1, back=.true.)
      do i = 1, last
         if (starts(i)%second /= second) cycle
         if (text /= '' .and. i < last) text = trim(text)//','
         if (text /= '' .and. i == last) text = trim(text)//' or'
         text = adjustl(trim(text)//' '//starts(i)%first)
      end do
   end function firsts

   !> Blanks behind.
   pure function all_starts() result(text)
      character(len=50*size(starts)) :: text
      integer :: i

      text = '('//pair(1)//')'
      do i = 2, size(starts)
         text = trim(text)//' ('//pair(i)//')'
      end do
   end function all_starts

end module kyvadlo_scene_reader
