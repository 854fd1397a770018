!> What a fit found: numbers, sigmas, residuals, and what follows from them.
module kyvadlo_fit_result
   use kyvadlo_fit_data, only: column_period, is_angle
   use kyvadlo_fit_model, only: model_type
   use kyvadlo_fit_request, only: fit_request_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: is_finite
   use kyvadlo_scene_groups, only: settings
   use kyvadlo_text, only: integer_text, text_type
   implicit none
   private
   public :: fit_result_type, fitted_type, element_name, correlation, rms, rms_in_sigmas, mean_in_sigmas, &
      digits_by, sigma_digits

   !> A free setting, found.
   type :: fitted_type
      character(len=40) :: name = ''
      integer :: setting = 0, elements = 1, first = 0    !! first: its place among the rows of the covariance
      real(wp) :: value(3) = 0, sigma(3) = 0
      logical :: is_known(3) = .true.                    !! Else the data do not tell it
      real(wp) :: least(3) = 0, most(3) = 0              !! An interval, if one was asked for; NaN: it has no end there
   end type fitted_type

   type :: fit_result_type
      logical :: is_converged = .false., has_intervals = .false.
      real(wp) :: chi2 = 0, p_value = 0
      integer :: dof = 0, iterations = 0
      type(fitted_type), allocatable :: of(:)
      real(wp), allocatable :: covariance(:, :)          !! Of all elements of all free settings
      type(text_type), allocatable :: undetermined(:), notes(:), others(:)
      logical :: is_estimated(column_period) = .false.   !! Whose sigma was not given
      real(wp) :: number(3, size(settings)) = 0          !! Of all settings
      type(model_type) :: model
      !> Of `model%used`. Residuals are measured less model, in sigmas.
      real(wp), allocatable :: x(:), predicted(:), residual(:)
      real(wp) :: condition = 0                          !! Of the derivatives in natural units
      character(len=:), allocatable :: known             !! What is known of what is not
      character(len=:), allocatable :: intervals         !! How they were found
   end type fit_result_type

   real(wp), parameter :: degree = acos(-1.0_wp)/180

   !> Figures of a sigma.
   integer, parameter :: sigma_digits = 3

contains

   pure integer function name_length(one) result(length)
      type(fitted_type), intent(in) :: one

      length = len_trim(one%name)
      if (one%elements > 1) length = length + 3
   end function name_length

   !> `length`, or `position(1)` of what has several.
   pure function element_name(one, element) result(name)
      type(fitted_type), intent(in) :: one
      integer, intent(in) :: element
      character(len=name_length(one)) :: name

      name = one%name
      if (one%elements > 1) name = trim(one%name)//'('//integer_text(element)//')'
   end function element_name

   !> Of two rows of the covariance.
   pure real(wp) function correlation(result, a, b)
      type(fit_result_type), intent(in) :: result
      integer, intent(in) :: a, b

      associate (c => result%covariance)
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

   !> So many that the last is of the place of the last digit of sigma.
   pure integer function digits_by(value, sigma) result(digits)
      real(wp), intent(in) :: value, sigma

      digits = 7
      if (.not. (is_finite(value) .and. is_finite(sigma))) return   ! A NaN is not even compared: that may trap.
      if (.not. (sigma > 0 .and. abs(value) > 0)) return
      digits = max(1, min(15, floor(log10(abs(value))) - floor(log10(sigma)) + sigma_digits))
   end function digits_by

end module kyvadlo_fit_result
