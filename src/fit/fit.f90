!> From measurements to the pendulum that made them: the best minimum, standard deviations, and what the data cannot
!> tell.
module kyvadlo_fit
   use kyvadlo_fit_data
   use kyvadlo_fit_loss, only: loss_squares, soften
   use kyvadlo_fit_model, only: leave_room, predict, use_until
   use kyvadlo_fit_motion, only: find_states
   use kyvadlo_fit_places, only: new_model, sigma_groups
   use kyvadlo_fit_request, only: fit_request_type
   use kyvadlo_fit_result, only: fit_result_type, fitted_type
   use kyvadlo_fit_search, only: is_still, minimise_all, search
   use kyvadlo_fit_sigmas, only: find_sigmas, name_results
   use kyvadlo_fit_unknowns, only: place_at
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: place_of
   use kyvadlo_least_squares, only: minimum_type, triangle_of
   use kyvadlo_number_text, only: digits_text
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_quantiles, only: median
   use kyvadlo_scene_groups
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: append, integer_text
   implicit none
   private
   public :: fit_result_type, fitted_type, check_fit, fit_measurements, refit, find_sigmas

contains

   !> What can be said against the data, and against the scene for them, before anything is computed.
   subroutine check_fit(request, data, error)
      type(fit_request_type), intent(in) :: request
      type(fit_data_type), intent(in) :: data
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      call check_fit_data(data, error)
      if (allocated(error)) return
      if (any(data%has([column_u, column_v])) .and. .not. request%has_camera) call fail(error, code_input, data%file// &
         ':'//integer_text(data%header_line)//': columns u and v need a &camera group in the scene')
      if (.not. (allocated(error) .or. request%has_start) .and. (any(data%has(:column_crossing_time)) .or. &
         .not. data%has(column_period))) call fail(error, code_input, place_of(request%file, request%pendulum%line)// &
         '&pendulum has no start; give one, or free position and velocity (only of periods none is needed)')
      if (allocated(error) .or. .not. data%has(column_amplitude)) return
      do i = 1, data%rows
         if (.not. data%value(i, column_amplitude) >= merge(180.0_wp, acos(-1.0_wp), request%in_degrees)) cycle
         call fail(error, code_input, data%file//':'//integer_text(data%line(i))// &
            ': amplitude must be below half a turn')
         return
      end do
   end subroutine check_fit

   !> Fits. Errors: of the data, with file and line; of a scene that does not go with them. A result without a minimum
   !> has `is_converged` false.
   subroutine fit_measurements(request, data, result, error)
      type(fit_request_type), intent(in) :: request
      type(fit_data_type), intent(in) :: data
      type(fit_result_type), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error
      type(minimum_type) :: minimum
      real(wp), allocatable :: others(:, :, :)
      integer :: k

      result%known = ''
      call check_fit(request, data, error)
      if (allocated(error)) return
      call new_model(result%model, request, data, result%is_estimated)
      result%model%find_states => find_states
      call use_until(result%model, huge(1.0_wp), 1)
      result%dof = result%model%residuals - size(result%model%motion%of)
      if (result%dof < merge(1, 0, any(result%is_estimated))) then
         call fail(error, code_input, data%file//':'//integer_text(data%header_line)//': '// &
            integer_text(result%model%residuals)//' measured numbers for '//integer_text(size(result%model%motion%of)) &
            //' unknowns leave no degree of freedom')
         return
      end if
      call check_times(result, request, data, error)
      if (allocated(error)) return
      call search(result%model, request, .not. any(result%is_estimated), result%x, minimum, others)
      if (.not. minimum%squares < huge(1.0_wp)) then
         call use_until(result%model, huge(1.0_wp), 1)
         call place_at(result%model%motion, result%x)
         result%number = request%number
         call name_results(result, request)
         return
      end if
      call refit(result, minimum)
      result%iterations = minimum%iterations
      result%is_converged = minimum%is_found
      call find_sigmas(result, request)
      call leave_room(result%model)
      if (result%is_converged) result%is_converged = .not. (explains_nothing(result) .or. misses_jumps(result))
      if (.not. result%is_converged) then
         ! Where a search ended is no answer.
         do k = 1, size(result%of)
            result%of(k)%is_known = .false.
            result%of(k)%sigma = quiet_nan_real64
         end do
      end if
      call name_others(result, others)
      call look_at_units(result, data)
   end subroutine fit_measurements

   !> What t must be for the motion that is asked for.
   subroutine check_times(result, request, data, error)
      type(fit_result_type), intent(in) :: result
      type(fit_request_type), intent(in) :: request
      type(fit_data_type), intent(in) :: data
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: first, last
      !> A start as many times before the data as they last is not told by them, and hides the rest.
      real(wp), parameter :: far = 100

      associate (model => result%model)
         if (.not. model%motion%is_exact .and. size(model%times) > 0) then
            if (model%times(1) < 0 .and. .not. any(request%free%setting == setting_place(camera_group, &
               'time_offset'))) call fail(error, code_input, data%file//':'//integer_text(data%line(1))// &
               ': t must not be negative where the scene is integrated: it begins at t = 0')
         end if
         first = minval(model%all%time, model%all%time > -huge(first))
         last = maxval(model%all%time)
         if (allocated(error) .or. .not. (model%motion%is_position_free .or. model%motion%is_velocity_free)) return
         if (.not. (abs(first) > far*(last - first) .and. last > -huge(last))) return
         call fail(error, code_input, data%file//':'//integer_text(data%line(1))//': t begins at '// &
            digits_text(first, 7)//' s, and the data last '//digits_text(last - first, 3)// &
            ' s: position and velocity are those at t = 0; count t from near the first row')
      end associate
   end subroutine check_times

   !> Other minima as texts.
   subroutine name_others(result, others)
      type(fit_result_type), intent(inout) :: result
      real(wp), intent(in) :: others(:, :, :)
      character(len=:), allocatable :: text
      integer :: i, j, k

      allocate (result%others(0))
      do k = 1, size(others, 3)
         text = ''
         do i = 1, size(result%of)
            associate (one => result%of(i))
               text = text//trim(one%name)
               do j = 1, one%elements
                  text = text//' '//digits_text(others(j, one%setting, k), 7)
               end do
               text = text//'; '
            end associate
         end do
         call append(result%others, text(:len(text) - 2))
      end do
   end subroutine name_others

   !> Whether `plane` alone was to tell the start and is not explained: it jumps from one highest point to the next,
   !> where nothing has a slope, and a search may end with jumps at wrong times.
   pure logical function misses_jumps(result) result(does)
      type(fit_result_type), intent(in) :: result

      associate (m => result%model)
         does = (m%motion%is_position_free .or. m%motion%is_velocity_free) .and. all(m%all%column == column_plane) &
            .and. .not. any(result%is_estimated) .and. result%chi2 > result%dof + 6*sqrt(2.0_wp*result%dof)
      end associate
   end function misses_jumps

   !> From x on: with the delays of times that have errors, and the sigmas that are estimated, until they stay.
   subroutine refit(result, minimum)
      type(fit_result_type), intent(inout) :: result
      type(minimum_type), intent(inout) :: minimum
      integer :: round, rounds
      real(wp) :: change

      rounds = 1
      if (allocated(result%model%time_sigma)) rounds = 6
      if (any(result%is_estimated)) rounds = 8
      if (rounds == 1) return
      do round = 1, rounds
         if (allocated(result%model%time_sigma)) call move_delays(result)
         if (any(result%is_estimated)) call estimate_sigmas(result, change)
         call minimise_all(result%model, result%x, minimum)
         if (.not. minimum%squares < huge(1.0_wp)) return
         if (any(result%is_estimated)) then
            if (round > 1 .and. change < 1e-4_wp) exit
         end if
      end do
   end subroutine refit

   !> Whether each column's mean explains the data as well as the motion does: a search ends there for want of a slope.
   !> (Of the line of apsides a constant may be all there is to know, unless the bob is at rest; events are left out.)
   logical function explains_nothing(result) result(is)
      type(fit_result_type), intent(in) :: result
      real(wp), parameter :: sure = 3                    !! Times what chance explains
      real(wp), parameter :: turn = 2*acos(-1.0_wp)
      real(wp) :: mean, sums(2), f(2)
      integer :: i, j, n

      is = .false.
      if (.not. allocated(result%residual)) return
      if (.not. any(result%is_estimated) .and. result%chi2 < result%dof + 6*sqrt(2.0_wp*result%dof)) return
      associate (m => result%model, loss => result%model%loss)
         if (m%has_events .or. m%has_periods) return
         n = 0
         sums = 0
         do j = column_x, column_tension
            if (all(m%all(m%used)%column /= j)) cycle
            if (is_angle(j)) then
               mean = atan2(sum(sin(m%all(m%used)%value), m%all(m%used)%column == j), sum(cos(m%all(m%used)%value), &
                  m%all(m%used)%column == j))
            else if (loss == loss_squares) then
               mean = sum(m%all(m%used)%value, m%all(m%used)%column == j)/count(m%all(m%used)%column == j)
            else
               mean = median(pack(m%all(m%used)%value, m%all(m%used)%column == j))
            end if
            do i = 1, size(m%used)
               associate (one => m%all(m%used(i)))
                  if (one%column /= j) cycle
                  f = [one%value - mean, result%residual(i)]
                  if (is_angle(j)) f(1) = f(1) - turn*anint(f(1)/turn)
                  f(1) = f(1)/one%sigma
                  if (loss /= loss_squares) call soften(loss, m%loss_scale, f(1))
                  if (loss /= loss_squares) call soften(loss, m%loss_scale, f(2))
                  sums = sums + f**2
                  n = n + 1
               end associate
            end do
         end do
         if (n == 0) then
            is = is_still(m, result%number)
         else
            is = sums(1) - sums(2) < sure*size(result%x)*max(1.0_wp, sums(2)/max(1, n - size(result%x)))
         end if
      end associate
   end function explains_nothing

   !> Latent times to where they fit best.
   subroutine move_delays(result)
      type(fit_result_type), intent(inout) :: result
      real(wp) :: h(size(result%model%used)), rates(size(result%model%used)), up, down, a, row_delay
      logical :: failed
      integer :: i, first, n

      rates = 0
      call predict(result%model, result%x, h, failed, rates)
      if (failed) return
      n = size(result%model%used)
      associate (m => result%model)
         i = 1
         do while (i <= n)
            first = i
            up = 0
            down = 1
            do while (i <= n)
               associate (one => m%all(m%used(i)))
                  if (one%row /= m%all(m%used(first))%row) exit
                  if (one%time_place > 0 .and. m%time_sigma(one%row) > 0) then
                     a = rates(i)*m%time_sigma(one%row)/one%sigma
                     up = up + a*(h(i) - one%value)/one%sigma
                     down = down + a**2
                  end if
               end associate
               i = i + 1
            end do
            associate (row => m%all(m%used(first))%row, time => m%all(m%used(first))%time)
               if (m%all(m%used(first))%time_place == 0) cycle
               if (.not. m%time_sigma(row) > 0) cycle
               row_delay = m%delay(row) - m%time_sigma(row)*(up + m%delay(row)/m%time_sigma(row))/down
               if (time + row_delay >= 0 .or. m%motion%is_exact) m%delay(row) = row_delay
            end associate
         end do
      end associate
   end subroutine move_delays

   !> Sigmas from residuals, one for each group of columns: the sum of squares over what the parameters leave of the
   !> number of rows, each row by its leverage (so a parameter counts where it is determined).
   subroutine estimate_sigmas(result, change)
      type(fit_result_type), intent(inout) :: result
      real(wp), intent(out) :: change                    !! Relative, the largest
      real(wp) :: h(size(result%model%used)), f(result%model%residuals), sigma
      real(wp) :: jacobian(size(result%x), result%model%residuals), taken(result%model%residuals)
      logical :: failed, mine(size(result%model%used))
      integer :: i, j, n

      change = 0
      call result%model%evaluate(result%x, f, failed, jacobian)
      if (failed) return
      h = result%model%h
      call find_leverages(jacobian, taken)
      associate (m => result%model)
         n = size(m%used)
         do j = 1, maxval(sigma_groups)
            mine = [(result%is_estimated(m%all(m%used(i))%column) .and. sigma_groups(m%all(m%used(i))%column) == j, &
               i=1, n)]
            if (.not. any(mine)) cycle
            sigma = sqrt(sum((h - m%all(m%used)%value)**2, mine)/max(sum(1 - taken(:n), mine), 1e-3_wp*count(mine)))
            if (m%loss /= loss_squares) sigma = 1.4826_wp*median(pack(abs(h - m%all(m%used)%value), mine))
            if (.not. sigma > 0) sigma = tiny(sigma)**0.25_wp
            do i = 1, n
               if (.not. mine(i)) cycle
               change = max(change, abs(m%all(m%used(i))%sigma/sigma - 1))
               m%all(m%used(i))%sigma = sigma
            end do
         end do
      end associate
   end subroutine estimate_sigmas

   !> The part of each residual that the parameters take: the diagonal of J (J'J)**-1 J', which sums to their number.
   !> What a column adds to those before it is as nothing to rounding is left out.
   pure subroutine find_leverages(jacobian, taken)
      real(wp), intent(in) :: jacobian(:, :)             !! (p, rows)
      real(wp), intent(out) :: taken(:)
      real(wp) :: r(size(jacobian, 1), size(jacobian, 1)), y(size(jacobian, 1))
      real(wp), parameter :: nothing = 1e-9_wp
      integer :: i, j

      call triangle_of(jacobian, r)
      do i = 1, size(jacobian, 2)
         ! R'y = the row.
         do j = 1, size(y)
            y(j) = 0
            if (abs(r(j, j)) > nothing*norm2(r(:j, j))) &
               y(j) = (jacobian(j, i) - dot_product(r(:j - 1, j), y(:j - 1)))/r(j, j)
         end do
         taken(i) = sum(y**2)
      end do
   end subroutine find_leverages

   !> A pendulum of a kilometre is one of a metre in millimetres; a frequency may be an alias.
   subroutine look_at_units(result, data)
      type(fit_result_type), intent(inout) :: result
      type(fit_data_type), intent(in) :: data
      real(wp) :: length, gravity, gap, period

      if (.not. allocated(result%notes)) allocate (result%notes(0))
      length = result%number(1, setting_place(pendulum_group, 'length'))
      gravity = result%number(1, setting_place(pendulum_group, 'gravity'))
      if (length > 100 .or. length < 1e-3_wp) then
         call note('length fits at '//digits_text(length, 7)//' m: are the data in metres and seconds?')
      else if (any(result%of%setting == setting_place(pendulum_group, 'gravity')) .and. &
         (gravity > 100 .or. gravity < 0.1_wp)) then
         call note('gravity fits at '//digits_text(gravity, 7)//' m/s2: are the data in metres and seconds?')
      end if
      if (.not. result%is_converged .and. all(result%model%all%column == column_plane)) call note( &
         'plane alone tells how fast the line of apsides turns, and the rest only by its jumps: give another '// &
         'column, or a start near the true one')
      if (size(result%model%times) < 2) return
      associate (t => result%model%times)
         gap = minval(t(2:) - t(:size(t) - 1))
         period = 2*acos(-1.0_wp)*sqrt(length/gravity)
         if (3*gap > period .and. maxval(t(2:) - t(:size(t) - 1)) < 1.01_wp*gap) call note( &
            'rows at equal intervals, fewer than three a period, do not tell a frequency from its aliases: the '// &
            'lowest was looked for first (is t in seconds?)')
      end associate

   contains

      subroutine note(text)
         character(len=*), intent(in) :: text

         call append(result%notes, data%file//':'//integer_text(data%header_line)//': '//text)
      end subroutine note
   end subroutine look_at_units

end module kyvadlo_fit
