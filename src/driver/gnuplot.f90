!> Pictures drawn by gnuplot. A picture gets its name only when it is whole.
module kyvadlo_gnuplot
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_null_char
   use kyvadlo_run_files, only: is_ordinary_or_new
   use kyvadlo_standard_io, only: close_output, descriptor_of, discard_output, open_output, output_type
   use kyvadlo_status, only: code_file, error_type, fail
   implicit none
   private
   public :: draw_picture, folder_of

   interface
      function kyvadlo_draw(folder, definition, script, picture) bind(c) result(status)
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: folder(*), definition(*), script(*)
         integer(c_int), value :: picture
         integer(c_int) :: status
      end function kyvadlo_draw
      function kyvadlo_is_whole_picture(descriptor, is_png) bind(c) result(is_whole)
         import :: c_int
         integer(c_int), value :: descriptor, is_png
         integer(c_int) :: is_whole
      end function kyvadlo_is_whole_picture
   end interface

contains

   !> Lets gnuplot run a script that writes to standard output where `page` is defined.
   subroutine draw_picture(script, picture, has_gnuplot, error)
      character(len=*), intent(in) :: script            !! Path
      character(len=*), intent(in) :: picture           !! Path that ends in .svg or .png
      logical, intent(out) :: has_gnuplot               !! If not, nothing is drawn
      type(error_type), allocatable, intent(out) :: error
      type(output_type) :: output
      character(len=:), allocatable :: folder, page
      integer(c_int) :: status, is_png

      has_gnuplot = .true.
      if (.not. is_ordinary_or_new(picture)) then
         call fail(error, code_file, 'cannot draw '//picture//': it is no ordinary file')
         return
      end if
      call open_output(output, picture, error)
      if (allocated(error)) return
      page = picture(len(picture) - 2:)
      folder = script(:folder_of(script))
      status = kyvadlo_draw(folder//c_null_char, "page='"//page//"'"//c_null_char, &
         './'//script(len(folder) + 1:)//c_null_char, int(descriptor_of(output), c_int))
      has_gnuplot = status /= -1
      is_png = merge(1_c_int, 0_c_int, page == 'png')
      if (status == 0) then
         if (kyvadlo_is_whole_picture(int(descriptor_of(output), c_int), is_png) == 0) status = 1
      end if
      if (status == 0) then
         call close_output(output, error)
      else
         call discard_output(output)
         if (has_gnuplot) call fail(error, code_file, 'gnuplot could not draw '//picture//' from '//script)
      end if
   end subroutine draw_picture

   !> The length of the folder of a path, with its slash.
   pure integer function folder_of(path)
      character(len=*), intent(in) :: path

      folder_of = index(path, '/', back=.true.)
   end function folder_of

end module kyvadlo_gnuplot
