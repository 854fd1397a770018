!> A picture of a motion, drawn by gnuplot: seen from above, height against time, the path in space, where a string is
!> slack in another colour. The script and its data are written beside it, with gnuplot or without.
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
   use kyvadlo_text, only: integer_text, shown
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
      logical :: is_slack = .false., was_slack = .false.     !! Now, and ever
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
      call sink%lines%begin([columns(1), columns(sink%place:sink%place + 2), column_type('slack', '1', '1 in flight')])
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
      allocate (drawn((size(values, 1) - first)/sink%stride + 1, 5))
      drawn(:, 1) = values(first::sink%stride, 1)
      drawn(:, 2:4) = values(first::sink%stride, sink%place:sink%place + 2)
      drawn(:, 5) = merge(1, 0, sink%is_slack)
      do i = 1, 4
         sink%least(i) = min(sink%least(i), minval(drawn(:, i)))
         sink%largest(i) = max(sink%largest(i), maxval(drawn(:, i)))
      end do
      call sink%lines%take(drawn, goes_on)
   end subroutine take_plot

   !> An event of a string ends a line, and begins one in the other colour.
   subroutine note_plot(sink, event)
      class(plot_samples_type), intent(inout) :: sink
      type(scene_event_type), intent(in) :: event
      real(wp) :: ends(2, 5)
      logical :: goes_on

      if (event%request > 0) return
      ends(:, 1) = event%time
      ends(:, 2:4) = spread(event%position, 1, 2)
      ends(1, 5) = merge(1, 0, sink%is_slack)
      sink%is_slack = event%what == 'slack' .or. event%what == 'rebound'
      sink%was_slack = sink%was_slack .or. sink%is_slack
      ends(2, 5) = merge(1, 0, sink%is_slack)
      call sink%lines%take(ends, goes_on)
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
      real(wp) :: least(4), largest(4), whole, across, still, low, high

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
      call script%put('set multiplot title '//gnuplot_text(plot%title)//' font ",14"')
      call script%put('unset key')
      call script%put('set grid')
      call script%put('set tics nomirror')
      call script%put('set style line 1 lc rgb "#1f5fa8" lw 1.3; set style line 2 lc rgb "#d2521c" lw 1.8')
      call script%put('# taut, and slack: the bob flies')
      call script%put('taut(c) = column(5) == 0 ? column(c) : NaN; slack(c) = column(5) == 0 ? NaN : column(c)')
      call script%put('# seen from above')
      across = largest(2) - least(2)
      call script%put('set xtics '//step(across)//'; set ytics '//step(across))
      call script%put('set format x '//format(2, across)//'; set format y '//format(3, across))
      call script%put('set origin 0, 0.47; set size 0.5, 0.47; set size ratio -1')
      call script%put('set xlabel "x [m]"; set ylabel "y [m]"')
      call script%put('set xrange '//interval(2)//'; set yrange '//interval(3))
      call draw('plot', '2:3', '2:(taut(3))', '2:(slack(3))')
      call script%put('# height')
      call script%put('set origin 0.5, 0.47; set size noratio; set size 0.5, 0.47')
      call script%put('set xtics autofreq; set ytics autofreq; set format x; set format y '// &
         format(4, largest(4) - least(4)))
      if (plot%was_slack) call script%put('set key top right outside horizontal samplen 2')
      call script%put('set xlabel "t [s]"; set ylabel "z [m]"')
      call script%put('set xrange '//interval(1)//'; set yrange '//interval(4))
      call draw('plot', '1:4', '1:(taut(4))', '1:(slack(4))')
      call script%put('unset key')
      call script%put('# in space')
      call script%put('set origin 0, -0.06; set size 1, 0.6')
      call script%put('set xlabel "x [m]" offset 0, -0.7; set ylabel "y [m]" offset 1, -0.7; set zlabel "z [m]" '// &
         'rotate by 90 offset '//integer_text(min(-1, 5 - figures(4, across)))//', 0')
      ! One scale for all three: a flat motion gets room for the numbers of its axis.
      low = plot%least(4)
      high = plot%largest(4)
      whole = largest(2) - least(2)
      if (high - low < 0.3_wp*whole) then
         low = (low + high)/2 - 0.15_wp*whole
         high = low + 0.3_wp*whole
      end if
      least(4) = low
      largest(4) = high
      call script%put('set xrange '//interval(2)//'; set yrange '//interval(3)//'; set zrange '//interval(4))
      ! As large as its height, seen from 25 degrees above, lets it be.
      call script%put('set view equal xyz; set view 65, 30, '//trim(digits_text(1.36_wp/(0.5_wp + 0.9_wp* &
         (high - low)/whole), 3))//'; set xyplane relative 0')
      call script%put('set xtics '//step(whole)//' offset 0, -0.4; set ytics '//step(whole)// &
         ' offset 0.8, -0.1; set ztics '//step(whole))
      call script%put('set format x '//format(2, across)//'; set format y '//format(3, across)//'; set format z '// &
         format(4, whole))
      call draw('splot', '2:3:4', '2:3:(taut(4))', '2:3:(slack(4))')
      call script%put('unset multiplot')

   contains

      !> 1, 2 or 5 times a power of ten: about a fourth of an extent.
      function step(extent)
         real(wp), intent(in) :: extent
         character(len=:), allocatable :: step
         real(wp) :: power, part

         power = 10.0_wp**floor(log10(extent/4))
         part = extent/4/power
         step = trim(digits_text(power*merge(5.0_wp, merge(2.0_wp, 1.0_wp, part >= 2), part >= 5), 3))
      end function step

      !> Figures that tell the numbers of an axis apart.
      integer function figures(i, extent)
         integer, intent(in) :: i
         real(wp), intent(in) :: extent

         figures = max(6, 3 + ceiling(log10(max(abs(least(i)), abs(largest(i)))/extent)))
      end function figures

      function format(i, extent)
         integer, intent(in) :: i
         real(wp), intent(in) :: extent
         character(len=:), allocatable :: format

         format = '"%.'//integer_text(figures(i, extent))//'g"'
      end function format

      subroutine draw(how, columns, taut, slack)
         character(len=*), intent(in) :: how, columns, taut, slack
         character(len=:), allocatable :: goes_on

         goes_on = ''
         if (plot%was_slack) goes_on = ', \'
         call script%put(how//' data using '//taut//' skip 2 with lines ls 1 title "taut", \')
         ! Where it starts: of a bob at rest all there is.
         call script%put('   data using '//columns//' skip 2 every ::0::0 with points pt 7 ps 0.7 lc rgb "black" '// &
            'notitle'//goes_on)
         if (plot%was_slack) call script%put('   data using '//slack//' skip 2 with lines ls 2 title "slack"')
      end subroutine draw

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
