!> Work-precision diagrams of a study as scripts of gnuplot: error against time, a panel for each orbit.
module kyvadlo_study_plots
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_quoting, only: gnuplot_text
   use kyvadlo_study_record, only: measured, study_type
   use kyvadlo_study_summary, only: names_in, question_title
   use kyvadlo_text, only: append, integer_text, text_sink_type, text_type
   implicit none
   private
   public :: write_plot

   !> Points that one line joins: a method in one kind, and in one of its forms.
   type :: series_type
      character(len=16) :: method = ''
      character(len=8) :: kind = ''
      character(len=24) :: form = ''   !! What of the setting is no number, if some of it is one
      logical :: is_line = .false.     !! Settings are numbers: points in order
   end type series_type

   !> Colours of methods in the order in which they appear, well apart on white; ours come first.
   character(len=*), parameter :: colours(*) = [character(len=7) :: '#d62728', '#1f77b4', '#2ca02c', '#9467bd', &
      '#ff7f0e', '#17becf', '#8c564b', '#e377c2', '#7f7f7f', '#bcbd22', '#000080', '#006400']

   !> In points.
   integer, parameter :: panel_width = 320, panel_height = 270, head_height = 60

contains

   !> A script that reads study.csv and writes study_QUESTION.svg and .png beside it.
   subroutine write_plot(study, question, sink)
      type(study_type), intent(in) :: study
      character(len=*), intent(in) :: question
      class(text_sink_type), intent(inout) :: sink
      type(text_type), allocatable :: orbits(:)
      type(series_type), allocatable :: series(:)
      integer :: columns, rows, i
      real(real64) :: least, most
      character(len=40) :: range
      character(len=3) :: page

      call names_in(study, 'orbit', question, orbits)
      call list_series(study, question, series)
      columns = ceiling(sqrt(1.6*(size(orbits) + 1)))
      rows = (size(orbits) + columns)/columns
      call sink%put('# Written by kyvadlo study; draws study_'//question//'.svg and study_'//question// &
         '.png from study.csv.')
      call sink%put('# gnuplot study_'//question//'.gp')
      call sink%put("csv = './study.csv'")
      call sink%put("set datafile separator ','")
      call sink%put('set logscale xy')
      ! The same axes in all panels, whole decades.
      associate (cells => study%cells(:study%count))
         least = minval(cells%ns_median, cells%question == question .and. cells%outcome == measured)
         most = maxval(cells%ns_median, cells%question == question .and. cells%outcome == measured)
      end associate
      if (.not. (least > 0 .and. most < huge(most))) then
         least = 1
         most = 1
      end if
      write (range, '("set xrange [1e",i0,":1e",i0,"]")') floor(log10(least)), floor(log10(most)) + 1
      call sink%put(trim(range))
      call sink%put('set yrange [1e-37:10]')
      call sink%put('set ytics 1e-35, 1e5, 1')
      call sink%put('unset mytics')
      call sink%put("set format '10^{%L}'")
      call sink%put('set grid')
      call sink%put('set tics font ",9" nomirror')
      call sink%put('set key off')
      call sink%put('set title font ",11" offset 0,-0.7')
      call sink%put('is(q, o, m, k) = strcol(1) eq q && strcol(2) eq o && strcol(3) eq m && strcol(5) eq k')
      call sink%put('taken(q, o, m, k, f) = is(q, o, m, k) && strstrt(strcol(4), f) > 0 ? column(7) : NaN')
      call sink%put('taken_by_all(q, o, m, k) = is(q, o, m, k) ? column(7) : NaN')
      ! No error at all is a point at the lower end, nonsense one at the upper.
      call sink%put('error = ''(column(6) > 1e-36 ? column(6) < 10 ? column(6) : 10 : 1e-36)''')
      do i = 1, 2
         ! Without a page asked for both are drawn; kyvadlo itself takes each from standard output.
         page = merge('svg', 'png', i == 1)
         call sink%put("if (!exists('page') || page eq '"//page//"') {")
         if (i == 1) then
            call sink%put("set terminal svg size "//trim(page_size(rows, columns))//" enhanced background '#ffffff'")
         else
            call sink%put("set terminal pngcairo size "//trim(page_size(rows, columns))//' enhanced')
         end if
         call sink%put("if (!exists('page')) { set output './study_"//question//'.'//page//"' }")
         call put_panels(study, question, orbits, series, rows, columns, sink)
         call sink%put('}')
      end do
   end subroutine write_plot

   !> In points.
   function page_size(rows, columns) result(text)
      integer, intent(in) :: rows, columns
      character(len=16) :: text

      text = integer_text(panel_width*columns)//','//integer_text(panel_height*rows + head_height)
   end function page_size

   !> Left, right, bottom, top, and the distances of panels, in shares of the page: 70 and 50 points for numbers and a
   !> label, 88 for these and a title.
   function margins(rows, columns) result(text)
      integer, intent(in) :: rows, columns
      character(len=80) :: text
      real :: width, height

      width = panel_width*columns
      height = panel_height*rows + head_height
      write (text, '(3(f6.4,","),f6.4," spacing ",f6.4,",",f6.4)') 70/width, 1 - 15/width, 50/height, 1 - 65/height, &
         75/width, 88/height
   end function margins

   !> The panels on one page, the last one for the legend.
   subroutine put_panels(study, question, orbits, series, rows, columns, sink)
      type(study_type), intent(in) :: study
      character(len=*), intent(in) :: question
      type(text_type), intent(in) :: orbits(:)
      type(series_type), intent(in) :: series(:)
      integer, intent(in) :: rows, columns
      class(text_sink_type), intent(inout) :: sink
      integer :: i, j

      call sink%put('set multiplot layout '//integer_text(rows)//','//integer_text(columns)//' title '// &
         gnuplot_text(trim(question_title(question))//'; against nanoseconds a result')//' margins '// &
         trim(margins(rows, columns)))
      call sink%put('set xlabel "ns a result" font ",9" offset 0, 0.7; set ylabel "error" font ",9" offset 1.5, 0')
      do i = 1, size(orbits)
         call sink%put('set title '//gnuplot_text(trim(protected(orbits(i)%text))))
         call sink%put('plot \')
         do j = 1, size(series)
            call sink%put("   csv using ("//trim(picked(question, orbits(i)%text, series(j)))//"):(@error) "// &
               trim(style(series, j))//merge(', \', '   ', j < size(series)))
         end do
      end do
      call sink%put('unset title; unset xlabel; unset ylabel')
      ! The legend may have the room of the numbers below the panels.
      call sink%put('set bmargin at screen 0.005')
      call sink%put('unset border')
      call sink%put('unset tics')
      call sink%put('unset grid')
      call sink%put('set key center center font ",7" samplen 2 spacing 0.9 maxcols 1')
      call sink%put('plot \')
      do j = 1, size(series)
         call sink%put('   NaN '//trim(style(series, j))//" title '"//trim(label(study, question, series(j)))//"'"// &
            merge(', \', '   ', j < size(series)))
      end do
      call sink%put('unset multiplot')
      call sink%put('unset bmargin')
      call sink%put('set key off')
      call sink%put('set border')
      call sink%put('set tics font ",9" nomirror')
      call sink%put('set ytics 1e-35, 1e5, 1')
      call sink%put('set grid')
   end subroutine put_panels

   !> The time of the points of a series, as gnuplot computes it.
   function picked(question, orbit, series) result(expression)
      character(len=*), intent(in) :: question, orbit
      type(series_type), intent(in) :: series
      character(len=256) :: expression

      expression = "'"//question//"', "//gnuplot_text(orbit)//", '"//trim(series%method)//"', '"//trim(series%kind)//"'"
      if (series%form == '') then
         expression = 'taken_by_all('//trim(expression)//')'
      else
         expression = 'taken('//trim(expression)//", '"//trim(series%form)//"')"
      end if
   end function picked

   !> A colour for each method; ours are thick; single precision open, quad with a triangle; other forms dashed.
   function style(series, j) result(text)
      type(series_type), intent(in) :: series(:)
      integer, intent(in) :: j
      character(len=80) :: text
      integer :: i, number, form

      number = 0
      do i = 1, j
         if (.not. any(series(:i - 1)%method == series(i)%method)) number = number + 1
         if (series(i)%method == series(j)%method) exit
      end do
      form = count(series(:j - 1)%method == series(j)%method .and. series(:j - 1)%kind == series(j)%kind)
      text = merge('with linespoints', 'with points     ', series(j)%is_line)//" lc rgb '"// &
         colours(1 + modulo(number - 1, size(colours)))//"' ps 0.6 dt "// &
         integer_text(1 + modulo(form, 5))
      select case (series(j)%kind)
      case ('real32')
         text = trim(text)//' pt 6'
      case ('real64')
         text = trim(text)//' pt 7'
      case default
         text = trim(text)//' pt 9'
      end select
      text = trim(text)//merge(' lw 2', ' lw 1', series(j)%method == 'closed_form' .or. series(j)%method == 'ours')
   end function style

   !> The kind is named where the method has several.
   function label(study, question, series) result(text)
      type(study_type), intent(in) :: study
      character(len=*), intent(in) :: question
      type(series_type), intent(in) :: series
      character(len=160) :: text

      text = trim(series%method)
      if (series%form /= '') text = trim(text)//' '//series%form
      associate (cells => study%cells(:study%count))
         if (any(cells%question == question .and. cells%method == series%method .and. cells%kind /= series%kind)) &
            text = trim(text)//' '//series%kind
      end associate
      text = protected(trim(text))
   end function label

   subroutine list_series(study, question, series)
      type(study_type), intent(in) :: study
      character(len=*), intent(in) :: question
      type(series_type), allocatable, intent(out) :: series(:)
      type(series_type) :: new
      integer :: i

      allocate (series(0))
      do i = 1, study%count
         associate (cell => study%cells(i))
            if (cell%question /= question) cycle
            new = series_type(cell%method, cell%kind, form_of(trim(cell%setting)), has_number(trim(cell%setting)))
         end associate
         if (any(series%method == new%method .and. series%kind == new%kind .and. series%form == new%form)) cycle
         series = [series, new]
      end do
   end subroutine list_series

   !> `cartesian` of `1e-6 cartesian`; nothing of `set-up`, whose points are joined with others.
   function form_of(setting) result(form)
      character(len=*), intent(in) :: setting
      character(len=24) :: form
      integer :: blank

      form = ''
      blank = index(setting, ' ')
      if (blank == 0) return
      if (verify(setting(:blank - 1), '0123456789.e+-') == 0) then
         form = setting(blank + 1:)
      else if (verify(setting(blank + 1:), '0123456789.e+-') == 0) then
         form = setting(:blank - 1)
      end if
      if (form == 'term' .or. form == 'terms') form = ''  ! `1 term`, `2 terms` are one form
   end function form_of

   !> Is one of the words a number?
   pure logical function has_number(setting)
      character(len=*), intent(in) :: setting
      integer :: blank

      blank = index(setting//' ', ' ')
      has_number = verify(setting(:blank - 1), '0123456789.e+-') == 0 .or. &
         (blank < len(setting) .and. verify(setting(blank + 1:), '0123456789.e+-') == 0)
   end function has_number

   !> A text without the marks of gnuplot's enhanced text, blanks behind.
   pure function protected(text) result(safe)
      character(len=*), intent(in) :: text
      character(len=2*len(text)) :: safe
      integer :: i, used

      safe = ''
      used = 0
      do i = 1, len(text)
         if (scan(text(i:i), '_^{}@&~\') > 0) then
            used = used + 1
            safe(used:used) = '\'
         end if
         used = used + 1
         safe(used:used) = text(i:i)
      end do
   end function protected

end module kyvadlo_study_plots
