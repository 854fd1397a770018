!> Lines in from standard input, lines out to standard output or a file, with every failure noticed.
!>
!> Fortran's own units will not do: gfortran reports success when a full disk refuses the last block, and cannot say
!> whether reading would wait (answers to a waiting partner must leave before that).
module kyvadlo_standard_io
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_long, c_null_char
   use, intrinsic :: iso_fortran_env, only: error_unit
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_file_text, only: fail_of_system, read_input
   use kyvadlo_quoting, only: visible
   use kyvadlo_text, only: text_sink_type
   implicit none
   private
   public :: output_type, open_output, close_output, discard_output, flush_output, is_on_terminal, get_unfinished_name
   public :: input_type, longest_line, read_line
   public :: become_program, end_program, is_terminal, make_folder, message, prepare_program, terminal_width
   public :: descriptor_of

   integer, parameter :: buffer_size = 65536
   integer, parameter :: standard_output = 1
   integer, parameter :: longest_line = 1048576 !! Of a request; 80 MB without an end of line are no request

   !> Buffered output. What cannot be written ends the program, with a message and status 2, and leaves no unfinished
   !> file: nobody computes for a full disk, and no command need ask.
   type, extends(text_sink_type) :: output_type
      private
      integer(c_int) :: descriptor = standard_output
      integer :: used = 0
      character(kind=c_char, len=:), allocatable :: buffer
      character(len=:), allocatable :: path         !! Not allocated for standard output
   contains
      procedure :: put => put_line_to_output
   end type output_type

   !> Buffered standard input.
   type :: input_type
      private
      character(kind=c_char, len=:), allocatable :: buffer
      integer :: first = 1, last = 0
      logical :: ended = .false.
   end type input_type

   interface
      subroutine c_exit(status) bind(c, name='exit')
         import :: c_int
         integer(c_int), value :: status
      end subroutine c_exit
      subroutine kyvadlo_prepare() bind(c)
      end subroutine kyvadlo_prepare
      subroutine kyvadlo_remove_unfinished() bind(c)
      end subroutine kyvadlo_remove_unfinished
      function kyvadlo_become(name, arguments, count) bind(c) result(status)
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: name(*), arguments(*)
         integer(c_int), value :: count
         integer(c_int) :: status
      end function kyvadlo_become
      function kyvadlo_stack_of_threads() bind(c) result(bytes)
         import :: c_long
         integer(c_long) :: bytes
      end function kyvadlo_stack_of_threads
      function kyvadlo_terminal_width() bind(c) result(columns)
         import :: c_int
         integer(c_int) :: columns
      end function kyvadlo_terminal_width
      function kyvadlo_write(descriptor, bytes, size) bind(c) result(status)
         import :: c_char, c_int, c_long
         integer(c_int), value :: descriptor
         character(kind=c_char), intent(in) :: bytes(*)
         integer(c_long), value :: size
         integer(c_int) :: status
      end function kyvadlo_write
      function kyvadlo_open_file(path, descriptor) bind(c) result(status)
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), intent(inout) :: descriptor
         integer(c_int) :: status
      end function kyvadlo_open_file
      function kyvadlo_finish_file(descriptor) bind(c) result(status)
         import :: c_int
         integer(c_int), value :: descriptor
         integer(c_int) :: status
      end function kyvadlo_finish_file
      function kyvadlo_make_folder(path) bind(c) result(status)
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int) :: status
      end function kyvadlo_make_folder
      subroutine kyvadlo_unfinished_name(descriptor, text, size) bind(c)
         import :: c_char, c_int
         integer(c_int), value :: descriptor, size
         character(kind=c_char), intent(out) :: text(*)
      end subroutine kyvadlo_unfinished_name
      subroutine kyvadlo_discard_file(descriptor) bind(c)
         import :: c_int
         integer(c_int), value :: descriptor
      end subroutine kyvadlo_discard_file
      function kyvadlo_is_terminal(descriptor) bind(c) result(answer)
         import :: c_int
         integer(c_int), value :: descriptor
         integer(c_int) :: answer
      end function kyvadlo_is_terminal
   end interface

contains

   !> Handlers of signals, standard descriptors that are open, and a look at what the system gives us.
   subroutine prepare_program(error)
      type(error_type), allocatable, intent(out) :: error
      !> The threads of `simulate` take 64 KiB at most.
      integer(c_long), parameter :: least_stack = 131072
      integer(c_long) :: stack
      character(len=32) :: text

      call kyvadlo_prepare()
      stack = kyvadlo_stack_of_threads()
      if (stack == 0 .or. stack >= least_stack) return
      write (text, '(i0)') stack
      call fail(error, code_input, 'OMP_STACKSIZE gives a thread '//trim(text)// &
         ' bytes; it needs 131072 (128k) or more')
   end subroutine prepare_program

   !> Ends the program. (`stop` prints its code; gfortran 11 cannot be told not to.)
   subroutine end_program(status)
      integer, intent(in) :: status

      flush (error_unit)
      call c_exit(int(status, c_int))
   end subroutine end_program

   !> Is this file descriptor (0, 1, 2) a terminal?
   logical function is_terminal(descriptor)
      integer, intent(in) :: descriptor

      is_terminal = kyvadlo_is_terminal(int(descriptor, c_int)) /= 0
   end function is_terminal

   !> Columns of the terminal that standard error is.
   integer function terminal_width()

      terminal_width = int(kyvadlo_terminal_width())
   end function terminal_width

   !> One line on standard error. Control characters, of names for example, are shown and not sent to the terminal.
   subroutine message(text)
      character(len=*), intent(in) :: text

      write (error_unit, '(a)') visible(text)
      ! What is said before a long run is read before it, in a file or a pipe too.
      flush (error_unit)
   end subroutine message

   !> Goes on as another program with the same arguments, one that lies beside this and is linked with more libraries:
   !> those take longer to load than most commands to run. Comes back only with an error.
   subroutine become_program(name, what, error)
      character(len=*), intent(in) :: name                    !! From the folder of this program
      character(len=*), intent(in) :: what                    !! Is done there, for the message
      type(error_type), allocatable, intent(out) :: error
      character(kind=c_char, len=:), allocatable :: arguments, argument
      integer :: i, length, status

      arguments = ''
      do i = 0, command_argument_count()
         call get_command_argument(i, length=length)
         if (allocated(argument)) deallocate (argument)
         allocate (character(kind=c_char, len=length) :: argument)
         call get_command_argument(i, argument)
         arguments = arguments//argument//c_null_char
      end do
      status = int(kyvadlo_become(name//c_null_char, arguments, int(command_argument_count() + 1, c_int)))
      call fail_of_system(error, what//': cannot run the program '//name//' beside this one', status)
   end subroutine become_program

   !> Makes a folder, unless it is there already; the folder it lies in must be there.
   subroutine make_folder(path, error)
      character(len=*), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      integer(c_int) :: status

      status = kyvadlo_make_folder(path//c_null_char)
      if (status /= 0) call fail_of_system(error, 'cannot make the folder '//path, int(status))
   end subroutine make_folder

   !> Opens standard output (no path, or `-`) or a file. The file gets its name only in `close_output`.
   subroutine open_output(output, path, error)
      type(output_type), intent(out) :: output
      character(len=*), intent(in) :: path                    !! Empty or `-`: standard output
      type(error_type), allocatable, intent(out) :: error
      integer(c_int) :: status

      allocate (character(kind=c_char, len=buffer_size) :: output%buffer)
      if (path == '' .or. path == '-') return
      output%path = path
      status = kyvadlo_open_file(path//c_null_char, output%descriptor)
      if (status /= 0) call fail_of_system(error, 'cannot write '//path, int(status))
   end subroutine open_output

   !> The number under which the system knows the output.
   integer function descriptor_of(output)
      type(output_type), intent(in) :: output

      descriptor_of = int(output%descriptor)
   end function descriptor_of

   subroutine put_line_to_output(sink, line)
      class(output_type), intent(inout) :: sink
      character(len=*), intent(in) :: line

      call put_bytes(sink, line)
      call put_bytes(sink, new_line('a'))
   end subroutine put_line_to_output

   subroutine put_bytes(output, bytes)
      class(output_type), intent(inout) :: output
      character(len=*), intent(in) :: bytes
      integer :: first, count

      first = 1
      do while (first <= len(bytes))
         if (output%used == buffer_size) call flush_output(output)
         count = min(buffer_size - output%used, len(bytes) - first + 1)
         output%buffer(output%used + 1:output%used + count) = bytes(first:first + count - 1)
         output%used = output%used + count
         first = first + count
      end do
   end subroutine put_bytes

   !> Hands everything over to the system.
   subroutine flush_output(output)
      class(output_type), intent(inout) :: output
      integer(c_int) :: status

      status = 0
      if (output%used > 0) status = kyvadlo_write(output%descriptor, output%buffer, int(output%used, c_long))
      output%used = 0
      if (status /= 0) call end_with_failure(output, status)
   end subroutine flush_output

   !> Ends the program because of a write that failed.
   subroutine end_with_failure(output, status)
      class(output_type), intent(in) :: output
      integer(c_int), intent(in) :: status
      type(error_type), allocatable :: error

      call kyvadlo_remove_unfinished()
      if (allocated(output%path)) then
         call fail_of_system(error, 'cannot write '//output%path, int(status))
      else
         call fail_of_system(error, 'cannot write to standard output', int(status))
      end if
      call message('kyvadlo: '//error%message)
      call end_program(2)
   end subroutine end_with_failure

   !> The name under which a file is written until it is whole, for who opens it by name; empty for a device or pipe.
   subroutine get_unfinished_name(output, name)
      type(output_type), intent(in) :: output
      character(len=:), allocatable, intent(out) :: name
      integer, parameter :: longest = 4096
      character(kind=c_char, len=longest) :: buffer

      call kyvadlo_unfinished_name(output%descriptor, buffer, int(longest, c_int))
      name = buffer(:index(buffer, c_null_char) - 1)
   end subroutine get_unfinished_name

   !> Whether what is written shows on a terminal.
   logical function is_on_terminal(output)
      type(output_type), intent(in) :: output

      is_on_terminal = is_terminal(int(output%descriptor))
   end function is_on_terminal

   !> Ends the output; a file appears under its name now, whole, or not at all.
   subroutine close_output(output, error)
      type(output_type), intent(inout) :: output
      type(error_type), allocatable, intent(out) :: error
      integer(c_int) :: status

      call flush_output(output)
      if (.not. allocated(output%path)) return
      status = kyvadlo_finish_file(output%descriptor)
      if (status /= 0) call fail_of_system(error, 'cannot write '//output%path, int(status))
   end subroutine close_output

   !> Drops what has not left yet, and the unfinished file.
   subroutine discard_output(output)
      type(output_type), intent(inout) :: output

      output%used = 0
      if (allocated(output%path)) call kyvadlo_discard_file(output%descriptor)
   end subroutine discard_output

   !> The next line of standard input, without its end. Before waiting for input, `output` is flushed.
   subroutine read_line(input, output, line, ended, is_cut, error)
      type(input_type), intent(inout) :: input
      type(output_type), intent(inout) :: output
      character(len=:), allocatable, intent(out) :: line !! At most `longest_line` bytes
      logical, intent(out) :: ended                      !! No line is left
      logical, intent(out) :: is_cut                     !! The line was longer
      type(error_type), allocatable, intent(out) :: error
      integer :: last, count

      ended = .false.
      is_cut = .false.
      if (.not. allocated(input%buffer)) allocate (character(kind=c_char, len=buffer_size) :: input%buffer)
      line = ''
      do
         last = index(input%buffer(input%first:input%last), new_line('a'))
         if (last > 0) then
            call take(input%first + last - 2)
            input%first = input%first + last
            return
         end if
         call take(input%last)
         input%first = 1
         input%last = 0
         if (.not. input%ended) then
            call flush_output(output)
            count = read_input(0, input%buffer)
            if (count < 0) then
               call fail_of_system(error, 'cannot read standard input', -count)
               ended = .true.
               return
            end if
            input%last = count
            input%ended = count == 0
         end if
         if (input%ended) then
            ended = len(line) == 0
            return
         end if
      end do

   contains

      !> Adds what the line may still take of the buffer.
      subroutine take(last)
         integer, intent(in) :: last
         integer :: count

         count = min(last - input%first + 1, longest_line - len(line))
         is_cut = is_cut .or. count < last - input%first + 1
         line = line//input%buffer(input%first:input%first + count - 1)
      end subroutine take
   end subroutine read_line

end module kyvadlo_standard_io
