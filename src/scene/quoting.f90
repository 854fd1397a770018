!> Texts and names as CSV, gnuplot and a terminal may see them: the one place that knows what is dangerous to whom.
module kyvadlo_quoting
   implicit none
   private
   public :: csv_field, gnuplot_text, is_printable, visible

   character(len=*), parameter :: hexadecimal = '0123456789abcdef'

contains

   !> Whether a spreadsheet would compute it: it begins like a formula and is no number.
   pure logical function is_formula(text)
      character(len=*), intent(in) :: text
      integer :: exponent

      is_formula = .false.
      if (len(text) < 2) return
      if (scan(text(:1), '=+-@') == 0) return
      exponent = scan(text, 'eE')
      if (exponent == 0) exponent = len(text) + 1
      is_formula = scan(text(:1), '=@') > 0 .or. verify(text(2:exponent - 1), '0123456789.') > 0 .or. exponent == 2
      if (exponent < len(text)) is_formula = is_formula .or. verify(text(exponent + 2:), '0123456789') > 0 .or. &
         verify(text(exponent + 1:exponent + 1), '+-0123456789') > 0
   end function is_formula

   pure integer function csv_length(text) result(length)
      character(len=*), intent(in) :: text
      integer :: i

      length = len(text)
      if (scan(text, ',"'//new_line('a')//achar(13)) == 0 .and. .not. is_formula(text)) return
      length = len(text) + 2
      do i = 1, len(text)
         if (text(i:i) == '"') length = length + 1
      end do
   end function csv_length

   !> A field of CSV: in quotation marks where it needs them, and where a spreadsheet would take it for a formula.
   pure function csv_field(text) result(field)
      character(len=*), intent(in) :: text
      character(len=csv_length(text)) :: field
      integer :: i, last

      if (len(field) == len(text)) then
         field = text
         return
      end if
      field(1:1) = '"'
      last = 1
      do i = 1, len(text)
         last = last + 1
         field(last:last) = text(i:i)
         if (text(i:i) /= '"') cycle
         last = last + 1
         field(last:last) = '"'
      end do
      field(last + 1:) = '"'
   end function csv_field

   pure integer function gnuplot_length(text) result(length)
      character(len=*), intent(in) :: text
      integer :: i

      length = 2
      do i = 1, len(text)
         length = length + merge(1, 4, is_harmless(iachar(text(i:i))))
      end do
   end function gnuplot_length

   !> A text of gnuplot. Whatever is no letter, digit or harmless mark is written as its number: gnuplot looks for
   !> commands in backquotes, variables and quotation marks before it looks at the text.
   pure function gnuplot_text(text) result(quoted)
      character(len=*), intent(in) :: text
      character(len=gnuplot_length(text)) :: quoted
      integer :: i, last, code

      quoted(1:1) = '"'
      last = 1
      do i = 1, len(text)
         code = iachar(text(i:i))
         if (is_harmless(code)) then
            last = last + 1
            quoted(last:last) = text(i:i)
         else
            quoted(last + 1:last + 4) = '\'//achar(48 + code/64)//achar(48 + modulo(code/8, 8))// &
               achar(48 + modulo(code, 8))
            last = last + 4
         end if
      end do
      quoted(last + 1:) = '"'
   end function gnuplot_text

   !> A byte of a UTF-8 letter, or one of ASCII that has no meaning between gnuplot's quotation marks.
   pure logical function is_harmless(code)
      integer, intent(in) :: code

      is_harmless = code >= 128 .or. &
         index('abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 ./,:;-_+()=', achar(code)) > 0
   end function is_harmless

   pure integer function visible_length(text) result(length)
      character(len=*), intent(in) :: text
      integer :: i

      length = 0
      do i = 1, len(text)
         length = length + 1
         if (is_control(iachar(text(i:i)))) length = length + merge(1, 3, iachar(text(i:i)) == 10)
      end do
   end function visible_length

   !> A text for a terminal: control characters as \n or \x1b.
   pure function visible(text) result(shown)
      character(len=*), intent(in) :: text
      character(len=visible_length(text)) :: shown
      integer :: i, last, code

      last = 0
      do i = 1, len(text)
         code = iachar(text(i:i))
         if (.not. is_control(code)) then
            last = last + 1
            shown(last:last) = text(i:i)
         else if (code == 10) then
            shown(last + 1:last + 2) = '\n'
            last = last + 2
         else
            shown(last + 1:last + 4) = '\x'//hexadecimal(code/16 + 1:code/16 + 1)// &
               hexadecimal(modulo(code, 16) + 1:modulo(code, 16) + 1)
            last = last + 4
         end if
      end do
   end function visible

   pure logical function is_control(code)
      integer, intent(in) :: code

      is_control = code < 32 .or. code == 127
   end function is_control

   !> Whether a text is UTF-8 without control characters: what a picture can show.
   pure logical function is_printable(text)
      character(len=*), intent(in) :: text
      integer :: i, code, following, point

      is_printable = .false.
      i = 1
      do while (i <= len(text))
         code = iachar(text(i:i))
         if (is_control(code)) return
         following = 0
         if (code >= 128) then
            following = 1
            if (code >= 224) following = 2
            if (code >= 240) following = 3
            if (code < 194 .or. code > 244 .or. i + following > len(text)) return
            point = iand(code, 2**(6 - following) - 1)
            do code = i + 1, i + following
               if (iand(iachar(text(code:code)), 192) /= 128) return
               point = 64*point + iand(iachar(text(code:code)), 63)
            end do
            ! Longer than need be, a half of UTF-16, beyond Unicode, a control character of Latin-1.
            if (point < 160 .or. following == 2 .and. point < 2048 .or. following == 3 .and. point < 65536) return
            if (point >= 55296 .and. point < 57344 .or. point > 1114111) return
         end if
         i = i + following + 1
      end do
      is_printable = .true.
   end function is_printable

end module kyvadlo_quoting
