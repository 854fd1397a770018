!> A whole file as one text.
module kyvadlo_file_text
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_long, c_null_char
   use kyvadlo_status, only: code_file, code_input, error_type, fail
   implicit none
   private
   public :: fail_of_system, file_name, read_file, read_input

   interface
      function kyvadlo_open_input(path) bind(c) result(descriptor)
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int) :: descriptor
      end function kyvadlo_open_input
      function kyvadlo_read_input(descriptor, buffer, size) bind(c) result(count)
         import :: c_char, c_int, c_long
         integer(c_int), value :: descriptor
         character(kind=c_char), intent(out) :: buffer(*)
         integer(c_long), value :: size
         integer(c_long) :: count
      end function kyvadlo_read_input
      subroutine kyvadlo_close_input(descriptor) bind(c)
         import :: c_int
         integer(c_int), value :: descriptor
      end subroutine kyvadlo_close_input
      subroutine kyvadlo_describe(number, text, size) bind(c)
         import :: c_char, c_int
         integer(c_int), value :: number, size
         character(kind=c_char), intent(out) :: text(*)
      end subroutine kyvadlo_describe
   end interface

   integer, parameter :: largest = 2**26 !! Bytes

contains

   pure integer function name_length(path)
      character(len=*), intent(in) :: path

      name_length = len(path)
      if (path == '-') name_length = len('standard input')
   end function name_length

   !> A path as messages name it.
   pure function file_name(path) result(name)
      character(len=*), intent(in) :: path
      character(len=name_length(path)) :: name

      name = path
      if (path == '-') name = 'standard input'
   end function file_name

   !> All bytes of a file. Errors: it cannot be read, is empty, or larger than 64 MiB.
   subroutine read_file(path, text, error)
      character(len=*), intent(in) :: path             !! `-`: standard input
      character(len=:), allocatable, intent(out) :: text
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: larger
      integer(c_int) :: descriptor
      integer :: length, count

      descriptor = 0
      if (path /= '-') descriptor = kyvadlo_open_input(path//c_null_char)
      count = min(descriptor, 0_c_int)
      length = 0
      allocate (character(len=65536) :: text)
      do while (count >= 0)
         count = read_input(int(descriptor), text(length + 1:))
         if (count <= 0) exit
         length = length + count
         if (length < len(text)) cycle
         if (length >= largest) exit
         allocate (character(len=2*length) :: larger)
         larger(:length) = text
         call move_alloc(larger, text)
      end do
      if (descriptor > 0) call kyvadlo_close_input(descriptor)
      text = text(:length)
      if (count < 0) then
         call fail_of_system(error, 'cannot read '//file_name(path), -count)
      else if (length >= largest) then
         call fail(error, code_file, file_name(path)//': larger than 64 MiB; a scene is a short text')
      else if (length == 0) then
         call fail(error, code_input, file_name(path)//': the file is empty')
      end if
   end subroutine read_file

   !> Reads what is there, at most the buffer full, into a buffer: how many bytes, 0 at the end, a negative errno on
   !> failure.
   integer function read_input(descriptor, buffer) result(count)
      integer, intent(in) :: descriptor                !! 0: standard input
      character(len=*), intent(inout) :: buffer

      count = int(kyvadlo_read_input(int(descriptor, c_int), buffer, len(buffer, c_long)))
   end function read_input

   !> `What: the system's words`.
   subroutine fail_of_system(error, what, number)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: what
      integer, intent(in) :: number                    !! Errno
      integer, parameter :: longest = 256
      character(kind=c_char, len=longest) :: buffer

      call kyvadlo_describe(int(number, c_int), buffer, int(longest, c_int))
      call fail(error, code_file, what//': '//buffer(:index(buffer, c_null_char) - 1))
   end subroutine fail_of_system

end module kyvadlo_file_text
