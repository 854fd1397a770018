!> What a fit found, as JSON, as text, as CSV, and as a scene for `simulate`.
module kyvadlo_fit_report
   use kyvadlo_fit, only: fit_result_type, fitted_type
   use kyvadlo_fit_data, only: column_names, column_period, columns, is_angle
   use kyvadlo_fit_request, only: fit_request_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: group_type, parse_groups
   use kyvadlo_number_text, only: digits_text, shortest_text
   use kyvadlo_numbers, only: is_finite
   use kyvadlo_scene_groups, only: group_names, settings
   use kyvadlo_status, only: error_type
   use kyvadlo_text, only: append, integer_text, text_sink_type, text_type
   implicit none
   private
   public :: write_fit_json, write_fit_text, write_fit_csv, write_residuals, fitted_scene

   real(wp), parameter :: degree = acos(-1.0_wp)/180

contains

   pure integer function json_length(value) result(length)
      real(wp), intent(in) :: value

      length = 4
      if (is_finite(value)) length = len(shortest_text(value))
   end function json_length

   !> One number as JSON has them.
   pure function json_number(value) result(text)
      real(wp), intent(in) :: value
      character(len=json_length(value)) :: text

      text = 'null'
      if (is_finite(value)) text = shortest_text(value)
   end function json_number

   !> Adds a text in quotation marks.
   pure subroutine add_text(line, value)
      character(len=:), allocatable, intent(inout) :: line
      character(len=*), intent(in) :: value
      integer :: i

      line = line//'"'
      do i = 1, len(value)
         select case (value(i:i))
         case ('"', '\')
            line = line//'\'//value(i:i)
         case (achar(10))
            line = line//'\n'
         case default
            if (iachar(value(i:i)) >= 32) line = line//value(i:i)
         end select
      end do
      line = line//'"'
   end subroutine add_text

   pure subroutine add_list(line, texts)
      character(len=:), allocatable, intent(inout) :: line
      type(text_type), allocatable, intent(in) :: texts(:)
      integer :: i

      line = line//'['
      if (allocated(texts)) then
         do i = 1, size(texts)
            if (i > 1) line = line//', '
            call add_text(line, texts(i)%text)
         end do
      end if
      line = line//']'
   end subroutine add_list

   !> Adds elements, or null where none is known.
   pure subroutine add_values(line, values, is_known)
      character(len=:), allocatable, intent(inout) :: line
      real(wp), intent(in) :: values(:)
      logical, intent(in) :: is_known(:)
      integer :: i

      if (.not. any(is_known)) then
         line = line//'null'
         return
      end if
      if (size(values) > 1) line = line//'['
      do i = 1, size(values)
         if (i > 1) line = line//', '
         if (is_known(i)) then
            line = line//json_number(values(i))
         else
            line = line//'null'
         end if
      end do
      if (size(values) > 1) line = line//']'
   end subroutine add_values

   !> The form that scripts rely on; further keys behind it.
   subroutine write_fit_json(result, request, sink)
      type(fit_result_type), intent(in) :: result
      type(fit_request_type), intent(in) :: request
      class(text_sink_type), intent(inout) :: sink
      integer :: i, j, k
      character(len=:), allocatable :: line, scene

      call sink%put('{')
      call sink%put('  "parameters": {')
      do i = 1, size(result%of)
         associate (one => result%of(i))
            line = '    '
            call add_text(line, trim(one%name))
            line = line//': {"value": '
            call add_values(line, one%value(:one%elements), [(.true., k=1, one%elements)])
            line = line//', "sigma": '
            call add_values(line, one%sigma(:one%elements), one%is_known(:one%elements) .and. &
               is_finite(one%sigma(:one%elements)))
            if (result%has_intervals) then
               line = line//', "least": '
               call add_values(line, one%least(:one%elements), one%is_known(:one%elements))
               line = line//', "most": '
               call add_values(line, one%most(:one%elements), one%is_known(:one%elements))
            end if
            call sink%put(line//'}'//repeat(',', merge(1, 0, i < size(result%of))))
         end associate
      end do
      call sink%put('  },')
      if (allocated(result%residual)) then
         call sink%put('  "chi2": '//json_number(result%chi2)//',')
      else
         call sink%put('  "chi2": null,')
      end if
      call sink%put('  "dof": '//integer_text(result%dof)//',')
      call sink%put('  "converged": '//trim(merge('true ', 'false', result%is_converged))//',')
      line = '  "undetermined": '
      call add_list(line, result%undetermined)
      call sink%put(line//',')
      if (allocated(result%residual)) then
         call sink%put('  "p_value": '//json_number(result%p_value)//',')
         line = '  "known": '
         call add_text(line, result%known)
         call sink%put(line//',')
         call sink%put('  "correlations": {')
         k = 0
         do i = 1, size(result%of)
            do j = i + 1, size(result%of)
               if (result%of(i)%elements > 1 .or. result%of(j)%elements > 1) cycle
               if (k > 0) call sink%put(line//',')
               k = k + 1
               line = '    '
               call add_text(line, trim(result%of(i)%name)//' '//trim(result%of(j)%name))
               line = line//': '//json_number(correlation(result, i, j))
            end do
         end do
         if (k > 0) call sink%put(line)
         call sink%put('  },')
         call sink%put('  "columns": {')
         k = 0
         do j = 1, column_period
            if (count(result%model%all(result%model%used)%column == j) == 0) cycle
            if (k > 0) call sink%put(line//',')
            k = k + 1
            line = '    "'//trim(column_names(j))//'": {"count": '//integer_text(count(result%model%all( &
               result%model%used)%column == j))//', "rms": '//json_number(rms(result, request, j))// &
               ', "rms_in_sigmas": '//json_number(rms_in_sigmas(result, j))//', "mean_in_sigmas": '// &
               json_number(mean_in_sigmas(result, j))//', "sigma_estimated": '// &
               trim(merge('true ', 'false', result%is_estimated(j)))//'}'
         end do
         if (k > 0) call sink%put(line)
         call sink%put('  },')
         line = '  "outliers": '
         call add_outliers(line, result)
         call sink%put(line//',')
      end if
      line = '  "others": '
      call add_list(line, result%others)
      call sink%put(line//',')
      line = '  "notes": '
      call add_list(line, result%notes)
      call sink%put(line//',')
      call fitted_scene(result, request, scene)
      line = '  "scene": '
      call add_text(line, scene)
      call sink%put(line)
      call sink%put('}')
   end subroutine write_fit_json

   pure real(wp) function correlation(result, i, j)
      type(fit_result_type), intent(in) :: result
      integer, intent(in) :: i, j

      associate (a => result%of(i)%first, b => result%of(j)%first, c => result%covariance)
         correlation = c(a, b)/sqrt(max(c(a, a)*c(b, b), tiny(1.0_wp)))
      end associate
   end function correlation

   !> Root mean square of the residuals of a column, in the unit of the data.
   pure real(wp) function rms(result, request, column)
      type(fit_result_type), intent(in) :: result
      type(fit_request_type), intent(in) :: request
      integer, intent(in) :: column

      associate (all => result%model%all(result%model%used))
         rms = sqrt(sum((all%value - result%predicted)**2, all%column == column)/max(1, count(all%column == column)))
      end associate
      if (request%in_degrees .and. is_angle(column)) rms = rms/degree
   end function rms

   pure real(wp) function rms_in_sigmas(result, column) result(rms)
      type(fit_result_type), intent(in) :: result
      integer, intent(in) :: column

      associate (all => result%model%all(result%model%used))
         rms = sqrt(sum(result%residual**2, all%column == column)/max(1, count(all%column == column)))
      end associate
   end function rms_in_sigmas

   pure real(wp) function mean_in_sigmas(result, column) result(mean)
      type(fit_result_type), intent(in) :: result
      integer, intent(in) :: column

      associate (all => result%model%all(result%model%used))
         mean = sum(result%residual, all%column == column)/max(1, count(all%column == column))
      end associate
   end function mean_in_sigmas

   !> Residuals beyond five sigmas.
   subroutine add_outliers(text, result)
      character(len=:), allocatable, intent(inout) :: text
      type(fit_result_type), intent(in) :: result
      integer :: i, n

      text = text//'['
      n = 0
      do i = 1, size(result%residual)
         if (abs(result%residual(i)) < 5) cycle
         n = n + 1
         if (n > 100) exit
         if (n > 1) text = text//', '
         associate (one => result%model%all(result%model%used(i)))
            text = text//'{"row": '//integer_text(one%row)//', "column": "'//trim(column_names(one%column))// &
               '", "residual_in_sigmas": '//json_number(result%residual(i))//'}'
         end associate
      end do
      text = text//']'
   end subroutine add_outliers

   !> For reading.
   subroutine write_fit_text(result, request, sink)
      type(fit_result_type), intent(in) :: result
      type(fit_request_type), intent(in) :: request
      class(text_sink_type), intent(inout) :: sink
      character(len=:), allocatable :: name, line, scene
      integer :: i, j, k, at

      if (.not. result%is_converged) call sink%put('No minimum was found.')
      call sink%put('parameter            value               sigma       unit')
      do i = 1, size(result%of)
         associate (one => result%of(i))
            do k = 1, one%elements
               name = trim(one%name)
               if (one%elements > 1) name = name//'('//integer_text(k)//')'
               line = padded(name, 21)//padded(digits_text(one%value(k), 10), 20)
               if (one%is_known(k) .and. is_finite(one%sigma(k))) then
                  line = line//padded(digits_text(one%sigma(k), 3), 12)
               else
                  line = line//padded('unknown', 12)
               end if
               if (result%has_intervals) line = line//padded(digits_text(one%least(k), 7), 15)// &
                  padded(digits_text(one%most(k), 7), 15)
               call sink%put(line//trim(settings(one%setting)%unit))
            end do
         end associate
      end do
      if (allocated(result%residual)) then
         call sink%put('')
         call sink%put('chi2/dof = '//digits_text(result%chi2, 5)//'/'//integer_text(result%dof)//' = '// &
            digits_text(result%chi2/max(1, result%dof), 4)//', p = '//digits_text(result%p_value, 3))
         do j = 1, column_period
            if (count(result%model%all(result%model%used)%column == j) == 0) cycle
            line = trim(column_names(j))//': '//integer_text(count(result%model%all(result%model%used)%column == j))// &
               ' values, residuals '//digits_text(rms(result, request, j), 3)//' rms, '// &
               digits_text(rms_in_sigmas(result, j), 3)//' sigmas'
            if (result%is_estimated(j)) line = line//' (sigma estimated)'
            call sink%put(line)
         end do
         j = count(abs(result%residual) >= 5)
         if (j > 0) call sink%put(integer_text(j)//' residuals beyond 5 sigmas')
         do i = 1, size(result%of)
            do j = i + 1, size(result%of)
               if (result%of(i)%elements > 1 .or. result%of(j)%elements > 1) cycle
               if (.not. (result%of(i)%is_known(1) .and. result%of(j)%is_known(1))) cycle
               call sink%put('correlation of '//trim(result%of(i)%name)//' and '//trim(result%of(j)%name)//': '// &
                  digits_text(correlation(result, i, j), 3))
            end do
         end do
      end if
      if (allocated(result%undetermined)) then
         do i = 1, size(result%undetermined)
            call sink%put('The data do not tell: '//result%undetermined(i)%text)
         end do
      end if
      if (allocated(result%known)) then
         if (result%known /= '') call sink%put('They tell: '//result%known)
      end if
      if (allocated(result%others)) then
         do i = 1, size(result%others)
            call sink%put('Another minimum nearby: '//result%others(i)%text)
         end do
      end if
      if (allocated(result%notes)) then
         do i = 1, size(result%notes)
            call sink%put('Note: '//result%notes(i)%text)
         end do
      end if
      call sink%put('')
      call fitted_scene(result, request, scene)
      at = 1
      do while (at <= len(scene))
         i = index(scene(at:), achar(10))
         call sink%put(scene(at:at + i - 2))
         at = at + i
      end do
   end subroutine write_fit_text

   pure function padded(text, width)
      character(len=*), intent(in) :: text
      integer, intent(in) :: width
      character(len=max(width, len(text) + 1)) :: padded

      padded = text
   end function padded

   subroutine write_fit_csv(result, sink)
      type(fit_result_type), intent(in) :: result
      class(text_sink_type), intent(inout) :: sink
      character(len=:), allocatable :: name, sigma
      integer :: i, k

      call sink%put('parameter,value,sigma')
      do i = 1, size(result%of)
         associate (one => result%of(i))
            do k = 1, one%elements
               name = trim(one%name)
               if (one%elements > 1) name = name//integer_text(k)
               sigma = ''
               if (one%is_known(k) .and. is_finite(one%sigma(k))) sigma = shortest_text(one%sigma(k))
               call sink%put(name//','//shortest_text(one%value(k))//','//sigma)
            end do
         end associate
      end do
   end subroutine write_fit_csv

   !> A line for each measured number.
   subroutine write_residuals(result, request, sink)
      type(fit_result_type), intent(in) :: result
      type(fit_request_type), intent(in) :: request
      class(text_sink_type), intent(inout) :: sink
      integer :: i
      real(wp) :: unit
      character(len=:), allocatable :: time

      call sink%put('t,column,measured,model,residual,residual_in_sigmas')
      if (.not. allocated(result%residual)) return
      do i = 1, size(result%residual)
         associate (one => result%model%all(result%model%used(i)))
            unit = 1
            if (request%in_degrees .and. is_angle(one%column)) unit = 1/degree
            time = ''
            if (one%time > -huge(1.0_wp)) time = shortest_text(one%time)
            call sink%put(time//','//trim(column_names(one%column))//','//shortest_text(one%value*unit)//','// &
               shortest_text(result%predicted(i)*unit)//','//shortest_text((one%value - result%predicted(i))*unit)// &
               ','//shortest_text(-result%residual(i)))
         end associate
      end do
   end subroutine write_residuals

   !> The scene with what was found, ready for `simulate`: all groups but &fit and &camera.
   subroutine fitted_scene(result, request, text)
      type(fit_result_type), intent(in) :: result
      type(fit_request_type), intent(in) :: request
      character(len=:), allocatable, intent(out) :: text
      type(group_type), allocatable :: groups(:)
      type(error_type), allocatable :: error
      logical :: is_written(size(result%of))
      integer :: i, j, k, g
      character(len=*), parameter :: line_feed = achar(10)

      text = ''
      is_written = .false.
      call parse_groups(request%text, request%file, groups, error)
      if (allocated(error)) return
      do g = 1, size(groups)
         if (groups(g)%name == 'fit' .or. groups(g)%name == 'camera') cycle
         text = text//'&'//groups(g)%name//line_feed
         entries: do j = 1, size(groups(g)%entries)
            associate (entry => groups(g)%entries(j))
               do i = 1, size(result%of)
                  if (is_of(i, groups(g)%name) .and. settings(result%of(i)%setting)%name == entry%name) cycle entries
               end do
               text = text//'   '//entry%name
               if (entry%first > 0) text = text//'('//integer_text(entry%first)//')'
               text = text//' = '
               do k = 1, size(entry%values)
                  if (k > 1) text = text//', '
                  if (entry%values(k)%quoted) then
                     text = text//"'"//entry%values(k)%text//"'"
                  else
                     text = text//entry%values(k)%text
                  end if
               end do
               text = text//line_feed
            end associate
         end do entries
         call put_free(groups(g)%name)
         text = text//'/'//line_feed
      end do
      do i = 1, size(result%of)
         if (is_written(i)) cycle
         associate (group => group_names(settings(result%of(i)%setting)%group))
            if (group == 'camera') cycle
            text = text//'&'//trim(group)//line_feed
            call put_free(trim(group))
            text = text//'/'//line_feed
         end associate
      end do

   contains

      logical function is_of(i, group)
         integer, intent(in) :: i
         character(len=*), intent(in) :: group

         is_of = group_names(settings(result%of(i)%setting)%group) == group
      end function is_of

      subroutine put_free(group)
         character(len=*), intent(in) :: group
         integer :: i, k

         do i = 1, size(result%of)
            if (is_written(i) .or. .not. is_of(i, group)) cycle
            is_written(i) = .true.
            associate (one => result%of(i))
               text = text//'   '//trim(settings(one%setting)%name)//' = '
               do k = 1, one%elements
                  if (k > 1) text = text//', '
                  text = text//shortest_text(one%value(k))
               end do
               text = text//line_feed
            end associate
         end do
      end subroutine put_free
   end subroutine fitted_scene

end module kyvadlo_fit_report
