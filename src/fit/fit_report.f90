!> What a fit found, for reading and as CSV.
module kyvadlo_fit_report
   use kyvadlo_fit_data, only: column_names, column_period, is_angle
   use kyvadlo_fit_request, only: fit_request_type
   use kyvadlo_fit_result
   use kyvadlo_fit_scene, only: fitted_scene
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_number_text, only: digits_text, shortest_text
   use kyvadlo_numbers, only: is_finite
   use kyvadlo_scene_groups, only: settings
   use kyvadlo_text, only: integer_text, text_sink_type
   implicit none
   private
   public :: write_fit_text, write_fit_csv, write_residuals

   real(wp), parameter :: degree = acos(-1.0_wp)/180

contains

   !> For reading.
   subroutine write_fit_text(result, request, sink)
      type(fit_result_type), intent(in) :: result
      type(fit_request_type), intent(in) :: request
      class(text_sink_type), intent(inout) :: sink
      character(len=:), allocatable :: line, scene
      integer :: i, j, k, at

      if (.not. result%is_converged) call sink%put('No minimum was found. This is where the search ended:')
      line = 'parameter            value               sigma       '
      if (result%has_intervals) line = line//'least          most           '
      call sink%put(line//'unit')
      do i = 1, size(result%of)
         associate (one => result%of(i))
            do k = 1, one%elements
               line = padded(element_name(one, k), 21)//padded(digits_text(one%value(k), digits_by(one%value(k), &
                  one%sigma(k))), 20)//padded(known_text(one%sigma(k), sigma_digits, 'unknown'), 12)
               if (result%has_intervals) line = line//padded(known_text(one%least(k), digits_by(one%least(k), &
                  one%sigma(k)), 'none'), 15)//padded(known_text(one%most(k), digits_by(one%most(k), one%sigma(k)), &
                  'none'), 15)
               line = line//trim(settings(one%setting)%unit)
               call sink%put(trim(line))
            end do
         end associate
      end do
      if (allocated(result%intervals)) call sink%put('least and most: '//result%intervals)
      if (allocated(result%residual)) then
         call sink%put('')
         call sink%put('chi2/dof = '//digits_text(result%chi2, 5)//'/'//integer_text(result%dof)//' = '// &
            digits_text(result%chi2/max(1, result%dof), 4)//', p = '//digits_text(result%p_value, 3))
         do j = 1, column_period
            if (count(result%model%all(result%model%used)%column == j) == 0) cycle
            line = trim(column_names(j))//': '//integer_text(count(result%model%all(result%model%used)%column == j))// &
               ' values, residuals '//digits_text(rms(result, request, j), 3)//' rms, '// &
               digits_text(rms_in_sigmas(result, j), 3)//' sigmas, mean '//digits_text(mean_in_sigmas(result, j), 2)
            if (result%is_estimated(j)) line = line//' (sigma estimated)'
            call sink%put(line)
         end do
         call put_outliers(result, sink)
         call put_correlations(result, sink)
      end if
      if (allocated(result%undetermined)) then
         do i = 1, size(result%undetermined)
            call sink%put('The data do not tell: '//result%undetermined(i)%text)
         end do
      end if
      if (allocated(result%known)) then
         at = 1
         do while (at <= len(result%known))
            i = index(result%known(at:)//'; ', '; ')
            call sink%put('They tell: '//result%known(at:at + i - 2))
            at = at + i + 1
         end do
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
      if (.not. result%is_converged) return
      call sink%put('')
      call fitted_scene(result, request, scene)
      at = 1
      do while (at <= len(scene))
         i = index(scene(at:), achar(10))
         call sink%put(scene(at:at + i - 2))
         at = at + i
      end do
   end subroutine write_fit_text

   !> What lies beyond five sigmas, the first few.
   subroutine put_outliers(result, sink)
      type(fit_result_type), intent(in) :: result
      class(text_sink_type), intent(inout) :: sink
      real(wp), parameter :: far = 5
      integer, parameter :: shown = 5
      character(len=:), allocatable :: line
      integer :: i, n

      n = 0
      do i = 1, size(result%residual)
         if (abs(result%residual(i)) < far) cycle
         n = n + 1
         if (n > shown) cycle
         associate (one => result%model%all(result%model%used(i)))
            line = 'outlier: '//trim(column_names(one%column))//' in row '//integer_text(one%row)
            if (one%time > -huge(1.0_wp)) line = line//', t = '//digits_text(one%time, 6)//' s'
            call sink%put(line//': '//digits_text(result%residual(i), 3)//' sigmas')
         end associate
      end do
      if (n > shown) call sink%put('and '//integer_text(n - shown)//' more beyond 5 sigmas')
   end subroutine put_outliers

   !> Those of every two numbers that are large enough to matter. Elements of one vector lie on its sphere or plane.
   subroutine put_correlations(result, sink)
      type(fit_result_type), intent(in) :: result
      class(text_sink_type), intent(inout) :: sink
      !> At a half a sigma would be 0.87 of what it is, were the other number known.
      real(wp), parameter :: large = 0.5_wp
      real(wp) :: found
      integer :: i, j, k, l

      if (.not. allocated(result%covariance)) return
      do i = 1, size(result%of)
         do k = 1, result%of(i)%elements
            do j = i + 1, size(result%of)
               do l = 1, result%of(j)%elements
                  if (.not. (result%of(i)%is_known(k) .and. result%of(j)%is_known(l))) cycle
                  found = correlation(result, result%of(i)%first + k - 1, result%of(j)%first + l - 1)
                  if (abs(found) >= large) call sink%put('correlation of '//element_name(result%of(i), k)//' and '// &
                     element_name(result%of(j), l)//': '//digits_text(found, 3))
               end do
            end do
         end do
      end do
   end subroutine put_correlations

   pure integer function known_length(value, digits, without) result(length)
      real(wp), intent(in) :: value
      integer, intent(in) :: digits
      character(len=*), intent(in) :: without

      length = len(without)
      if (is_finite(value)) length = len(digits_text(value, digits))
   end function known_length

   !> A number, or a word where there is none.
   pure function known_text(value, digits, without) result(text)
      real(wp), intent(in) :: value
      integer, intent(in) :: digits
      character(len=*), intent(in) :: without
      character(len=known_length(value, digits, without)) :: text

      text = without
      if (is_finite(value)) text = digits_text(value, digits)
   end function known_text

   pure function padded(text, width)
      character(len=*), intent(in) :: text
      integer, intent(in) :: width
      character(len=max(width, len(text) + 1)) :: padded

      padded = text
   end function padded

   !> Empty cells where nothing is known.
   subroutine write_fit_csv(result, sink)
      type(fit_result_type), intent(in) :: result
      class(text_sink_type), intent(inout) :: sink
      character(len=:), allocatable :: line
      integer :: i, k

      if (result%has_intervals) then
         call sink%put('parameter,value,sigma,least,most')
      else
         call sink%put('parameter,value,sigma')
      end if
      do i = 1, size(result%of)
         associate (one => result%of(i))
            do k = 1, one%elements
               line = trim(one%name)
               if (one%elements > 1) line = line//integer_text(k)
               line = line//','//shortest_text(one%value(k))//','
               call add(one%sigma(k))
               if (result%has_intervals) then
                  line = line//','
                  call add(one%least(k))
                  line = line//','
                  call add(one%most(k))
               end if
               call sink%put(line)
            end do
         end associate
      end do

   contains

      subroutine add(value)
         real(wp), intent(in) :: value

         if (is_finite(value)) line = line//shortest_text(value)
      end subroutine add
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
               ','//shortest_text(result%residual(i)))
         end associate
      end do
   end subroutine write_residuals

end module kyvadlo_fit_report
