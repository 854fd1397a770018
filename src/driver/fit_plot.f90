!> A picture of a fit, drawn by gnuplot: for each measured column the data and the model's curve over the first periods,
!> and all residuals. The script and its data are written beside it, with gnuplot or without.
module kyvadlo_fit_plot
   use kyvadlo_fit_data, only: column_amplitude, column_names, column_period, column_u, &
      column_v, column_tension, column_z, is_angle, is_event
   use kyvadlo_fit_model, only: measurement_type, model_type, predict, use_until
   use kyvadlo_fit_physics, only: unit_period
   use kyvadlo_fit_request, only: fit_request_type
   use kyvadlo_fit_result, only: fit_result_type
   use kyvadlo_gnuplot, only: draw_picture, folder_of
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_number_text, only: digits_text, shortest_text
   use kyvadlo_quoting, only: gnuplot_text
   use kyvadlo_scene_groups, only: pendulum_group, setting_place
   use kyvadlo_standard_io, only: close_output, open_output, output_type
   use kyvadlo_status, only: code_file, error_type, fail
   use kyvadlo_text, only: integer_text
   implicit none
   private
   public :: plot_fit

   character(len=*), parameter :: mark = '# Written by kyvadlo fit'
   real(wp), parameter :: degree = acos(-1.0_wp)/180
   !> Points of a curve, and residuals of a column that are drawn at most.
   integer, parameter :: curve_points = 500, most_drawn = 5000
   !> So many periods can be told from each other in a panel.
   real(wp), parameter :: periods_shown = 6

contains

   !> Writes script and data, and draws. Error: there is no gnuplot, or it could not draw.
   subroutine plot_fit(result, request, picture, error)
      type(fit_result_type), intent(in) :: result
      type(fit_request_type), intent(in) :: request
      character(len=*), intent(in) :: picture                !! Path that `check_plot` accepted
      type(error_type), allocatable, intent(out) :: error
      type(output_type) :: data, script
      character(len=:), allocatable :: stem
      logical :: has_gnuplot, is_seen(column_period)
      real(wp) :: until
      integer :: j

      stem = picture(:len(picture) - 4)
      is_seen = [(any(result%model%all(result%model%used)%column == j), j=1, column_period)]
      until = end_of_panel(result)
      call open_output(data, stem//'.dat', error)
      if (allocated(error)) return
      call data%put(mark//': for each column what was measured (place, value, sigma), the curve of the model (place,')
      call data%put('# value), residuals (place, sigmas), after two empty lines each')
      do j = 1, column_period
         if (is_seen(j)) call put_column(result, request, j, until, data)
      end do
      call close_output(data, error)
      if (.not. allocated(error)) call open_output(script, stem//'.gp', error)
      if (allocated(error)) return
      call put_script(result, request, picture, is_seen, until, script)
      call close_output(script, error)
      if (allocated(error)) return
      call draw_picture(stem//'.gp', picture, has_gnuplot, error)
      if (.not. has_gnuplot) call fail(error, code_file, 'no picture, as there is no gnuplot; '//stem// &
         '.gp draws it where there is one')
   end subroutine plot_fit

   !> The last time whose data are drawn; all of it where there are few periods.
   real(wp) function end_of_panel(result) result(until)
      type(fit_result_type), intent(in) :: result
      real(wp) :: first, last, period

      associate (all => result%model%all)
         first = minval(all%time, all%time > -huge(first))
         last = maxval(all%time, all%time > -huge(first))
      end associate
      period = 2*acos(-1.0_wp)*sqrt(result%number(1, setting_place(pendulum_group, 'length'))/result%number(1, &
         setting_place(pendulum_group, 'gravity')))
      until = last
      if (last - first > 2*periods_shown*period) until = first + periods_shown*period
   end function end_of_panel

   !> Where a measured number is drawn: at its time; an event at its number, a period at its amplitude.
   real(wp) function place_of(one, unit, number) result(place)
      type(measurement_type), intent(in) :: one
      real(wp), intent(in) :: unit                           !! Of angles
      integer, intent(in) :: number

      place = one%time
      if (is_event(one%column)) place = number
      if (one%column == column_period) place = one%amplitude*unit
   end function place_of

   !> The three blocks of a column. Of events what is drawn is the time since the one before.
   subroutine put_column(result, request, column, until, data)
      type(fit_result_type), intent(in) :: result
      type(fit_request_type), intent(in) :: request
      integer, intent(in) :: column
      real(wp), intent(in) :: until
      type(output_type), intent(inout) :: data
      integer, allocatable :: mine(:)
      real(wp) :: unit, angle_unit
      integer :: i, stride

      associate (m => result%model)
         mine = pack([(i, i=1, size(m%used))], m%all(m%used)%column == column)
         angle_unit = 1
         if (request%in_degrees) angle_unit = 1/degree
         unit = 1
         if (is_angle(column)) unit = angle_unit
         do i = 1, size(mine)
            associate (one => m%all(m%used(mine(i))))
               if (is_event(column)) then
                  if (i > 1) call put([place_of(one, angle_unit, i), one%value - m%all(m%used(mine(i - 1)))%value, &
                     one%sigma])
               else if (.not. one%time > until) then
                  call put([place_of(one, angle_unit, i), one%value*unit, one%sigma*unit])
               end if
            end associate
         end do
         call end_block()
         if (is_event(column)) then
            do i = 2, size(mine)
               call put([real(i, wp), result%predicted(mine(i)) - result%predicted(mine(i - 1))])
            end do
         else if (column == column_period) then
            call put_periods(m%all(m%used(mine)), result%predicted(mine(1)))
         else
            call put_curve(m, m%all(m%used(mine)))
         end if
         call end_block()
         stride = (size(mine) - 1)/most_drawn + 1
         do i = 1, size(mine), stride
            call put([place_of(m%all(m%used(mine(i))), angle_unit, i), result%residual(mine(i))])
         end do
         call end_block()
      end associate

   contains

      subroutine put(values)
         real(wp), intent(in) :: values(:)
         character(len=:), allocatable :: line
         integer :: i

         line = shortest_text(values(1))
         do i = 2, size(values)
            line = line//' '//shortest_text(values(i))
         end do
         call data%put(line)
      end subroutine put

      subroutine end_block()
         call data%put('')
         call data%put('')
      end subroutine end_block

      !> Periods over amplitudes from 0 on: all are one number times that of a pendulum of unit length and gravity.
      subroutine put_periods(of, first)
         type(measurement_type), intent(in) :: of(:)
         real(wp), intent(in) :: first
         real(wp) :: amplitude
         integer :: i

         do i = 0, curve_points
            amplitude = max(1e-3_wp, 1.05_wp*maxval(abs(of%amplitude))*i/curve_points)
            call put([amplitude*angle_unit, first*unit_period(amplitude)/unit_period(of(1)%amplitude)])
         end do
      end subroutine put_periods

      !> The column at evenly spaced times, as the model says: as if it had been measured there.
      subroutine put_curve(model, of)
         type(model_type), intent(in) :: model
         type(measurement_type), intent(in) :: of(:)
         type(model_type) :: dense
         real(wp) :: h(curve_points), rates(curve_points), first, last
         logical :: failed
         integer :: i, j

         dense = model
         if (allocated(dense%time_sigma)) deallocate (dense%time_sigma, dense%delay)
         deallocate (dense%all)
         allocate (dense%all(curve_points))
         first = of(1)%time
         last = min(until, of(size(of))%time)
         j = 1
         do i = 1, curve_points
            dense%all(i)%column = column
            dense%all(i)%row = i
            dense%all(i)%time = first + (last - first)*(i - 1)/(curve_points - 1)
            ! Angles are counted from the measured ones.
            do while (j < size(of) - 1)
               if (of(j + 1)%time > dense%all(i)%time) exit
               j = j + 1
            end do
            dense%all(i)%value = of(j)%value
            if (size(of) > 1) dense%all(i)%value = of(j)%value + (of(j + 1)%value - of(j)%value)* &
               (dense%all(i)%time - of(j)%time)/(of(j + 1)%time - of(j)%time)
         end do
         call use_until(dense, huge(1.0_wp), 1)
         rates = 0
         call predict(dense, result%x, h, failed, rates)
         if (failed) return
         do i = 1, curve_points
            call put([dense%all(i)%time, h(i)*unit])
         end do
      end subroutine put_curve
   end subroutine put_column

   !> The script. Run in its folder it needs no argument.
   subroutine put_script(result, request, picture, is_seen, until, script)
      type(fit_result_type), intent(in) :: result
      type(fit_request_type), intent(in) :: request
      character(len=*), intent(in) :: picture
      logical, intent(in) :: is_seen(:)
      real(wp), intent(in) :: until
      type(output_type), intent(inout) :: script
      character(len=:), allocatable :: name, data, place, title
      character(len=20) :: unit
      integer :: j, row, rows

      name = picture(folder_of(picture) + 1:)
      data = name(:len(name) - 4)//'.dat'
      rows = count(is_seen)
      call script%put(mark//'. In this folder: gnuplot '//data(:len(data) - 4)//'.gp')
      if (name(len(name) - 3:) == '.svg') then
         call script%put('set terminal svg size 1000,'//integer_text(60 + 290*rows)// &
            ' font "sans,12" background "white"')
      else
         call script%put('if (strstrt(GPVAL_TERMINALS, "pngcairo") > 0) \')
         call script%put('   set terminal pngcairo size 1000,'//integer_text(60 + 290*rows)// &
            ' font "sans,10"; else set terminal png size 1000,'//integer_text(60 + 290*rows))
      end if
      call script%put('set encoding utf8')
      call script%put('set termoption noenhanced')
      ! kyvadlo itself takes the picture from standard output.
      call script%put('if (!exists("page")) set output '//gnuplot_text('./'//name))
      call script%put('data = '//gnuplot_text('./'//data))
      title = request%pendulum%name
      if (title /= '') title = title//': '
      if (.not. result%is_converged) title = title//'no minimum, '
      title = title//'chi2/dof = '//digits_text(result%chi2, 5)//'/'//integer_text(result%dof)
      call script%put('set multiplot layout '//integer_text(rows)//',2 title '//gnuplot_text(title))
      call script%put('set grid; set key above; set autoscale xfix; set errorbars 0')
      call script%put('set offsets graph 0.02, graph 0.02, graph 0.05, graph 0.05')
      row = 0
      do j = 1, column_period
         if (.not. is_seen(j)) cycle
         unit = unit_of(j, request%in_degrees)
         place = 't [s]'
         if (is_event(j)) place = 'number of the event'
         if (j == column_period) place = 'amplitude ['//trim(unit_of(column_amplitude, request%in_degrees))//']'
         call script%put('# '//trim(column_names(j)))
         call script%put('set xlabel "'//place//'"')
         title = trim(column_names(j))
         if (is_event(j)) title = title//' since the one before'
         call script%put('set ylabel "'//title//' ['//trim(unit)//']"')
         title = 'model'
         if (j < column_period .and. until < maxval(result%model%all%time) .and. .not. is_event(j)) &
            title = 'model (the first periods)'
         call script%put('plot data index '//integer_text(3*row + 1)// &
            ' using 1:2 with lines lw 1.5 lc rgb "#d95f02" title "'//title//'", \')
         call script%put('   data index '//integer_text(3*row)// &
            ' using 1:2:3 with yerrorbars pt 7 ps 0.4 lc rgb "#1b4f72" title "measured"')
         call script%put('set ylabel "residual of '//trim(column_names(j))//' [sigmas]"')
         call script%put('plot data index '//integer_text(3*row + 2)// &
            ' using 1:(0) with lines lc rgb "#d95f02" notitle, \')
         call script%put('   data index '//integer_text(3*row + 2)// &
            ' using 1:2 with points pt 7 ps 0.4 lc rgb "#1b4f72" title "measured - model"')
         row = row + 1
      end do
      call script%put('unset multiplot')
   end subroutine put_script

   !> Of a column, for a label.
   pure function unit_of(column, in_degrees) result(unit)
      integer, intent(in) :: column
      logical, intent(in) :: in_degrees
      character(len=20) :: unit

      select case (column)
      case (:column_z)
         unit = 'm'
      case (column_u, column_v)
         unit = 'units of the camera'
      case (column_tension)
         unit = 'm/s2'
      case default
         unit = 's'
         if (is_angle(column)) unit = merge('degrees', 'rad    ', in_degrees)
      end select
   end function unit_of

end module kyvadlo_fit_plot
