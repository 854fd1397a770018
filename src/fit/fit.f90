!> From measurements to the pendulum that made them: the best minimum, standard deviations, and what the data cannot
!> tell.
module kyvadlo_fit
   use, intrinsic :: iso_c_binding, only: c_double
   use kyvadlo_fit_data
   use kyvadlo_fit_known, only: say_known
   use kyvadlo_fit_model, only: model_type, predict, use_until
   use kyvadlo_fit_motion, only: find_states
   use kyvadlo_fit_physics, only: direction_type, physics_type
   use kyvadlo_fit_places, only: new_model, sigma_groups
   use kyvadlo_fit_request, only: fit_request_type, loss_squares
   use kyvadlo_fit_result, only: fit_result_type, fitted_type
   use kyvadlo_fit_search, only: minimise_all, search
   use kyvadlo_fit_unknowns, only: form_logarithm, form_plain, numbers_at, physics_at, place_at, unknown_position, &
      unknown_scalar, &
      unknown_velocity
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_lapack, only: dgesvd
   use kyvadlo_least_squares, only: minimum_type
   use kyvadlo_number_text, only: digits_text
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_scene_groups
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: append, integer_text, text_type
   implicit none
   private
   public :: fit_result_type, fitted_type, check_fit, fit_measurements, refit, find_sigmas

   interface
      function gsl_gamma_q(a, x) bind(c, name='gsl_sf_gamma_inc_Q') result(q)
         import :: c_double
         real(c_double), value :: a, x
         real(c_double) :: q
      end function gsl_gamma_q
   end interface

contains

   !> What can be said against the data, and against the scene for them, before anything is computed.
   subroutine check_fit(request, data, error)
      type(fit_request_type), intent(in) :: request
      type(fit_data_type), intent(in) :: data
      type(error_type), allocatable, intent(out) :: error

      call check_fit_data(data, error)
      if (allocated(error)) return
      if (any(data%has([column_u, column_v])) .and. .not. request%has_camera) call fail(error, code_input, data%file// &
         ':'//integer_text(data%header_line)//': columns u and v need a &camera group in the scene')
   end subroutine check_fit

   !> Fits. Errors: of the data, with file and line; of a scene that does not go with them. A result without a minimum
   !> has
   !> `is_converged` false.
   subroutine fit_measurements(request, data, result, error)
      type(fit_request_type), intent(in) :: request
      type(fit_data_type), intent(in) :: data
      type(fit_result_type), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error
      type(minimum_type) :: minimum
      real(wp), allocatable :: others(:, :, :)
      integer :: i, j, k, lines
      character(len=:), allocatable :: text

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
      if (.not. result%model%motion%is_exact .and. size(result%model%times) > 0) then
         if (result%model%times(1) < 0 .and. .not. any(request%free%setting == setting_place(camera_group, &
            'time_offset'))) then
            call fail(error, code_input, data%file//':'//integer_text(data%line(1))// &
               ': t must not be negative where the scene is integrated: it begins at t = 0')
            return
         end if
      end if
      call search(result%model, request, result%x, minimum, others)
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
      if (.not. result%is_converged) then
         ! Where a search ended is no answer.
         do k = 1, size(result%of)
            result%of(k)%is_known = .false.
            result%of(k)%sigma = quiet_nan_real64
         end do
      end if
      lines = size(others, 3)
      allocate (result%others(0))
      do k = 1, lines
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
      call look_at_units(result)
   end subroutine fit_measurements

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

   !> Sigmas from residuals, one for each group of columns.
   subroutine estimate_sigmas(result, change)
      type(fit_result_type), intent(inout) :: result
      real(wp), intent(out) :: change                    !! Relative, the largest
      real(wp) :: h(size(result%model%used)), sigma
      logical :: failed, mine(size(result%model%used))
      integer :: i, j, n

      change = 0
      call predict_values(result, h, failed)
      if (failed) return
      associate (m => result%model)
         n = size(m%used)
         do j = 1, maxval(sigma_groups)
            mine = [(result%is_estimated(m%all(m%used(i))%column) .and. sigma_groups(m%all(m%used(i))%column) == j, &
               i=1, n)]
            if (.not. any(mine)) cycle
            sigma = sqrt(sum((h - m%all(m%used)%value)**2, mine)/(count(mine)*(1 - size(result%x)/real(n, wp))))
            if (m%loss /= loss_squares) sigma = 1.4826_wp*median_of(pack(abs(h - m%all(m%used)%value), mine))
            if (.not. sigma > 0) sigma = tiny(sigma)**0.25_wp
            do i = 1, n
               if (.not. mine(i)) cycle
               change = max(change, abs(m%all(m%used(i))%sigma/sigma - 1))
               m%all(m%used(i))%sigma = sigma
            end do
         end do
      end associate
   end subroutine estimate_sigmas

   real(wp) function median_of(values) result(median)
      real(wp), intent(in) :: values(:)
      real(wp) :: low, high
      integer :: step

      low = 0
      high = maxval(values)
      do step = 1, 60
         median = (low + high)/2
         if (2*count(values <= median) >= size(values)) then
            high = median
         else
            low = median
         end if
      end do
   end function median_of

   !> Predictions of everything, at the delays.
   subroutine predict_values(result, h, failed)
      type(fit_result_type), intent(inout) :: result
      real(wp), intent(out) :: h(:)
      logical, intent(out) :: failed
      real(wp) :: rates(size(h))

      rates = 0
      call predict(result%model, result%x, h, failed, rates)
   end subroutine predict_values

   !> The covariance by the singular values of the derivatives in natural units. A direction that could be changed by
   !> its
   !> natural size within one sigma is not determined.
   subroutine find_sigmas(result, request)
      type(fit_result_type), intent(inout) :: result
      type(fit_request_type), intent(in) :: request
      real(wp), parameter :: least_singular = 1, rounding = 1e-11_wp, least_part = 0.3_wp
      real(wp), allocatable :: jacobian(:, :), f(:), matrix(:, :), work(:), d(:, :), spread_of(:, :), parts(:)
      real(wp) :: s(size(result%x)), vt(size(result%x), size(result%x)), u(1, 1), number(3, size(settings)), natural
      real(wp) :: part, floor, rates(size(result%x)), growth
      type(model_type) :: model
      type(physics_type) :: physics
      type(direction_type) :: directions(size(result%x))
      logical :: failed, is_out(size(result%x)), is_plain
      integer :: p, m, i, j, k, n, info
      character(len=:), allocatable :: names

      p = size(result%x)
      model = result%model
      ! By the settings themselves: bounds have no part in sigmas.
      call numbers_at(model%motion, result%x, number, rates)
      call physics_at(model%motion, result%x, number, physics, failed)
      model%motion%number = number
      do j = 1, p
         if (model%motion%of(j)%form /= form_logarithm) model%motion%of(j)%form = form_plain
      end do
      call place_at(model%motion, result%x)
      result%model%motion = model%motion
      result%number = number
      call name_results(result, request)
      m = model%residuals
      allocate (jacobian(p, m), f(m))
      call model%evaluate(result%x, f, failed, jacobian)
      if (allocated(result%undetermined)) deallocate (result%undetermined)
      allocate (result%undetermined(0))
      if (failed) then
         result%is_converged = .false.
         return
      end if
      call keep_residuals(result)
      matrix = transpose(jacobian)
      allocate (work(10*p + 2*m))
      call dgesvd('N', 'A', m, p, matrix, m, s, u, 1, vt, p, work, size(work), info)
      if (info /= 0) then
         result%is_converged = .false.
         return
      end if
      result%condition = s(1)/max(s(p), tiny(1.0_wp))
      is_out = s < max(least_singular, rounding*s(1))
      floor = max(rounding*s(1), tiny(1.0_wp))
      call physics_at(model%motion, result%x, number, physics, failed, directions)
      n = result%of(size(result%of))%first + result%of(size(result%of))%elements - 1
      allocate (d(n, p), parts(n))
      d = 0
      call numbers_at(model%motion, result%x, number, rates)
      do i = 1, size(result%of)
         associate (one => result%of(i))
            select case (kind_of(one%setting))
            case (unknown_position)
               do j = 1, p
                  d(one%first:one%first + 2, j) = directions(j)%change%position
               end do
            case (unknown_velocity)
               do j = 1, p
                  d(one%first:one%first + 2, j) = directions(j)%change%velocity
               end do
            case default
               do j = 1, p
                  if (model%motion%of(j)%setting == one%setting) d(one%first + model%motion%of(j)%element - 1, j) = &
                     rates(j)
               end do
            end select
         end associate
      end do
      ! (n, p) each element along each direction.
      spread_of = matmul(d, transpose(vt))
      allocate (result%covariance(n, n))
      result%covariance = 0
      do j = 1, p
         if (is_out(j)) cycle
         do k = 1, n
            result%covariance(:, k) = result%covariance(:, k) + spread_of(:, j)*spread_of(k, j)/s(j)**2
         end do
      end do
      do i = 1, size(result%of)
         associate (one => result%of(i))
            do k = 1, one%elements
               natural = natural_size(one%setting, one%first + k - 1)
               part = sqrt(sum((spread_of(one%first + k - 1, :)/max(s, floor))**2, is_out))
               parts(one%first + k - 1) = part
               one%is_known(k) = .not. part > least_part*natural
               if (one%is_known(k)) result%covariance(one%first + k - 1, one%first + k - 1) = &
                  result%covariance(one%first + k - 1, one%first + k - 1) + &
                  sum((spread_of(one%first + k - 1, :)/s)**2, is_out .and. s > floor)
               one%sigma(k) = sqrt(result%covariance(one%first + k - 1, one%first + k - 1))
               if (.not. one%is_known(k)) one%sigma(k) = quiet_nan_real64
            end do
         end associate
      end do
      do j = p, 1, -1
         if (.not. is_out(j)) exit
         names = ''
         do i = 1, size(result%of)
            associate (one => result%of(i))
               ! Position and velocity grow with the length: that is the length's, not theirs.
               growth = 0
               if (kind_of(one%setting) /= unknown_scalar) growth = growth_of_length(spread_of(:, j))
               is_plain = .true.
               do k = 1, one%elements
                  ! Of an unknown number, those directions that matter.
                  if (.not. one%is_known(k) .and. abs(spread_of(one%first + k - 1, j) - growth*one%value(k)) > &
                     0.1_wp*max(s(j), floor)*parts(one%first + k - 1)) is_plain = .false.
               end do
               if (.not. is_plain) names = names//'/'//trim(one%name)
            end associate
         end do
         if (len(names) > 1) call add_new(result%undetermined, names(2:))
      end do
      call say_known(result, spread_of, s, is_out)

   contains

      integer function kind_of(setting)
         integer, intent(in) :: setting

         kind_of = unknown_scalar
         if (setting == setting_place(pendulum_group, 'position')) kind_of = unknown_position
         if (setting == setting_place(pendulum_group, 'velocity')) kind_of = unknown_velocity
      end function kind_of

      !> Relative, along a direction; 0 where the length is known.
      real(wp) function growth_of_length(along) result(growth)
         real(wp), intent(in) :: along(:)
         integer :: i

         i = findloc(result%of%setting, setting_place(pendulum_group, 'length'), 1)
         growth = 0
         if (i > 0) growth = along(result%of(i)%first)/physics%length
      end function growth_of_length

      real(wp) function natural_size(setting, row)
         integer, intent(in) :: setting, row

         select case (kind_of(setting))
         case (unknown_position)
            natural_size = physics%length
         case (unknown_velocity)
            natural_size = max(sqrt(physics%gravity*physics%length), norm2(physics%velocity))
         case default
            natural_size = maxval(abs(d(row, :)))
         end select
      end function natural_size
   end subroutine find_sigmas

   subroutine add_new(texts, text)
      type(text_type), allocatable, intent(inout) :: texts(:)
      character(len=*), intent(in) :: text
      integer :: i

      do i = 1, size(texts)
         if (texts(i)%text == text) return
      end do
      call append(texts, text)
   end subroutine add_new

   !> Names and values of the free settings.
   subroutine name_results(result, request)
      type(fit_result_type), intent(inout) :: result
      type(fit_request_type), intent(in) :: request
      integer :: i, first

      if (allocated(result%of)) deallocate (result%of)
      allocate (result%of(size(request%free)))
      first = 1
      do i = 1, size(request%free)
         associate (one => result%of(i))
            one%name = request%free(i)%name
            one%setting = request%free(i)%setting
            one%elements = settings(one%setting)%values
            one%first = first
            one%value = result%number(:, one%setting)
            one%sigma = quiet_nan_real64
            first = first + one%elements
         end associate
      end do
   end subroutine name_results

   !> Predictions, residuals, chi2 and its probability.
   subroutine keep_residuals(result)
      type(fit_result_type), intent(inout) :: result
      real(wp) :: f(result%model%residuals)
      logical :: failed
      integer :: n, loss

      n = size(result%model%used)
      if (allocated(result%predicted)) deallocate (result%predicted, result%residual)
      allocate (result%predicted(n), result%residual(n))
      call predict_values(result, result%predicted, failed)
      loss = result%model%loss
      result%model%loss = loss_squares
      call result%model%evaluate(result%x, f, failed)
      result%model%loss = loss
      result%residual = -f(:n)
      result%chi2 = sum(f**2)
      result%p_value = 0
      if (result%dof < 1) then
         result%p_value = 1
      else if (result%chi2 < result%dof - 30*sqrt(2.0_wp*result%dof)) then
         result%p_value = 1
      else if (result%chi2 < result%dof + 30*sqrt(2.0_wp*result%dof)) then
         result%p_value = gsl_gamma_q(result%dof/2.0_wp, result%chi2/2)
      end if
   end subroutine keep_residuals

   !> A pendulum of a kilometre is one of a metre in millimetres.
   subroutine look_at_units(result)
      type(fit_result_type), intent(inout) :: result
      real(wp) :: length, gravity

      if (.not. allocated(result%notes)) allocate (result%notes(0))
      length = result%number(1, setting_place(pendulum_group, 'length'))
      gravity = result%number(1, setting_place(pendulum_group, 'gravity'))
      if (length > 100 .or. length < 1e-3_wp) call append(result%notes, 'length fits at '//digits_text(length, 7)// &
         ' m: are the data in metres and seconds?')
      if (any(result%of%setting == setting_place(pendulum_group, 'gravity')) .and. (gravity > 100 .or. gravity < &
         0.1_wp)) &
         call append(result%notes, 'gravity fits at '//digits_text(gravity, 7)// &
         ' m/s2: are the data in metres and seconds?')
   end subroutine look_at_units

end module kyvadlo_fit
