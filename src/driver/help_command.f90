!> The commands `help` and `examples`.
module kyvadlo_help_command
   use kyvadlo_command_line, only: arguments_type, write_help
   use kyvadlo_commands, only: commands
   use kyvadlo_example_scenes, only: example_names, write_example
   use kyvadlo_help_pages, only: topic_words
   use kyvadlo_help_topics, only: has_topic, topics, write_topic
   use kyvadlo_standard_io, only: close_output, open_output, output_type
   use kyvadlo_status, only: code_file, code_input, error_type, fail
   use kyvadlo_text, only: shown, text_sink_type
   implicit none
   private
   public :: examples_command, help_command

   !> Keeps all lines.
   type, extends(text_sink_type) :: whole_type
      character(len=:), allocatable :: text
   contains
      procedure :: put => keep_all
   end type whole_type

contains

   subroutine help_command(arguments, error)
      type(arguments_type), intent(in) :: arguments
      type(error_type), allocatable, intent(out) :: error
      type(output_type) :: output
      character(len=:), allocatable :: topic
      integer :: i

      topic = ''
      if (size(arguments%operands) > 1) then
         call fail(error, code_input, 'help takes one TOPIC')
      else if (size(arguments%operands) == 1) then
         topic = arguments%operands(1)%text
         if (.not. has_topic(topic) .and. .not. (any(commands%name == topic) .and. topic /= '')) &
            call fail(error, code_input, "unknown topic '"// &
            shown(topic)//"'; the topics are "//with_commas(topic_words()))
      end if
      if (.not. allocated(error)) call open_output(output, '', error)
      if (allocated(error)) return
      if (topic == '') then
         call write_help(output, '')
         call output%put('')
         call output%put('Topics of kyvadlo help:')
         do i = 1, size(topics)
            if (has_topic(trim(topics(i)%name))) call output%put('  '//topics(i)%name//'  '//trim(topics(i)%summary))
         end do
      else
         if (any(commands%name == topic)) call write_help(output, topic)
         if (any(commands%name == topic) .and. has_topic(topic)) call output%put('')
         if (has_topic(topic)) call write_topic(output, topic)
      end if
      call close_output(output, error)
   end subroutine help_command

   subroutine examples_command(arguments, error)
      type(arguments_type), intent(in) :: arguments
      type(error_type), allocatable, intent(out) :: error
      type(output_type) :: output
      type(whole_type) :: whole
      character(len=:), allocatable :: name, path
      integer :: i, j
      logical :: is_there

      if (size(arguments%operands) > 2) call fail(error, code_input, 'examples takes NAME and FILE at most')
      if (allocated(error)) return
      if (size(arguments%operands) == 0) then
         call open_output(output, '', error)
         if (allocated(error)) return
         do i = 1, size(example_names)
            if (allocated(whole%text)) deallocate (whole%text)
            call write_example(whole, i)
            call output%put(example_names(i)(:len_trim_of_names())//'  '// &
               sentence(whole%text(:index(whole%text, new_line('a')) - 1)))
         end do
         call close_output(output, error)
         return
      end if
      name = arguments%operands(1)%text
      i = findloc(example_names == name .or. example_names == name//'.nml', .true., 1)
      if (i == 0) then
         call fail(error, code_input, "no example '"//shown(name)//"'; kyvadlo examples lists them")
         return
      end if
      path = without_folder(i)
      if (size(arguments%operands) == 2) path = arguments%operands(2)%text
      call copy_example(i, path, error)
      if (allocated(error) .or. path == '-') return
      ! The tables that a scene reads lie beside it.
      call write_example(whole, i)
      do j = 1, size(example_names)
         name = without_folder(j)
         if (index(name, '.txt') == 0 .or. index(whole%text, name) == 0) cycle
         name = path(:index(path, '/', back=.true.))//name
         inquire (file=name, exist=is_there)
         if (.not. is_there) call copy_example(j, name, error)
         if (allocated(error)) return
      end do
   end subroutine examples_command

   !> Writes an example into a file that is not there, or to standard output, `-`.
   subroutine copy_example(i, path, error)
      integer, intent(in) :: i
      character(len=*), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      type(output_type) :: output
      logical :: is_there

      inquire (file=path, exist=is_there)
      if (path /= '-' .and. is_there) call fail(error, code_file, shown(path)//' is there already; name another FILE')
      if (.not. allocated(error)) call open_output(output, path, error)
      if (allocated(error)) return
      call write_example(output, i)
      call close_output(output, error)
   end subroutine copy_example

   pure function without_folder(i) result(name)
      integer, intent(in) :: i
      character(len=:), allocatable :: name

      name = trim(example_names(i))
      name = name(index(name, '/') + 1:)
   end function without_folder

   subroutine keep_all(sink, line)
      class(whole_type), intent(inout) :: sink
      character(len=*), intent(in) :: line

      if (.not. allocated(sink%text)) sink%text = ''
      sink%text = sink%text//line//new_line(line)
   end subroutine keep_all

   !> The first sentence of a comment, which no initial ends; what goes on over lines is cut.
   pure function sentence(line) result(text)
      character(len=*), intent(in) :: line
      character(len=:), allocatable :: text
      integer :: last

      text = line(3:)
      do last = 3, len(text) - 1
         if (text(last:last + 1) == '. ' .and. text(last - 2:last - 2) /= ' ') exit
      end do
      if (last < len(text)) text = text(:last)
      if (text(len(text):) /= '.') text = text//' ...'
   end function sentence

   pure integer function len_trim_of_names() result(length)
      length = maxval(len_trim(example_names))
   end function len_trim_of_names

   pure function with_commas(words) result(text)
      character(len=*), intent(in) :: words
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, len(words)
         if (words(i:i) == ' ') text = text//','
         text = text//words(i:i)
      end do
   end function with_commas

end module kyvadlo_help_command
