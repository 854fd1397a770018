!> The settings by which a scene is differentiated: the words of `derivatives` in &output.
module kyvadlo_scene_derivatives
   use kyvadlo_scene, only: body_inertia, pendulum_type
   use kyvadlo_scene_groups
   use kyvadlo_scene_settings, only: derivative_type, settings_type
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: integer_text, lower_case, shown, split_words
   implicit none
   private
   public :: derivative_type, parse_derivatives

contains

   !> A setting for each word, and each element of a vector; without words length, gravity and the two names of the
   !> start. A word is a name, with its element in parentheses and its group before a point if need be: `length`,
   !> `position(1)`, `wind.velocity`.
   !>
   !> Errors (`code_input`): a word that is no number of this scene, one that several groups have, one given twice.
   pure subroutine parse_derivatives(words, settings_of_scene, pendulum, list, error)
      character(len=*), intent(in) :: words                     !! Separated by blanks or commas
      type(settings_type), intent(in) :: settings_of_scene
      type(pendulum_type), intent(in) :: pendulum
      type(derivative_type), allocatable, intent(out) :: list(:)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text
      integer, allocatable :: first(:), last(:)
      integer :: i, count

      allocate (list(0))
      text = lower_case(words)
      do i = 1, len(text)
         if (text(i:i) == ',') text(i:i) = ' '
      end do
      if (text == '') text = trim(merge('inertia', 'length ', is_body(pendulum)))//' gravity '// &
         trim(starts(pendulum%start)%first)//' '//trim(starts(pendulum%start)%second)
      call split_words(text, first, last, count)
      do i = 1, count
         call add_word(text(first(i):last(i)), settings_of_scene, pendulum, list, error)
         if (allocated(error)) return
      end do
   end subroutine parse_derivatives

   pure subroutine add_word(word, settings_of_scene, pendulum, list, error)
      character(len=*), intent(in) :: word
      type(settings_type), intent(in) :: settings_of_scene
      type(pendulum_type), intent(in) :: pendulum
      type(derivative_type), allocatable, intent(inout) :: list(:)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: group, name, others
      integer :: i, found, open, element

      name = word
      group = ''
      element = 0
      open = index(name, '(')
      if (open > 0) then
         element = index('123', name(open + 1:min(open + 1, len(name))))
         if (name(open:) /= '('//integer_text(element)//')' .or. element == 0) then
            call fail(error, code_input, 'an element is written (1), (2) or (3), got '//shown(word))
            return
         end if
         name = name(:open - 1)
      end if
      i = index(name, '.')
      if (i > 0) then
         group = name(:i - 1)
         name = name(i + 1:)
      end if
      found = 0
      others = ''
      do i = 1, size(settings)
         if (settings(i)%name /= name .or. .not. is_number_of(i, settings_of_scene, pendulum)) cycle
         if (group /= '' .and. group_names(settings(i)%group) /= group) cycle
         others = others//', '//trim(group_names(settings(i)%group))//'.'//trim(name)
         found = i
      end do
      if (group /= '') group = group//'_'
      if (found == 0) then
         call fail(error, code_input, 'no number of this scene to differentiate by is '//shown(word)//'; there are '// &
            trim(known(settings_of_scene, pendulum)))
      else if (index(others(3:), ',') > 0) then
         call fail(error, code_input, shown(word)//' is a name of several groups; write one of '//others(3:))
      else if (element > settings(found)%values) then
         call fail(error, code_input, trim(name)//' is no vector, got '//shown(word))
      else if (settings(found)%values == 1) then
         call add(found, 1, group//name, list, error)
      else
         do i = 1, settings(found)%values
            if (element == 0 .or. element == i) call add(found, i, group//name//integer_text(i), list, error)
         end do
      end if
   end subroutine add_word

   pure subroutine add(setting, element, name, list, error)
      integer, intent(in) :: setting, element
      character(len=*), intent(in) :: name
      type(derivative_type), allocatable, intent(inout) :: list(:)
      type(error_type), allocatable, intent(inout) :: error

      if (allocated(error)) return
      if (any(list%setting == setting .and. list%element == element)) then
         call fail(error, code_input, name//' given twice')
      else
         list = [list, derivative_type(setting, element, name)]
      end if
   end subroutine add

   !> Whether a setting is a number that this scene has: of its start, or of a group that stands in it and is not
   !> replaced by others.
   pure logical function is_number_of(setting, chosen, pendulum) result(holds)
      integer, intent(in) :: setting                            !! Place in `settings`
      type(settings_type), intent(in) :: chosen
      type(pendulum_type), intent(in) :: pendulum

      associate (name => settings(setting)%name, group => settings(setting)%group)
         holds = all(settings(setting)%rule /= [rule_text, rule_truth, rule_count]) .and. &
            all(group /= [output_group, event_group])
         if (group == pendulum_group) then
            holds = holds .and. any(name == [character(len=19) :: 'length', 'gravity', starts(pendulum%start)%first, &
               starts(pendulum%start)%second]) .and. .not. (is_body(pendulum) .and. name == 'length')
            return
         end if
         holds = holds .and. chosen%given(group)
         if (group == air_group) holds = holds .and. (any(name == [character(len=19) :: 'linear', 'quadratic']) &
            .neqv. chosen%number(1, setting_place(air_group, 'diameter')) > 0)
         if (group == moving_pivot_group) holds = holds .and. .not. allocated(chosen%table) .and. &
            .not. allocated(chosen%effects%pivot_curve%times) .and. (index(name, 'circle') == 1 .eqv. &
            chosen%number(1, setting_place(moving_pivot_group, 'circle_radius')) > 0) .and. any(name == &
            [character(len=19) :: 'amplitude', 'frequency', 'phase', 'circle_radius', 'circle_rate'])
         if (group == hoist_group) holds = holds .and. .not. allocated(chosen%hoist_table)
         if (group == body_group) holds = holds .and. is_body(pendulum) .and. &
            any(name == [character(len=19) :: 'inertia', 'distance', 'mass'])
         if (group == string_group) holds = holds .and. .not. chosen%given(elastic_group)
      end associate
   end function is_number_of

   !> Whether inertia, mass and distance make the length.
   pure logical function is_body(pendulum)
      type(pendulum_type), intent(in) :: pendulum

      is_body = allocated(pendulum%body(body_inertia)%text)
   end function is_body

   !> Blanks behind.
   pure function known(chosen, pendulum) result(text)
      type(settings_type), intent(in) :: chosen
      type(pendulum_type), intent(in) :: pendulum
      character(len=22*size(settings)) :: text
      integer :: i

      text = ''
      do i = 1, size(settings)
         if (is_number_of(i, chosen, pendulum)) text = trim(text)//', '//settings(i)%name
      end do
      text = text(3:)
   end function known

end module kyvadlo_scene_derivatives
