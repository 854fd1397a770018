!> What `fit --explain` says before a fit: the data, the unknowns, where the search begins, what it costs.
module kyvadlo_explain_fit
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_fit_data, only: column_names, column_period, columns, fit_data_type
   use kyvadlo_fit_loss, only: loss_squares
   use kyvadlo_fit_model, only: model_type, use_until
   use kyvadlo_fit_motion, only: find_states
   use kyvadlo_fit_places, only: effect_guesses, guess_places, most_guesses, new_model, place_type
   use kyvadlo_fit_request, only: fit_request_type
   use kyvadlo_fit_unknowns, only: place_at
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_number_text, only: digits_text
   use kyvadlo_scene_groups
   use kyvadlo_standard_io, only: message
   use kyvadlo_text, only: integer_text
   implicit none
   private
   public :: explain_fit

contains

   !> Prints on standard error, a line for each fact. The data have passed their checks.
   subroutine explain_fit(request, data)
      type(fit_request_type), intent(in) :: request
      type(fit_data_type), intent(in) :: data
      type(model_type) :: model
      logical :: is_estimated(column_period), is_whole
      character(len=:), allocatable :: text
      type(place_type) :: places(most_guesses + 1)
      integer :: level, i, j, count_places
      integer(int64) :: start, finish, rate

      call new_model(model, request, data, is_estimated)
      model%find_states => find_states
      call use_until(model, huge(1.0_wp), 1)
      text = ''
      do j = 1, columns
         if (data%has(j)) text = text//' '//trim(column_names(j))
      end do
      call message('data:    '//text//'; '//integer_text(data%rows)//' rows, '//integer_text(size(model%all))// &
         ' measured numbers')
      if (any(model%all%time > -huge(1.0_wp))) call message('times:    '//digits_text(minval(model%all%time, &
         model%all%time > -huge(1.0_wp)), 6)//' to '//digits_text(maxval(model%all%time), 6)//' s')
      text = ''
      do j = 1, column_period
         if (.not. data%has(j)) cycle
         text = text//' '//trim(column_names(j))//' '
         if (is_estimated(j)) then
            text = text//'estimated'
         else if (data%has_sigma(j)) then
            text = text//'by row'
         else
            text = text//digits_text(request%sigma(j), 4)
         end if
         text = text//','
      end do
      if (allocated(model%time_sigma)) text = text//' t too,'
      call message('sigmas:  '//text(:len(text) - 1))
      text = ''
      do i = 1, size(request%free)
         associate (free => request%free(i))
            text = text//' '//trim(free%name)
            j = count(model%motion%of%free == i)
            if (j > 1) text = text//' ('//integer_text(j)//')'
            if (free%is_given) text = text//' [guess]'
            if (free%prior_sigma > 0) text = text//' [prior]'
            text = text//','
         end associate
      end do
      call message('unknowns:'//text(:len(text) - 1)//': '//integer_text(size(model%motion%of))//', which leave '// &
         integer_text(model%residuals - size(model%motion%of))//' degrees of freedom')
      if (request%loss /= loss_squares) call message('loss:     outliers count less')
      if (model%motion%is_exact) then
         call message('path:     closed form, and its derivatives in closed form')
      else
         call message('path:     integrated, its derivatives by the variational equations')
      end if
      call system_clock(start, rate)
      do level = 1, 2
         call guess_places(model, request, level, places, count_places)
         if (count_places > 0) exit
      end do
      call system_clock(finish)
      is_whole = all(request%free%is_given .or. (settings(request%free%setting)%group /= pendulum_group .and. &
         settings(request%free%setting)%group /= camera_group))
      text = integer_text(count_places)//' guesses from the data'
      if (is_whole) text = 'the numbers of the scene, then '//text
      call message('start:    '//text)
      places(1)%squares = 0
      if (is_whole) then
         places(1)%number = request%number
         call effect_guesses(request, places(1)%number)
      end if
      call message_cost(model, places(1)%number, real(finish - start, wp)/rate)
   end subroutine explain_fit

   !> One evaluation of all data with derivatives, measured where the search begins.
   subroutine message_cost(model, number, guessing)
      type(model_type), intent(inout) :: model
      real(wp), intent(in) :: number(:, :), guessing     !! Seconds that the guesses took
      real(wp) :: x(size(model%motion%of)), f(model%residuals), jacobian(size(x), model%residuals), seconds
      integer(int64) :: start, finish, rate
      logical :: failed
      integer :: i
      model%motion%number = number
      call place_at(model%motion, x, away=1.0_wp)
      seconds = huge(seconds)
      do i = 1, 3
         call system_clock(start, rate)
         call model%evaluate(x, f, failed, jacobian)
         call system_clock(finish)
         seconds = min(seconds, real(finish - start, wp)/rate)
         if (failed .or. seconds > 0.1_wp) exit
      end do
      if (failed) then
         call message('cost:     not known: there is no motion where the search begins')
      else
         call message('cost:     '//digits_text(1e3_wp*guessing, 3)//' ms for the guesses; '// &
            digits_text(1e3_wp*seconds, 3)//' ms each time that all data are compared with derivatives, some ten times')
      end if
   end subroutine message_cost

end module kyvadlo_explain_fit
