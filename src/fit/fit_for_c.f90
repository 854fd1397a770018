!> Fits for C: a scene as text and measurements as arrays or text, numbers out. Documented in kyvadlo_gsl.h.
module kyvadlo_fit_for_c
   use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_null_char, c_size_t
   use kyvadlo_fit, only: fit_measurements, fit_result_type
   use kyvadlo_fit_arrays, only: new_fit_data
   use kyvadlo_fit_data, only: fit_data_type, parse_fit_data
   use kyvadlo_fit_request, only: fit_request_type, parse_fit_request
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_scene_groups, only: settings
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: integer_text
   implicit none
   private
   public :: kyvadlo_fit_rows, kyvadlo_fit_text

   type, bind(c) :: summary_type
      integer(c_size_t) :: numbers = 0
      integer(c_int) :: converged = 0, dof = 0
      real(c_double) :: chi2 = 0, p_value = 0
   end type summary_type

   !> KYVADLO_NO_MINIMUM
   integer(c_int), parameter :: code_no_minimum = 10

contains

   function kyvadlo_fit_rows(scene, columns, rows, table, room, values, sigmas, summary, message, capacity) &
      result(code) bind(c)
      character(kind=c_char), intent(in) :: scene(*), columns(*)
      integer(c_size_t), value :: rows, room, capacity
      real(c_double), intent(in) :: table(*)
      real(c_double), intent(out), optional :: values(*), sigmas(*)
      type(summary_type), intent(out), optional :: summary
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int) :: code
      type(fit_data_type) :: data
      type(error_type), allocatable :: error
      character(len=:), allocatable :: names

      call take_text(columns, names)
      call new_fit_data(names, int(rows), table, data, error)
      call fit_for_c(scene, data, room, values, sigmas, summary, message, capacity, error, code)
   end function kyvadlo_fit_rows

   function kyvadlo_fit_text(scene, table, room, values, sigmas, summary, message, capacity) result(code) bind(c)
      character(kind=c_char), intent(in) :: scene(*), table(*)
      integer(c_size_t), value :: room, capacity
      real(c_double), intent(out), optional :: values(*), sigmas(*)
      type(summary_type), intent(out), optional :: summary
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int) :: code
      type(fit_data_type) :: data
      type(error_type), allocatable :: error
      character(len=:), allocatable :: text

      call take_text(table, text)
      call parse_fit_data(text, 'table', data, error)
      call fit_for_c(scene, data, room, values, sigmas, summary, message, capacity, error, code)
   end function kyvadlo_fit_text

   !> What both do once they have the data.
   subroutine fit_for_c(scene, data, room, values, sigmas, summary, message, capacity, error, code)
      character(kind=c_char), intent(in) :: scene(*)
      type(fit_data_type), intent(in) :: data
      integer(c_size_t), intent(in) :: room, capacity
      real(c_double), intent(out), optional :: values(*), sigmas(*)
      type(summary_type), intent(out), optional :: summary
      character(kind=c_char), intent(out) :: message(*)
      type(error_type), allocatable, intent(inout) :: error  !! Of the data
      integer(c_int), intent(out) :: code
      type(fit_request_type) :: request
      type(fit_result_type) :: result
      type(summary_type) :: found
      character(len=:), allocatable :: text
      integer :: i, k, n

      found = summary_type(0, 0, 0, quiet_nan_real64, quiet_nan_real64)
      if (present(values)) values(:room) = quiet_nan_real64
      if (present(sigmas)) sigmas(:room) = quiet_nan_real64
      if (.not. allocated(error)) then
         call take_text(scene, text)
         call parse_fit_request(text, 'scene', request, error)
      end if
      if (.not. allocated(error)) then
         n = sum(settings(request%free%setting)%values)
         found%numbers = int(n, c_size_t)
         if (n > room .and. (present(values) .or. present(sigmas))) call fail(error, code_input, &
            'a fit: '//integer_text(n)//' numbers are free, and there is room for fewer')
      end if
      if (.not. allocated(error)) call fit_measurements(request, data, result, error)
      code = 0
      if (allocated(error)) then
         code = int(error%code, c_int)
         call give_text(error%message, message, capacity)
      else
         found%dof = int(result%dof, c_int)
         if (allocated(result%residual)) found%chi2 = result%chi2
         if (result%is_converged) then
            found%converged = 1
            found%p_value = result%p_value
            call give_text('', message, capacity)
         else
            code = code_no_minimum
            call give_text('a fit: no minimum was found', message, capacity)
         end if
         n = 0
         do i = 1, size(result%of)
            do k = 1, result%of(i)%elements
               n = n + 1
               if (.not. result%is_converged) cycle
               if (present(values)) values(n) = result%of(i)%value(k)
               if (present(sigmas)) sigmas(n) = result%of(i)%sigma(k)
            end do
         end do
      end if
      if (present(summary)) summary = found
   end subroutine fit_for_c

   !> A text of C, up to its end.
   subroutine take_text(from, text)
      character(kind=c_char), intent(in) :: from(*)
      character(len=:), allocatable, intent(out) :: text
      integer :: i, length

      length = 0
      do while (from(length + 1) /= c_null_char)
         length = length + 1
      end do
      allocate (character(len=length) :: text)
      do i = 1, length
         text(i:i) = from(i)
      end do
   end subroutine take_text

   subroutine give_text(text, message, capacity)
      character(len=*), intent(in) :: text
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), intent(in) :: capacity  !! Of any size: what C calls -1 is the largest
      integer :: i, length

      if (capacity == 0) return
      length = len(text)
      if (capacity > 0) length = int(min(capacity - 1, int(length, c_size_t)))
      do i = 1, length
         message(i) = text(i:i)
      end do
      message(length + 1) = c_null_char
   end subroutine give_text

end module kyvadlo_fit_for_c
