!> Lines in from standard input, lines out to standard output or a file, with every failure noticed.
!>
!> Fortran's own units will not do: gfortran reports success when a full disk refuses the last block, and cannot say
!> whether reading would wait (answers to a waiting partner must leave before that).
module kyvadlo_standard_io
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_long, c_null_char
   use, intrinsic :: iso_fortran_env, only: error_unit
   use kyvadlo_status, only: code_file, error_type, fail
   use kyvadlo_text, only: text_sink_type
   implicit none
   private
   public :: output_type, open_output, close_output, discard_output, flush_output, has_failed, is_on_terminal, unfinished_name
   public :: input_type, read_line
   public :: end_program, is_terminal, make_folder, message, set_signals

   integer, parameter :: buffer_size = 65536
   integer, parameter :: standard_output = 1

   !> Buffered output. Errors are kept; `close_output` reports the first.
   type, extends(text_sink_type) :: output_type
      private
      integer(c_int) :: descriptor = standard_output
      integer(c_int) :: status = 0                  !! First errno, or 0
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
      subroutine kyvadlo_set_signals() bind(c)
      end subroutine kyvadlo_set_signals
      function kyvadlo_read_input(buffer, size) bind(c) result(count)
         import :: c_char, c_long
         character(kind=c_char), intent(out) :: buffer(*)
         integer(c_long), value :: size
         integer(c_long) :: count
      end function kyvadlo_read_input
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
      subroutine kyvadlo_describe(number, text, size) bind(c)
         import :: c_char, c_int
         integer(c_int), value :: number, size
         character(kind=c_char), intent(out) :: text(*)
      end subroutine kyvadlo_describe
      function kyvadlo_is_terminal(descriptor) bind(c) result(answer)
         import :: c_int
         integer(c_int), value :: descriptor
         integer(c_int) :: answer
      end function kyvadlo_is_terminal
   end interface

contains

   !> A closed pipe ends the program quietly; an interrupt removes an unfinished file.
   subroutine set_signals()
      call kyvadlo_set_signals()
   end subroutine set_signals

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

   !> One line on standard error.
   subroutine message(text)
      character(len=*), intent(in) :: text

      write (error_unit, '(a)') text
      ! What is said before a long run is read before it, in a file or a pipe too.
      flush (error_unit)
   end subroutine message

   !> Makes a folder, unless it is there already; the folder it lies in must be there.
   subroutine make_folder(path, error)
      character(len=*), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      integer(c_int) :: status

      status = kyvadlo_make_folder(path//c_null_char)
      if (status /= 0) call fail(error, code_file, 'cannot make the folder '//path//': '//system_words(status))
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
      if (status /= 0) call fail(error, code_file, 'cannot write '//path//': '//system_words(status))
   end subroutine open_output

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

      if (output%used > 0 .and. output%status == 0) &
         output%status = kyvadlo_write(output%descriptor, output%buffer, int(output%used, c_long))
      output%used = 0
   end subroutine flush_output

   !> Whether something could not be written: what follows would be lost too.
   logical function has_failed(output)
      type(output_type), intent(in) :: output

      has_failed = output%status /= 0
   end function has_failed

   !> The name under which a file is written until it is whole, for who opens it by name; empty for a device or pipe.
   function unfinished_name(output) result(name)
      type(output_type), intent(in) :: output
      character(len=:), allocatable :: name
      integer, parameter :: longest = 4096
      character(kind=c_char, len=longest) :: buffer

      call kyvadlo_unfinished_name(output%descriptor, buffer, int(longest, c_int))
      name = buffer(:index(buffer, c_null_char) - 1)
   end function unfinished_name

   !> Whether what is written shows on a terminal.
   logical function is_on_terminal(output)
      type(output_type), intent(in) :: output

      is_on_terminal = is_terminal(int(output%descriptor))
   end function is_on_terminal

   !> Ends the output; a file appears under its name now, whole, or not at all.
   subroutine close_output(output, error)
      type(output_type), intent(inout) :: output
      type(error_type), allocatable, intent(out) :: error

      call flush_output(output)
      if (allocated(output%path)) then
         if (output%status /= 0) then
            call kyvadlo_discard_file(output%descriptor)
         else
            output%status = kyvadlo_finish_file(output%descriptor)
         end if
         if (output%status /= 0) &
            call fail(error, code_file, 'cannot write '//output%path//': '//system_words(output%status))
      else if (output%status /= 0) then
         call fail(error, code_file, 'cannot write to standard output: '//system_words(output%status))
      end if
   end subroutine close_output

   !> Drops what has not left yet, and the unfinished file.
   subroutine discard_output(output)
      type(output_type), intent(inout) :: output

      output%used = 0
      if (allocated(output%path)) call kyvadlo_discard_file(output%descriptor)
   end subroutine discard_output

   !> The next line of standard input, without its end. Before waiting for input, `output` is flushed.
   subroutine read_line(input, output, line, ended, error)
      type(input_type), intent(inout) :: input
      type(output_type), intent(inout) :: output
      character(len=:), allocatable, intent(out) :: line
      logical, intent(out) :: ended                      !! No line is left
      type(error_type), allocatable, intent(out) :: error
      integer(c_long) :: count
      integer :: at

      ended = .false.
      if (.not. allocated(input%buffer)) allocate (character(kind=c_char, len=buffer_size) :: input%buffer)
      line = ''
      do
         at = index(input%buffer(input%first:input%last), new_line('a'))
         if (at > 0) then
            line = line//input%buffer(input%first:input%first + at - 2)
            input%first = input%first + at
            return
         end if
         line = line//input%buffer(input%first:input%last)
         input%first = 1
         input%last = 0
         if (.not. input%ended) then
            call flush_output(output)
            count = kyvadlo_read_input(input%buffer, int(buffer_size, c_long))
            if (count < 0) then
               call fail(error, code_file, 'cannot read standard input: '//system_words(int(-count, c_int)))
               ended = .true.
               return
            end if
            input%last = int(count)
            input%ended = count == 0
         end if
         if (input%ended) then
            ended = len(line) == 0
            return
         end if
      end do
   end subroutine read_line

   function system_words(number) result(words)
      integer(c_int), intent(in) :: number
      character(len=:), allocatable :: words
      integer, parameter :: longest = 256
      character(kind=c_char, len=longest) :: buffer

      call kyvadlo_describe(number, buffer, int(longest, c_int))
      words = buffer(:index(buffer, c_null_char) - 1)
   end function system_words

end module kyvadlo_standard_io
