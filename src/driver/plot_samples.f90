!> A picture of a motion, drawn by gnuplot: seen from above, height against time, the path in space. The script and its
!> data are written beside it, with gnuplot or without.
module kyvadlo_plot_samples
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_number_text, only: digits_text
   use kyvadlo_gnuplot, only: draw_picture, folder_of
   use kyvadlo_quoting, only: gnuplot_text, is_printable
   use kyvadlo_run_files, only: add_output, run_files_type
   use kyvadlo_sample_text, only: csv_samples_type, new_csv_samples
   use kyvadlo_samples, only: column_type, sample_sink_type, scene_event_type
   use kyvadlo_standard_io, only: close_output, discard_output, open_output, output_type
   use kyvadlo_status, only: code_file, code_input, error_type, fail
   use kyvadlo_text, only: shown
   implicit none
   private
   public :: plot_samples_type, check_plot, new_plot, finish_plot, discard_plot

   !> Takes the samples that are drawn. It must be a target, and not be copied, between `new_plot` and its end.
   type, extends(sample_sink_type) :: plot_samples_type
      private
      character(len=:), allocatable :: picture               !! File of the picture
      character(len=:), allocatable :: stem                  !! The same without its ending
      character(len=:), allocatable :: title
      type(output_type) :: data
      type(csv_samples_type) :: lines
      integer(int64) :: seen = 0, stride = 1                 !! Of `stride` samples one is drawn
      integer :: place = 0                                   !! Column of x
      real(wp) :: least(4) = huge(1.0_wp), largest(4) = -huge(1.0_wp) !! Of t, x, y, z
   contains
      procedure :: begin => begin_plot
      procedure :: take => take_plot
      procedure :: note => note_plot
   end type plot_samples_type

   !> How the files beside a picture begin: only what begins so is ever replaced.
   character(len=*), parameter :: mark = '# Written by kyvadlo'
   !> So many samples are drawn at most: the points of a large screen, some times over.
   integer(int64), parameter :: most_drawn = 10000

contains

   !> Notes the files of a picture. Errors: an ending other than .svg and .png; a name that cannot be shown.
   subroutine check_plot(picture, title, files, error)
      character(len=*), intent(in) :: picture                !! Path ending in .svg or .png
      character(len=*), intent(in) :: title
      type(run_files_type), intent(inout) :: files
      type(error_type), allocatable, intent(out) :: error
      integer :: stem

      stem = len(picture) - 4
      if (stem > 0) then
         if (picture(stem + 1:) /= '.svg' .and. picture(stem + 1:) /= '.png') stem = 0
      end if
      if (stem <= 0) then
         call fail(error, code_input, "option --plot needs the name of a file that ends in .svg or .png, got '" &
            //shown(picture)//"'")
      else if (.not. is_printable(picture)) then
         call fail(error, code_input, "option --plot needs a name of UTF-8 without control characters, got '"// &
            picture//"'")
      else if (.not. is_printable(title)) then
         call fail(error, code_input, &
            "option --plot: the pendulum's name must be UTF-8 without control characters, got '"//title//"'")
      else
         call add_output(files, 'option --plot', picture)
         call add_output(files, 'the script of option --plot', picture(:stem)//'.gp', mark)
         call add_output(files, 'the data of option --plot', picture(:stem)//'.dat', mark)
      end if
   end subroutine check_plot

   !> Opens the data of a picture that `check_plot` accepted.
   subroutine new_plot(plot, picture, title, samples, error)
      type(plot_samples_type), intent(inout), target :: plot
      character(len=*), intent(in) :: picture, title
      integer(int64), intent(in) :: samples                  !! That will come
      type(error_type), allocatable, intent(out) :: error

      plot%stem = picture(:len(picture) - 4)
      plot%picture = picture
      plot%title = title
      plot%stride = max(1_int64, (samples + most_drawn - 2)/(most_drawn - 1))
      call open_output(plot%data, plot%stem//'.dat', error)
      if (allocated(error)) return
      call plot%data%put(mark//' simulate: the samples that are drawn')
      plot%lines = new_csv_samples(plot%data)
   end subroutine new_plot

   subroutine begin_plot(sink, columns)
      class(plot_samples_type), intent(inout) :: sink
      type(column_type), intent(in) :: columns(:)

      sink%place = findloc(columns%name == 'x', .true., 1)
      call sink%lines%begin([columns(1), columns(sink%place:sink%place + 2)])
   end subroutine begin_plot

   subroutine take_plot(sink, values, goes_on)
      class(plot_samples_type), intent(inout) :: sink
      real(wp), intent(in) :: values(:, :)
      logical, intent(out) :: goes_on
      real(wp), allocatable :: drawn(:, :)
      integer :: first, i

      goes_on = .true.
      ! The first sample of the block whose number is a multiple of the stride.
      first = 1 + int(modulo(-sink%seen, sink%stride))
      sink%seen = sink%seen + size(values, 1)
      if (first > size(values, 1)) return
      allocate (drawn((size(values, 1) - first)/sink%stride + 1, 4))
      drawn(:, 1) = values(first::sink%stride, 1)
      drawn(:, 2:) = values(first::sink%stride, sink%place:sink%place + 2)
      do i = 1, 4
         sink%least(i) = min(sink%least(i), minval(drawn(:, i)))
         sink%largest(i) = max(sink%largest(i), maxval(drawn(:, i)))
      end do
      call sink%lines%take(drawn, goes_on)
   end subroutine take_plot

   !> Events are not drawn, but their places are within the picture.
   subroutine note_plot(sink, event)
      class(plot_samples_type), intent(inout) :: sink
      type(scene_event_type), intent(in) :: event

      sink%least(2:) = min(sink%least(2:), event%position)
      sink%largest(2:) = max(sink%largest(2:), event%position)
   end subroutine note_plot

   !> Gives data and script their names and draws. Error: there is no gnuplot, or it could not draw.
   subroutine finish_plot(plot, error)
      type(plot_samples_type), intent(inout) :: plot
      type(error_type), allocatable, intent(out) :: error
      type(output_type) :: script
      logical :: has_gnuplot

      call close_output(plot%data, error)
      if (.not. allocated(error)) call open_output(script, plot%stem//'.gp', error)
      if (allocated(error)) return
      call write_script(plot, script)
      call close_output(script, error)
      if (allocated(error)) return
      call draw_picture(plot%stem//'.gp', plot%picture, has_gnuplot, error)
      if (.not. has_gnuplot) call fail(error, code_file, 'no picture, as there is no gnuplot; '//plot%stem// &
         '.gp draws it where there is one')
   end subroutine finish_plot

   subroutine discard_plot(plot)
      type(plot_samples_type), intent(inout) :: plot

      call discard_output(plot%data)
   end subroutine discard_plot

   !> The script. Run in its folder it needs no argument.
   subroutine write_script(plot, script)
      type(plot_samples_type), intent(in) :: plot
      type(output_type), intent(inout) :: script
      character(len=:), allocatable :: name, data
      real(wp) :: least(4), largest(4), whole, still

      name = plot%picture(folder_of(plot%picture) + 1:)
      data = plot%stem(folder_of(plot%stem) + 1:)//'.dat'
      call script%put(mark//' simulate. In this folder: gnuplot '//data(:len(data) - 4)//'.gp')
      if (name(len(name) - 3:) == '.svg') then
         call script%put('set terminal svg size 1000,800 font "sans,12" background "white"')
      else
         call script%put('if (strstrt(GPVAL_TERMINALS, "pngcairo") > 0) \')
         call script%put('   set terminal pngcairo size 1000,800 font "sans,10"; else set terminal png size 1000,800')
      end if
      call script%put('set encoding utf8')
      call script%put('set termoption noenhanced')
      ! kyvadlo itself takes the picture from standard output.
      call script%put('if (!exists("page")) set output '//gnuplot_text('./'//name))
      call script%put('set datafile separator ","')
      call script%put('data = '//gnuplot_text('./'//data))
      ! A square from above, the height in its own scale, with margins; something around what does not move.
      least = plot%least
      largest = plot%largest
      whole = maxval(largest(2:3) - least(2:3))
      still = 1e-9_wp*max(maxval(abs(least(2:))), maxval(abs(largest(2:))))
      if (.not. whole > still) whole = max(1e9_wp*still, tiny(whole))
      call widen(least(2), largest(2), whole)
      call widen(least(3), largest(3), whole)
      if (largest(4) - least(4) > still) whole = largest(4) - least(4)
      call widen(least(4), largest(4), whole)
      call script%put('set multiplot title '//gnuplot_text(plot%title))
      call script%put('unset key')
      call script%put('set grid')
      call script%put('# seen from above')
      call script%put('set origin 0, 0.45; set size 0.5, 0.5; set size ratio -1')
      call script%put('set xlabel "x [m]"; set ylabel "y [m]"')
      call script%put('set xrange '//interval(2)//'; set yrange '//interval(3))
      call script%put('plot data using 2:3 skip 2 with lines')
      call script%put('# height')
      call script%put('set origin 0.5, 0.45; set size noratio; set size 0.5, 0.5')
      call script%put('set xlabel "t [s]"; set ylabel "z [m]"')
      call script%put('set xrange '//interval(1)//'; set yrange '//interval(4))
      call script%put('plot data using 1:4 skip 2 with lines')
      call script%put('# in space')
      call script%put('set origin 0.1, -0.03; set size 0.8, 0.55')
      call script%put('set xlabel "x [m]"; set ylabel "y [m]"; set zlabel "z [m]"')
      call script%put('set xrange '//interval(2)//'; set yrange '//interval(3)//'; set zrange '//interval(4))
      call script%put('set view 65, 30, 1.1; set xyplane relative 0; set xtics offset 0, -0.5')
      call script%put('splot data using 2:3:4 skip 2 with lines')
      call script%put('unset multiplot')

   contains

      function interval(i)
         integer, intent(in) :: i
         character(len=:), allocatable :: interval

         interval = '['//digits_text(least(i), 12)//':'//digits_text(largest(i), 12)//']'
      end function interval
   end subroutine write_script

   !> To an extent, and a twentieth of it on both sides.
   pure subroutine widen(least, largest, extent)
      real(wp), intent(inout) :: least, largest
      real(wp), intent(in) :: extent
      real(wp) :: centre

      centre = least + (largest - least)/2
      least = centre - 0.55_wp*extent
      largest = centre + 0.55_wp*extent
   end subroutine widen

end module kyvadlo_plot_samples
