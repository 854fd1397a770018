!> Small text operations that the scene reader and the program share.
module kyvadlo_text
   use, intrinsic :: iso_fortran_env, only: int64
   implicit none
   private
   public :: text_type, text_sink_type, counting_sink_type, append, integer_text, integer_length, join, lower_case, &
      shown, shown_length, split_words

   !> A text of any length, so that arrays of texts may have elements of different length.
   type :: text_type
      character(len=:), allocatable :: text
   end type text_type

   !> Something that takes lines of text in order: a file, standard output.
   type, abstract :: text_sink_type
   contains
      procedure(put_line), deferred :: put !! Takes one line, without its end
   end type text_sink_type

   !> Drops the lines and counts what they take.
   type, extends(text_sink_type) :: counting_sink_type
      integer(int64) :: bytes = 0          !! Ends of lines included
   contains
      procedure :: put => count_line
   end type counting_sink_type

   abstract interface
      subroutine put_line(sink, line)
         import :: text_sink_type
         class(text_sink_type), intent(inout) :: sink
         character(len=*), intent(in) :: line
      end subroutine put_line
   end interface

   integer, parameter :: longest = 60   !! Bytes of a text that `shown` leaves uncut
   character(len=*), parameter :: tabulator = achar(9), carriage_return = achar(13)

contains

   subroutine count_line(sink, line)
      class(counting_sink_type), intent(inout) :: sink
      character(len=*), intent(in) :: line

      sink%bytes = sink%bytes + len(line) + 1
   end subroutine count_line

   !> Adds one text at the end. (An array constructor with `text_type(...)` in it leaks memory in gfortran 12.)
   pure subroutine append(texts, text)
      type(text_type), allocatable, intent(inout) :: texts(:) !! Unallocated counts as empty
      character(len=*), intent(in) :: text
      type(text_type), allocatable :: longer(:)
      integer :: n

      n = 0
      if (allocated(texts)) n = size(texts)
      allocate (longer(n + 1))
      if (n > 0) longer(:n) = texts
      longer(n + 1)%text = text
      call move_alloc(longer, texts)
   end subroutine append

   !> What an integer takes, its sign included.
   pure integer function integer_length(value) result(length)
      integer, intent(in) :: value
      integer :: rest

      length = merge(2, 1, value < 0)
      rest = value/10
      do while (rest /= 0)
         rest = rest/10
         length = length + 1
      end do
   end function integer_length

   !> An integer without blanks.
   pure function integer_text(value) result(text)
      integer, intent(in) :: value
      character(len=integer_length(value)) :: text

      write (text, '(i0)') value
   end function integer_text

   !> ASCII letters in lower case; every other byte unchanged.
   pure function lower_case(text) result(lower)
      character(len=*), intent(in) :: text
      character(len=len(text)) :: lower
      integer :: i

      do i = 1, len(text)
         if (text(i:i) >= 'A' .and. text(i:i) <= 'Z') then
            lower(i:i) = achar(iachar(text(i:i)) + 32)
         else
            lower(i:i) = text(i:i)
         end if
      end do
   end function lower_case

   pure integer function joined_length(words, separator) result(length)
      type(text_type), intent(in) :: words(:)
      character(len=*), intent(in) :: separator
      integer :: i

      length = max(0, size(words) - 1)*len(separator)
      do i = 1, size(words)
         length = length + len(words(i)%text)
      end do
   end function joined_length

   !> Words separated by a separator.
   pure function join(words, separator) result(text)
      type(text_type), intent(in) :: words(:)
      character(len=*), intent(in) :: separator
      character(len=joined_length(words, separator)) :: text
      integer :: i, at

      at = 0
      do i = 1, size(words)
         text(at + 1:) = words(i)%text//separator
         at = at + len(words(i)%text) + len(separator)
      end do
   end function join

   pure integer function shown_length(text) result(length)
      character(len=*), intent(in) :: text

      length = len(text)
      if (length <= longest) return
      length = longest
      ! A UTF-8 character is not cut in two: its following bytes are 10xxxxxx.
      do while (length > 1 .and. iand(iachar(text(length + 1:length + 1)), 192) == 128)
         length = length - 1
      end do
      length = length + len('...')
   end function shown_length

   !> A text made fit for a one-line message: cut after 60 bytes, control characters as `?`.
   pure function shown(text)
      character(len=*), intent(in) :: text
      character(len=shown_length(text)) :: shown
      integer :: i

      shown = text
      if (len(text) > longest) shown(len(shown) - 2:) = '...'
      do i = 1, len(shown)
         if (iachar(shown(i:i)) < 32 .or. iachar(shown(i:i)) == 127) shown(i:i) = '?'
      end do
   end function shown

   !> First and last positions of the words of a line. Blanks, tabulators and carriage returns separate words.
   pure subroutine split_words(line, first, last, count)
      character(len=*), intent(in) :: line
      integer, allocatable, intent(out) :: first(:), last(:) !! Positions of the first and last byte of each word
      integer, intent(out) :: count                          !! Number of words
      integer :: i
      logical :: inside

      allocate (first((len(line) + 1)/2 + 1), last((len(line) + 1)/2 + 1))
      count = 0
      inside = .false.
      do i = 1, len(line)
         if (line(i:i) == ' ' .or. line(i:i) == tabulator .or. line(i:i) == carriage_return) then
            inside = .false.
         else
            if (.not. inside) then
               count = count + 1
               first(count) = i
            end if
            last(count) = i
            inside = .true.
         end if
      end do
   end subroutine split_words

end module kyvadlo_text
