!> Texts in the quotation marks of CSV, gnuplot and the shell.
module kyvadlo_quoting
   implicit none
   private
   public :: csv_field, gnuplot_text, shell_word

   !> Where one of these stands in it a field of CSV needs quotation marks.
   character(len=*), parameter :: special = ',"'//achar(10)//achar(13)

contains

   pure integer function replaced_length(text, letter, by) result(length)
      character(len=*), intent(in) :: text, letter, by
      integer :: i

      length = len(text)
      do i = 1, len(text)
         if (text(i:i) == letter) length = length + len(by) - 1
      end do
   end function replaced_length

   !> A field of CSV: in quotation marks where it needs them.
   pure function csv_field(text) result(field)
      character(len=*), intent(in) :: text
      character(len=merge(len(text), 2 + replaced_length(text, '"', '""'), scan(text, special) == 0)) :: field

      field = text
      if (scan(text, special) > 0) field = '"'//replaced(text, '"', '""')//'"'
   end function csv_field

   !> A text of gnuplot: between single quotation marks, which are doubled inside.
   pure function gnuplot_text(text) result(quoted)
      character(len=*), intent(in) :: text
      character(len=2 + replaced_length(text, "'", "''")) :: quoted

      quoted = "'"//replaced(text, "'", "''")//"'"
   end function gnuplot_text

   !> A word that the shell takes as it is: the path of a file, which is no option even if it begins with a dash.
   pure function shell_word(text) result(word)
      character(len=*), intent(in) :: text
      character(len=2*merge(2, 1, index(text, '-') == 1) + replaced_length(text, "'", "'\''")) :: word

      word = "'"//trim(merge('./', '  ', index(text, '-') == 1))//replaced(text, "'", "'\''")//"'"
   end function shell_word

   !> Every such letter replaced.
   pure function replaced(text, letter, by) result(new)
      character(len=*), intent(in) :: text, letter, by
      character(len=replaced_length(text, letter, by)) :: new
      integer :: i, at

      at = 1
      do i = 1, len(text)
         if (text(i:i) == letter) then
            new(at:at + len(by) - 1) = by
            at = at + len(by)
         else
            new(at:at) = text(i:i)
            at = at + 1
         end if
      end do
   end function replaced

end module kyvadlo_quoting
