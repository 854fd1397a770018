!> `kyvadlo help scenes`, `effects`, `output`, ... and the page kyvadlo-scene(5): the table of settings in words.
module kyvadlo_help_topics
   use kyvadlo_commands, only: commands
   use kyvadlo_quantities, only: default_quantities, quantities
   use kyvadlo_roff, only: roff, upper_case
   use kyvadlo_scene_groups, only: group_meanings, group_names, has_closed_form, settings, starts
   use kyvadlo_text, only: text_sink_type
   implicit none
   private
   public :: topics, topic_type, has_topic, write_topic, write_scene_page

   type :: topic_type
      character(len=8) :: name
      character(len=72) :: summary
   end type topic_type

   !> What is not about a command alone. `fit` and `sweep` are of the commands of those names.
   type(topic_type), parameter :: topics(*) = [ &
      topic_type('scenes', 'how a file describes a pendulum: &pendulum, the ways to give its start'), &
      topic_type('effects', 'what else may act on it: a group for each effect'), &
      topic_type('output', 'what is computed of it, and when: &output and its quantities'), &
      topic_type('fit', 'what a fit is told: its group of settings'), &
      topic_type('sweep', 'what a sweep is told: axes, measures, histograms')]

   !> The names of a plan's groups. (A scene has no such groups: they are not in the table of settings.)
   type :: plan_name_type
      character(len=9) :: group
      character(len=20) :: names
      character(len=100) :: meaning
   end type plan_name_type
   type(plan_name_type), parameter :: plan_names(*) = [ &
      plan_name_type('axis', 'name', 'the setting that takes the values: length, z_upper, frequency(1) ...'), &
      plan_name_type('axis', 'from, to, count', 'equidistant values between two decimals, both included'), &
      plan_name_type('axis', 'scale', 'linear or log'), &
      plan_name_type('axis', 'values', 'the values themselves, in place of from, to and count'), &
      plan_name_type('axis', 'random, count, seed', 'uniform (from, to) or normal, by Philox4x32-10'), &
      plan_name_type('axis', 'mean, deviation', 'of a normal axis; without mean the value in the scene'), &
      plan_name_type('axis', 'covariance', 'in place of deviation: a row of the matrix of the normal axes together'), &
      plan_name_type('axis', 'together', 'axes with one name run side by side, others multiply'), &
      plan_name_type('measure', 'quantities', &
      'T k K q A phi_T advance turning heights rates; least_, greatest_, first_, last_ and a column; ...'), &
      plan_name_type('measure', 'crossing, level, at', &
      'the column and level of crossing_time, the time of swing_amplitude and swing_azimuth'), &
      plan_name_type('histogram', 'quantity, from, to', 'what is counted, and between which bounds'), &
      plan_name_type('histogram', 'count, scale', 'bins, linear or log')]

contains

   !> Is there something to say about it? (Of a command that this program has not, no.)
   pure logical function has_topic(name)
      character(len=*), intent(in) :: name

      has_topic = any(topics%name == name) .and. &
         (name /= 'fit' .and. name /= 'sweep' .or. any(commands%name == name))
   end function has_topic

   subroutine write_topic(sink, name)
      class(text_sink_type), intent(inout) :: sink
      character(len=*), intent(in) :: name

      call put_topic(sink, name, .false.)
   end subroutine write_topic

   !> kyvadlo-scene(5) in the man macros of roff.
   subroutine write_scene_page(sink, version)
      class(text_sink_type), intent(inout) :: sink
      character(len=*), intent(in) :: version
      integer :: i

      call sink%put('.\" Written by kyvadlo --scene-page')
      call sink%put('.TH KYVADLO-SCENE 5 "" "kyvadlo '//version//'" "File Formats"')
      call sink%put('.SH NAME')
      call sink%put('kyvadlo-scene \- files that describe a pendulum, what acts on it and what is computed')
      do i = 1, size(topics)
         if (.not. has_topic(trim(topics(i)%name))) cycle
         call put_topic(sink, trim(topics(i)%name), .true.)
      end do
      call sink%put('.SH SEE ALSO')
      call sink%put('.BR kyvadlo (1)')
   end subroutine write_scene_page

   !> One topic, as plain text or for roff.
   subroutine put_topic(sink, name, for_roff)
      class(text_sink_type), intent(inout) :: sink
      character(len=*), intent(in) :: name
      logical, intent(in) :: for_roff
      integer :: i

      if (for_roff) call sink%put('.SH '//upper_case(name))
      select case (name)
      case ('scenes')
         call put_lines( &
            'A scene is a text file in the form of Fortran''s namelists; ! begins a comment. All quantities are', &
            'in SI units, heights z are counted upwards from the pivot. For example:')
         call put_example()
         call put_lines('Each &pendulum ... / is a pendulum: a length, and one start by a pair of these names:', '')
         do i = 1, size(starts)
            call put_item(trim(starts(i)%first)//', '//trim(starts(i)%second), '')
         end do
         call put_lines( &
            'z1 is the upper and z2 the lower turning height, l the length, g gravity, c1 the energy and c2 the', &
            'angular momentum about the vertical per mass. `kyvadlo examples` lists scenes to begin with.')
         call put_lines('Other groups of a scene (their names: `kyvadlo help effects`, `output`, `fit`):', '')
         do i = 1, size(group_names)
            if (topic_of(trim(group_names(i))) == name) cycle
            if (for_roff) call put_item('&'//trim(group_names(i)), trim(group_meanings(i)))
            if (.not. for_roff) call sink%put('  &'//group_names(i)//'  '//trim(group_meanings(i)))
         end do
      case ('effects')
         call put_lines( &
            'A group for each effect; without its group an effect is not there and costs nothing. What has a', &
            'closed form is computed by it, the rest is integrated by GSL. Each group may stand once in a scene.')
      case ('sweep')
         call put_lines('A plan is a scene with &axis groups, a &measure, perhaps &histogram groups (doc/sweeps.md):', &
            '')
         do i = 1, size(plan_names)
            call put_item('&'//trim(plan_names(i)%group)//' '//trim(plan_names(i)%names), trim(plan_names(i)%meaning))
         end do
      case ('output')
         call put_lines('At most one &output in a scene says when and what `kyvadlo simulate` computes:', '')
      end select
      do i = 1, size(group_names)
         if (topic_of(trim(group_names(i))) == name) call put_group(i)
      end do
      if (name == 'output') then
         call put_lines('The words of `quantities` ('//default_quantities//' if it is not given), in any order:', '')
         do i = 1, size(quantities)
            associate (q => quantities(i))
               if (any(q%column_names(:q%columns) /= '')) then
                  call put_item(trim(q%name), trim(q%meaning)//' ['//trim(q%unit)//'], in '// &
                     columns_text(q%column_names(:q%columns)))
               else   ! its columns depend on the others
                  call put_item(trim(q%name), trim(q%meaning))
               end if
            end associate
         end do
      end if

   contains

      subroutine put_group(group)
         integer, intent(in) :: group
         character(len=:), allocatable :: how, term
         integer :: j

         how = ''
         if (name == 'effects') how = trim(merge(' (closed form)', ' (integrated) ', has_closed_form(group)))
         if (for_roff) then
            call sink%put('.SS &'//roff(trim(group_names(group))//how))
            call sink%put(roff(trim(group_meanings(group))))
         else
            call sink%put('')
            call sink%put('&'//trim(group_names(group))//how//': '//trim(group_meanings(group)))
         end if
         do j = 1, size(settings)
            associate (s => settings(j))
               if (s%group /= group) cycle
               term = trim(s%name)
               if (s%values == 3) term = term//' (three numbers)'
               if (s%values == 2) term = term//' (two numbers)'
               if (s%unit /= '') term = term//' ['//trim(s%unit)//']'
               if (s%default == 'required') then
                  term = term//', must be given'
               else if (s%default /= '') then
                  term = term//', default '//without_marks(trim(s%default))
               end if
               call put_item(term, without_marks(trim(s%meaning)))
            end associate
         end do
      end subroutine put_group

      subroutine put_item(term, meaning)
         character(len=*), intent(in) :: term, meaning

         if (for_roff) then
            call sink%put('.TP')
            call sink%put('.B '//roff(term))
            call sink%put(roff(meaning))
         else
            call sink%put('  '//term)
            if (meaning /= '') call sink%put('      '//meaning)
         end if
      end subroutine put_item

      subroutine put_lines(first, second)
         character(len=*), intent(in) :: first, second   !! The second may be empty

         if (for_roff) then
            call sink%put('.PP')
            call sink%put(roff(without_marks(first)))
            if (second /= '') call sink%put(roff(without_marks(second)))
         else
            if (name == 'scenes' .and. first(:1) /= 'A' .or. index(first, 'The words') == 1) call sink%put('')
            call sink%put(without_marks(first))
            if (second /= '') call sink%put(without_marks(second))
         end if
      end subroutine put_lines

      subroutine put_example()
         character(len=*), parameter :: lines(*) = [character(len=60) :: '&pendulum', &
            '   length = 1                      ! [m]', '   z_upper = 0.3, z_lower = -0.8', '/', '&output', &
            '   duration = 10, samples = 101    ! [s], both ends count', '/']
         integer :: j

         if (for_roff) call sink%put('.nf')
         if (.not. for_roff) call sink%put('')
         do j = 1, size(lines)
            if (for_roff) call sink%put(roff(trim(lines(j))))
            if (.not. for_roff) call sink%put('  '//trim(lines(j)))
         end do
         if (for_roff) call sink%put('.fi')
      end subroutine put_example
   end subroutine put_topic

   !> The topic under which a group is explained.
   pure function topic_of(group) result(topic)
      character(len=*), intent(in) :: group
      character(len=8) :: topic

      select case (group)
      case ('pendulum')
         topic = 'scenes'
      case ('output', 'fit', 'sweep')
         topic = group
      case ('event')
         topic = 'output'
      case ('camera')
         topic = 'fit'
      case default
         topic = 'effects'
      end select
   end function topic_of

   pure function columns_text(names) result(text)
      character(len=*), intent(in) :: names(:)
      character(len=:), allocatable :: text
      integer :: i

      text = 'column'//trim(merge('s', ' ', size(names) > 1))//' '//trim(names(1))
      do i = 2, size(names)
         text = text//', '//trim(names(i))
      end do
   end function columns_text

   !> Without the marks of code, which pages of the documentation have.
   pure function without_marks(text) result(plain)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: plain
      integer :: i

      plain = ''
      do i = 1, len(text)
         if (text(i:i) /= '`') plain = plain//text(i:i)
      end do
   end function without_marks

end module kyvadlo_help_topics
