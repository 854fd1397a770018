!> Fortran namelist text as a list of groups, each with its names, values as text, and line numbers.
!>
!> Native namelist reading knows neither the line of an error nor the name it did not understand, and drops what it does
!> not know between groups. Here every byte is accounted for. Read as in Fortran: `&name ... /` (or `&end`),
!> `name = value`, several values separated by commas, blanks or line ends, `r*value`, `name(i) = value`,
!> `name(i:j) = values`, texts in ' or ", comments from ! to the end of the line, remarks behind the end of a group up
!> to the end of its line, upper and lower case alike. Not accepted: empty values, other text outside groups, complex
!> numbers.
module kyvadlo_namelist_file
   use kyvadlo_file_text, only: file_name, read_file
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: integer_length, integer_text, lower_case, shown, shown_length, text_type
   implicit none
   private
   public :: value_type, entry_type, group_type, read_groups, parse_groups, place_of

   type :: value_type
      character(len=:), allocatable :: text
      logical :: quoted = .false.          !! Given as 'text'
      integer :: line = 0
   end type value_type

   type :: entry_type
      character(len=:), allocatable :: name  !! Lower case
      integer :: first = 0, last = 0         !! i and j of name(i) or name(i:j); 0: none
      integer :: line = 0
      type(value_type), allocatable :: values(:)
   end type entry_type

   type :: group_type
      character(len=:), allocatable :: file  !! For messages
      character(len=:), allocatable :: name  !! Lower case
      integer :: line = 0
      type(entry_type), allocatable :: entries(:)
   end type group_type

   !> Where the parser stands.
   type :: cursor_type
      character(len=:), allocatable :: file
      integer :: at = 1
      integer :: line = 1
   end type cursor_type

   !> More values of a name, or names in a group, no scene has.
   integer, parameter :: most_values = 100, most_names = 1000
   character(len=*), parameter :: line_feed = achar(10), carriage_return = achar(13), tabulator = achar(9)
   character(len=*), parameter :: name_characters = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_'

contains

   !> `file:line: ` for messages.
   pure function place_of(file, line) result(text)
      character(len=*), intent(in) :: file
      integer, intent(in) :: line
      character(len=len(file) + 3 + integer_length(line)) :: text

      text = file//':'//integer_text(line)//': '
   end function place_of

   !> Reads the groups of a file. Errors: a file that cannot be read, is empty or binary; the syntax errors of
   !> `parse_groups`.
   subroutine read_groups(path, groups, error)
      character(len=*), intent(in) :: path                           !! `-`: standard input
      type(group_type), allocatable, intent(out) :: groups(:)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text

      allocate (groups(0))
      call read_file(path, text, error)
      if (allocated(error)) return
      call parse_groups(text, file_name(path), groups, error)
   end subroutine read_groups

   !> The groups of a text, in order.
   pure subroutine parse_groups(text, file, groups, error)
      character(len=*), intent(in) :: text
      character(len=*), intent(in) :: file                           !! Name for messages
      type(group_type), allocatable, intent(out) :: groups(:)
      type(error_type), allocatable, intent(out) :: error
      type(cursor_type) :: cursor
      type(group_type), allocatable :: more(:)
      integer :: i, count

      count = 0
      allocate (groups(4))
      cursor%file = file
      if (len(text) >= 3) then
         ! UTF-8 byte order mark
         if (all([ichar(text(1:1)), ichar(text(2:2)), ichar(text(3:3))] == [239, 187, 191])) cursor%at = 4
      end if
      do i = cursor%at, len(text)
         if (iachar(text(i:i)) < 32 .and. scan(text(i:i), line_feed//carriage_return//tabulator//achar(12)) == 0) then
            call fail(error, code_input, place_of(file, line_of(text, i))//'not a text file (byte ' &
               //integer_text(iachar(text(i:i)))//')')
            return
         end if
      end do
      do
         call skip_blanks(text, cursor)
         if (cursor%at > len(text)) exit
         if (text(cursor%at:cursor%at) /= '&') then
            call refuse(error, cursor, 'only groups (&name ... /) and comments (! ...) are expected, ' &
               //'got '//quoted(text(cursor%at:line_end(text, cursor%at)))//trim(unit_note(text, cursor%at)))
            return
         end if
         if (count == size(groups)) then
            allocate (more(2*count))
            more(:count) = groups
            call move_alloc(more, groups)
         end if
         count = count + 1
         call parse_group(text, cursor, groups(count), error)
         if (allocated(error)) return
      end do
      groups = groups(:count)
   end subroutine parse_groups

   !> Of `9.81 m/s2` the slash has ended the group: what to say, blank elsewhere.
   pure function unit_note(text, at) result(note)
      character(len=*), intent(in) :: text
      integer, intent(in) :: at                        !! Where no group begins
      character(len=48) :: note

      note = ''
      if (at <= 2) return
      if (text(at - 1:at - 1) == '/' .and. is_letter(text(at - 2:at - 2)) .and. is_letter(text(at:at))) &
         note = '; a slash ends a group: units are not written'
   end function unit_note

   pure logical function is_letter(c)
      character(len=1), intent(in) :: c

      is_letter = c >= 'a' .and. c <= 'z' .or. c >= 'A' .and. c <= 'Z'
   end function is_letter

   !> From `&name` to its `/`.
   pure subroutine parse_group(text, cursor, group, error)
      character(len=*), intent(in) :: text
      type(cursor_type), intent(inout) :: cursor
      type(group_type), intent(out) :: group
      type(error_type), allocatable, intent(out) :: error
      type(entry_type), allocatable :: entries(:), more(:)
      integer :: last, count

      group%file = cursor%file
      group%line = cursor%line
      count = 0
      allocate (entries(8))
      last = end_of_name(text, cursor%at + 1)
      group%name = lower_case(text(cursor%at + 1:last))
      if (group%name == '') then
         call refuse(error, cursor, '& must be followed by the name of a group, got ' &
            //quoted(text(cursor%at:line_end(text, cursor%at))))
         return
      end if
      cursor%at = last + 1
      do
         call skip_blanks(text, cursor)
         if (cursor%at <= len(text)) then
            if (text(cursor%at:cursor%at) == '/') then
               cursor%at = cursor%at + 1
               call skip_remark(text, cursor)
               exit
            end if
            if (text(cursor%at:cursor%at) == ',') then
               cursor%at = cursor%at + 1
               cycle
            end if
            if (text(cursor%at:cursor%at) == '&') then
               last = end_of_name(text, cursor%at + 1)
               if (lower_case(text(cursor%at + 1:last)) == 'end') then
                  cursor%at = last + 1
                  exit
               end if
            end if
         end if
         if (cursor%at > len(text)) then
            call fail(error, code_input, place_of(group%file, group%line)//'group &'//shown(group%name) &
               //' has no end (/)')
            return
         else if (text(cursor%at:cursor%at) == '&') then
            call refuse(error, cursor, quoted(text(cursor%at:last))//' begins before group &' &
               //shown(group%name)//' of line '//integer_text(group%line)//' has its end (/)')
            return
         end if
         if (count == most_names) then
            call refuse(error, cursor, 'group &'//shown(group%name)//' has more than '//integer_text(most_names)// &
               ' names')
            return
         else if (count == size(entries)) then
            allocate (more(2*count))
            more(:count) = entries
            call move_alloc(more, entries)
         end if
         count = count + 1
         call parse_entry(text, cursor, entries(count), error)
         if (allocated(error)) return
      end do
      group%entries = entries(:count)
   end subroutine parse_group

   !> Behind the end of a group: what is left of the line, up to a comment or another group. Without a blank before it,
   !> it may be a part of a value (`gravity = 9.8/2`), and is left to be complained of.
   pure subroutine skip_remark(text, cursor)
      character(len=*), intent(in) :: text
      type(cursor_type), intent(inout) :: cursor
      integer :: i

      if (scan(text(cursor%at:min(cursor%at, len(text))), ' '//tabulator) == 0) return
      do i = cursor%at, len(text)
         select case (text(i:i))
         case (line_feed, carriage_return, '!')
            exit
         case ('&')
            if (end_of_name(text, i + 1) > i) exit
         end select
      end do
      cursor%at = i
   end subroutine skip_remark

   pure subroutine append_value(values, value)
      type(value_type), allocatable, intent(inout) :: values(:)
      type(value_type), intent(in) :: value
      type(value_type), allocatable :: more(:)

      allocate (more(size(values) + 1))
      more(:size(values)) = values
      more(size(more)) = value
      call move_alloc(more, values)
   end subroutine append_value

   !> `name = value, value ...`, `name(i) = value` or `name(i:j) = value, value ...`
   pure subroutine parse_entry(text, cursor, entry, error)
      character(len=*), intent(in) :: text
      type(cursor_type), intent(inout) :: cursor
      type(entry_type), intent(out) :: entry
      type(error_type), allocatable, intent(out) :: error
      integer :: next, line

      entry%line = cursor%line
      allocate (entry%values(0))
      call match_name(text, cursor%at, cursor%line, entry, next, line)
      if (next == 0) then
         call refuse(error, cursor, 'expected `name = value`, got ' &
            //quoted(text(cursor%at:line_end(text, cursor%at))))
         return
      end if
      cursor%at = next
      cursor%line = line
      call parse_values(text, cursor, entry, error)
   end subroutine parse_entry

   !> Does `name =`, `name(i) =` or `name(i:j) =` stand at `at`? Then `next` is the place behind the equals sign, else
   !> 0.
   pure subroutine match_name(text, at, at_line, entry, next, line)
      character(len=*), intent(in) :: text
      integer, intent(in) :: at, at_line
      type(entry_type), intent(inout) :: entry
      integer, intent(out) :: next, line
      type(cursor_type) :: cursor
      integer :: last, status, close, colon

      next = 0
      line = at_line
      last = end_of_name(text, at)
      if (last < at) return
      if (text(at:at) >= '0' .and. text(at:at) <= '9') return
      cursor%at = last + 1
      cursor%line = at_line
      call skip_blanks(text, cursor)
      if (cursor%at > len(text)) return
      if (text(cursor%at:cursor%at) == '(') then
         close = cursor%at - 1 + index(text(cursor%at:min(len(text), cursor%at + 24)), ')')
         if (close < cursor%at) return
         colon = cursor%at + index(text(cursor%at + 1:close), ':')
         if (verify(text(cursor%at + 1:close - 1), '0123456789 :') /= 0) return
         if (colon == cursor%at) then
            read (text(cursor%at + 1:close - 1), *, iostat=status) entry%first
         else
            read (text(cursor%at + 1:colon - 1), *, iostat=status) entry%first
            if (status == 0) read (text(colon + 1:close - 1), *, iostat=status) entry%last
            if (entry%last < entry%first) status = 1
         end if
         if (status /= 0 .or. entry%first < 1) return
         cursor%at = close + 1
         call skip_blanks(text, cursor)
         if (cursor%at > len(text)) return
      end if
      if (text(cursor%at:cursor%at) /= '=') return
      next = cursor%at + 1
      line = cursor%line
      entry%name = lower_case(text(at:last))
   end subroutine match_name

   !> The values up to the next name or the end of the group.
   pure subroutine parse_values(text, cursor, entry, error)
      character(len=*), intent(in) :: text
      type(cursor_type), intent(inout) :: cursor
      type(entry_type), intent(inout) :: entry
      type(error_type), allocatable, intent(out) :: error
      type(entry_type) :: following
      integer :: next, line, star, repeat_count, i
      logical :: after_comma
      type(value_type) :: value

      after_comma = .true.
      do
         call skip_blanks(text, cursor)
         if (cursor%at > len(text)) exit
         select case (text(cursor%at:cursor%at))
         case ('/', '&')
            exit
         case (',')
            if (after_comma) then
               call refuse(error, cursor, shown(entry%name)//': a value is missing before the comma')
               return
            end if
            after_comma = .true.
            cursor%at = cursor%at + 1
            cycle
         case ('''', '"')
            call parse_text(text, cursor, value, error)
            if (allocated(error)) return
            call append_value(entry%values, value)
         case default
            call match_name(text, cursor%at, cursor%line, following, next, line)
            if (next > 0) exit
            call parse_word(text, cursor, value)
            if (value%text == '') then
               call refuse(error, cursor, shown(entry%name)//': unexpected ' &
                  //quoted(text(cursor%at:line_end(text, cursor%at))))
               return
            end if
            star = index(value%text, '*')
            repeat_count = 1
            if (star > 1 .and. star <= 6) then
               if (verify(value%text(:star - 1), '0123456789') == 0) then
                  read (value%text(:star - 1), '(i5)') repeat_count
                  value%text = value%text(star + 1:)
                  if (value%text == '' .or. repeat_count == 0) then
                     call refuse(error, cursor, shown(entry%name) &
                        //': a value and a count are needed in r*value')
                     return
                  end if
               end if
            end if
            if (size(entry%values) + repeat_count > most_values) then
               call refuse(error, cursor, shown(entry%name)//': more than ' &
                  //integer_text(most_values)//' values')
               return
            end if
            do i = 1, repeat_count
               call append_value(entry%values, value)
            end do
         end select
         after_comma = .false.
      end do
      if (size(entry%values) == 0) &
         call fail(error, code_input, place_of(cursor%file, entry%line)//shown(entry%name)//': no value behind =')
   end subroutine parse_values

   !> 'text' or "text"; a quotation mark inside is doubled. It ends on its line.
   pure subroutine parse_text(text, cursor, value, error)
      character(len=*), intent(in) :: text
      type(cursor_type), intent(inout) :: cursor
      type(value_type), intent(out) :: value
      type(error_type), allocatable, intent(out) :: error
      character(len=1) :: mark
      integer :: i, last, run, doubled

      mark = text(cursor%at:cursor%at)
      value%quoted = .true.
      value%line = cursor%line
      doubled = 0
      last = cursor%at
      do
         run = scan(text(last + 1:), mark//line_feed//carriage_return)
         last = last + run
         if (run == 0) exit
         if (text(last:last) /= mark) exit
         if (index(text(last + 1:min(last + 1, len(text))), mark) == 1) then
            doubled = doubled + 1
            last = last + 1
            cycle
         end if
         allocate (character(len=last - cursor%at - 1 - doubled) :: value%text)
         do i = 1, len(value%text)
            cursor%at = cursor%at + 1
            value%text(i:i) = text(cursor%at:cursor%at)
            if (text(cursor%at:cursor%at) == mark) cursor%at = cursor%at + 1
         end do
         cursor%at = last + 1
         return
      end do
      call refuse(error, cursor, 'the text '//shown(text(cursor%at:line_end(text, cursor%at))) &
         //' has no closing '//mark//' on its line')
   end subroutine parse_text

   !> Anything else: up to a blank, comma, slash, comment or sign that cannot be part of a value.
   pure subroutine parse_word(text, cursor, value)
      character(len=*), intent(in) :: text
      type(cursor_type), intent(inout) :: cursor
      type(value_type), intent(out) :: value
      integer :: length

      length = scan(text(cursor%at:), ' ,/!&=''"()'//tabulator//line_feed//carriage_return//achar(12)) - 1
      if (length < 0) length = len(text) - cursor%at + 1
      value%text = text(cursor%at:cursor%at + length - 1)
      value%line = cursor%line
      cursor%at = cursor%at + length
   end subroutine parse_word

   !> Over blanks, line ends and comments.
   pure subroutine skip_blanks(text, cursor)
      character(len=*), intent(in) :: text
      type(cursor_type), intent(inout) :: cursor
      integer :: length

      do while (cursor%at <= len(text))
         select case (text(cursor%at:cursor%at))
         case (' ', tabulator, carriage_return, achar(12))
            continue
         case (line_feed)
            cursor%line = cursor%line + 1
         case ('!')
            length = index(text(cursor%at:), line_feed) - 1
            if (length < 0) length = len(text) - cursor%at + 1
            cursor%at = cursor%at + length
            cycle
         case default
            return
         end select
         cursor%at = cursor%at + 1
      end do
   end subroutine skip_blanks

   !> Last place of the name that begins at `first`; `first - 1` if there is none.
   pure integer function end_of_name(text, first) result(last)
      character(len=*), intent(in) :: text
      integer, intent(in) :: first

      last = first - 1
      do while (last < len(text))
         if (scan(text(last + 1:last + 1), name_characters) == 0) exit
         last = last + 1
      end do
   end function end_of_name

   !> Last place of the line, blanks at its end left out.
   pure integer function line_end(text, at) result(last)
      character(len=*), intent(in) :: text
      integer, intent(in) :: at

      last = scan(text(at:), line_feed//carriage_return) + at - 2
      if (last < at - 1) last = len(text)
      last = at - 1 + len_trim(text(at:last))
   end function line_end

   pure integer function line_of(text, at) result(line)
      character(len=*), intent(in) :: text
      integer, intent(in) :: at
      integer :: i

      line = 1
      do i = 1, at - 1
         if (text(i:i) == line_feed) line = line + 1
      end do
   end function line_of

   !> An error where the parser stands.
   pure subroutine refuse(error, cursor, message)
      type(error_type), allocatable, intent(out) :: error
      type(cursor_type), intent(in) :: cursor
      character(len=*), intent(in) :: message

      call fail(error, code_input, place_of(cursor%file, cursor%line)//message)
   end subroutine refuse

   pure function quoted(text)
      character(len=*), intent(in) :: text
      character(len=2 + shown_length(text)) :: quoted

      quoted = "'"//shown(text)//"'"
   end function quoted

end module kyvadlo_namelist_file
