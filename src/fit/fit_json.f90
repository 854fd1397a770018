!> What a fit found, as JSON.
module kyvadlo_fit_json
   use kyvadlo_fit_data, only: column_names, column_period
   use kyvadlo_fit_request, only: fit_request_type
   use kyvadlo_fit_result
   use kyvadlo_fit_scene, only: fitted_scene
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_number_text, only: shortest_text
   use kyvadlo_numbers, only: is_finite
   use kyvadlo_text, only: integer_text, text_sink_type, text_type
   implicit none
   private
   public :: write_fit_json

contains

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
               call add_values(line, one%least(:one%elements), is_finite(one%least(:one%elements)))
               line = line//', "most": '
               call add_values(line, one%most(:one%elements), is_finite(one%most(:one%elements)))
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
         call put_correlations(result, sink)
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
      if (allocated(result%intervals)) then
         line = '  "intervals": '
         call add_text(line, result%intervals)
         call sink%put(line//',')
      end if
      line = '  "notes": '
      call add_list(line, result%notes)
      call sink%put(line//',')
      line = '  "scene": '
      if (result%is_converged) then
         call fitted_scene(result, request, scene)
         call add_text(line, scene)
      else
         line = line//'null'
      end if
      call sink%put(line)
      call sink%put('}')
   end subroutine write_fit_json

   !> Of every two numbers whose sigmas are known.
   subroutine put_correlations(result, sink)
      type(fit_result_type), intent(in) :: result
      class(text_sink_type), intent(inout) :: sink
      character(len=:), allocatable :: line
      integer :: i, j, k, l

      line = ''
      do i = 1, size(result%of)
         do k = 1, result%of(i)%elements
            do j = i, size(result%of)
               do l = merge(k + 1, 1, j == i), result%of(j)%elements
                  if (.not. (result%of(i)%is_known(k) .and. result%of(j)%is_known(l))) cycle
                  if (line /= '') call sink%put(line//',')
                  line = '    "'//element_name(result%of(i), k)//' '//element_name(result%of(j), l)//'": '// &
                     json_number(correlation(result, result%of(i)%first + k - 1, result%of(j)%first + l - 1))
               end do
            end do
         end do
      end do
      if (line /= '') call sink%put(line)
   end subroutine put_correlations

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

end module kyvadlo_fit_json
