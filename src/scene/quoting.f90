!> Texts in the quotation marks of CSV, gnuplot and the shell.
module kyvadlo_quoting
   implicit none
   private
   public :: csv_field, gnuplot_text, shell_word

contains

   !> A field of CSV: in quotation marks where it needs them.
   pure function csv_field(text) result(field)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: field

      if (scan(text, ',"'//new_line('a')//achar(13)) == 0) then
         field = text
      else
         field = '"'//replaced(text, '"', '""')//'"'
      end if
   end function csv_field

   !> A text of gnuplot: between single quotation marks, which are doubled inside.
   pure function gnuplot_text(text) result(quoted)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: quoted

      quoted = "'"//replaced(text, "'", "''")//"'"
   end function gnuplot_text

   !> A word that the shell takes as it is: the path of a file, which is no option even if it begins with a dash.
   pure function shell_word(text) result(word)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: word

      word = "'"//replaced(text, "'", "'\''")//"'"
      if (index(text, '-') == 1) word = "'./"//word(2:)
   end function shell_word

   !> Every such letter replaced.
   pure function replaced(text, letter, by) result(new)
      character(len=*), intent(in) :: text, letter, by
      character(len=:), allocatable :: new
      integer :: i

      new = ''
      do i = 1, len(text)
         if (text(i:i) == letter) then
            new = new//by
         else
            new = new//text(i:i)
         end if
      end do
   end function replaced

end module kyvadlo_quoting
