!> What a motion says of the measurements: residuals in sigmas and their derivatives by the unknowns.
module kyvadlo_fit_model
   use kyvadlo_fit_data
   use kyvadlo_fit_observation, only: camera_angle, camera_offset, camera_scale, observe, &
      observe_moved, period_of, to_event
   use kyvadlo_fit_physics, only: camera_type, direction_type, is_seen_otherwise, physics_type, show, &
      states_procedure, unit_period
   use kyvadlo_fit_request, only: loss_cauchy, loss_huber, loss_squares
   use kyvadlo_fit_unknowns, only: camera_at, numbers_at, outward_slopes, physics_at, unknowns_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_least_squares, only: least_squares_type
   use kyvadlo_scene_groups
   implicit none
   private
   public :: measurement_type, model_type, use_until, predict

   !> One measured number.
   type :: measurement_type
      integer :: column = 0, row = 0, time_place = 0      !! Place among the times
      real(wp) :: value = 0, sigma = 1, time = 0          !! Of an event its time is the value
      real(wp) :: amplitude = 0, amplitude_sigma = 0      !! Beside a period
   end type measurement_type

   !> Measurements up to some time and the unknowns.
   type, extends(least_squares_type) :: model_type
      procedure(states_procedure), pointer, nopass :: find_states => null()
      type(unknowns_type) :: motion
      type(measurement_type), allocatable :: all(:)       !! By column and row, those of a row together, times ascending
      integer, allocatable :: used(:)                     !! Places in `all`
      real(wp), allocatable :: times(:)                   !! Of rows in use, ascending
      real(wp), allocatable :: time_sigma(:), delay(:)    !! Of each: sigma of t, the latent time less t
      integer :: axes(2) = [1, 3]
      real(wp) :: until = huge(1.0_wp)
      integer :: loss = loss_squares
      real(wp) :: loss_scale = 1
      real(wp), allocatable :: pull(:), pull_to(:)        !! Weak springs that hold unknowns where few data do not
      integer, allocatable :: prior(:)                    !! Unknowns with one
      real(wp), allocatable :: prior_value(:), prior_sigma(:)
      !> Of each used measurement: what sigma_t makes of its variance
      real(wp), allocatable :: variance_factor(:)
   contains
      procedure :: evaluate => evaluate_model
   end type model_type

contains

   !> Takes into use what was measured until a time, one in `stride` rows.
   subroutine use_until(model, until, stride)
      type(model_type), intent(inout) :: model
      real(wp), intent(in) :: until
      integer, intent(in) :: stride
      integer, allocatable :: used(:)
      integer :: i, n, row

      model%until = until
      if (allocated(model%used)) deallocate (model%used)
      allocate (used(size(model%all)))
      n = 0
      do i = 1, size(model%all)
         if (model%all(i)%time > until) cycle
         if (stride > 1) then
            if (modulo(model%all(i)%row, stride) /= 0) cycle
         end if
         n = n + 1
         used(n) = i
      end do
      model%used = used(:n)
      if (allocated(model%times)) deallocate (model%times)
      allocate (model%times(size(model%used)))
      n = 0
      row = 0
      do i = 1, size(model%used)
         associate (one => model%all(model%used(i)))
            one%time_place = 0
            if (is_event(one%column) .or. one%column == column_period) cycle
            if (one%row /= row) then
               n = n + 1
               model%times(n) = one%time
               row = one%row
            end if
            one%time_place = n
         end associate
      end do
      model%times = model%times(:n)
      model%residuals = size(model%used)
      if (allocated(model%prior)) model%residuals = model%residuals + size(model%prior)
      if (allocated(model%pull)) model%residuals = model%residuals + size(model%pull)
      model%unknowns = size(model%motion%of)
   end subroutine use_until

   !> What the model says of the measurements in use, in their units, with derivatives.
   subroutine predict(model, x, h, failed, rates, derivatives)
      class(model_type), intent(inout) :: model
      real(wp), intent(in) :: x(:)
      real(wp), intent(out) :: h(:)                       !! (used)
      logical, intent(out) :: failed
      real(wp), intent(out) :: rates(:)                   !! (used) with time
      real(wp), intent(out), optional :: derivatives(:, :) !! (unknowns, used)
      real(wp) :: number(3, size(settings)), slopes(size(x))
      type(physics_type) :: physics
      type(direction_type) :: directions(size(x))
      type(camera_type) :: camera
      real(wp), allocatable :: states(:, :), matrices(:, :, :), times(:)
      integer :: i, k, n, parts(size(x))

      call physics_at(model%motion, x, number, physics, failed, directions)
      if (failed) return
      parts = 0
      do k = 1, size(x)
         associate (one => model%motion%of(k))
            if (one%setting == setting_place(camera_group, 'scale')) parts(k) = camera_scale
            if (one%setting == setting_place(camera_group, 'angle')) parts(k) = camera_angle
            if (one%setting == setting_place(camera_group, 'offset')) parts(k) = camera_offset + one%element - 1
         end associate
      end do
      call numbers_at(model%motion, x, number, slopes)
      call camera_at(model%motion, number, camera)
      n = size(model%times)
      allocate (states(6, n))
      times = model%times + camera%time_offset
      if (allocated(model%delay)) times = times + model%delay(model_rows(model))
      if (.not. physics%is_exact .and. n > 0) then
         failed = times(1) < 0
         if (failed) return
      end if
      if (present(derivatives)) then
         allocate (matrices(6, size(x), n))
         call model%find_states(physics, directions, times, states, failed, matrices)
      else
         call model%find_states(physics, directions, times, states, failed)
      end if
      if (failed) return
      ! Forces act relative to the pivot and in resting axes.
      do i = 1, size(model%used)
         associate (one => model%all(model%used(i)))
            if (one%column /= column_tension .and. one%column /= column_plane) cycle
            k = one%time_place
            if (present(derivatives)) then
               call observe_moved(one%column, one%value, physics, directions, times(k), states(:, k), h(i), &
                  rates(i), matrices(:, :, k), derivatives(:, i))
            else
               call observe_moved(one%column, one%value, physics, directions, times(k), states(:, k), h(i), &
                  rates(i))
            end if
         end associate
      end do
      if (is_seen_otherwise(physics, directions)) then
         do k = 1, n
            if (present(derivatives)) then
               call show(physics, directions, times(k), states(:, k), matrices(:, :, k))
            else
               call show(physics, directions, times(k), states(:, k))
            end if
         end do
      end if
      do i = 1, size(model%used)
         associate (one => model%all(model%used(i)))
            k = one%time_place
            if (k == 0 .or. one%column == column_tension .or. one%column == column_plane) cycle
            if (one%column <= column_z) then
               h(i) = states(one%column, k)
               rates(i) = states(one%column + 3, k)
               if (present(derivatives)) derivatives(:, i) = matrices(one%column, :, k)
            else if (present(derivatives)) then
               call observe(parts, model%axes, one%column, one%value, physics%length, slopes, camera, &
                  states(:, k), h(i), rates(i), matrices(:, :, k), derivatives(:, i))
            else
               call observe(parts, model%axes, one%column, one%value, physics%length, slopes, camera, &
                  states(:, k), h(i), rates(i))
            end if
         end associate
      end do
      if (present(derivatives)) then
         do k = 1, size(x)
            if (model%motion%of(k)%setting /= setting_place(camera_group, 'time_offset')) cycle
            do i = 1, size(model%used)
               if (model%all(model%used(i))%time_place > 0) &
                  derivatives(k, i) = derivatives(k, i) + rates(i)*slopes(k)
            end do
         end do
      end if
      ! An absent array is not handed on: gfortran would form its bounds from what its descriptor never held.
      if (present(derivatives)) then
         call predict_events(model, physics, directions, h, rates, failed, derivatives)
      else
         call predict_events(model, physics, directions, h, rates, failed)
      end if
      if (failed) return
      do i = 1, size(model%used)
         associate (one => model%all(model%used(i)))
            if (one%column /= column_period) cycle
            if (present(derivatives)) then
               call period_of(physics, directions, one%amplitude, h(i), derivatives(:, i))
            else
               call period_of(physics, directions, one%amplitude, h(i))
            end if
         end associate
      end do
   end subroutine predict

   !> Times at which the bob is at its lowest or highest, next to those measured.
   subroutine predict_events(model, physics, directions, h, rates, failed, derivatives)
      class(model_type), intent(in) :: model
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)
      real(wp), intent(inout) :: h(:), rates(:)
      logical, intent(inout) :: failed
      real(wp), intent(inout), optional :: derivatives(:, :)
      integer, allocatable :: events(:), order(:)
      real(wp), allocatable :: times(:), states(:, :), matrices(:, :, :)
      real(wp) :: lift
      integer :: i, j, k, pass
      integer, parameter :: passes = 4

      allocate (events(count([(is_event(model%all(model%used(i))%column), i=1, size(model%used))])))
      if (size(events) == 0) return
      k = 0
      do i = 1, size(model%used)
         if (.not. is_event(model%all(model%used(i))%column)) cycle
         k = k + 1
         events(k) = i
      end do
      allocate (states(6, size(events)), matrices(6, size(directions), size(events)))
      times = model%all(model%used(events))%value
      order = [(i, i=1, size(events))]
      do pass = 1, passes
         ! Ascending, of two columns of events too; where the motion is integrated, none before it began.
         if (.not. physics%is_exact) times = max(times, 0.0_wp)
         do i = 2, size(order)
            k = order(i)
            j = i - 1
            do while (j >= 1)
               if (times(order(j)) <= times(k)) exit
               order(j + 1) = order(j)
               j = j - 1
            end do
            order(j + 1) = k
         end do
         if (pass == passes .and. present(derivatives)) then
            call model%find_states(physics, directions, times(order), states, failed, matrices)
         else
            call model%find_states(physics, directions, times(order), states, failed)
         end if
         if (failed) return
         do i = 1, size(order)
            k = order(i)
            call to_event(physics, model%all(model%used(events(k)))%column == column_crossing_time, pass, &
               states(:, i), times(k), lift, failed)
            if (failed) return
            if (pass < passes) cycle
            h(events(k)) = times(k)
            rates(events(k)) = 0
            if (present(derivatives)) derivatives(:, events(k)) = -matrices(6, :, i)/lift
         end do
      end do
   end subroutine predict_events

   !> Rows of the times in use, as places in `delay`.
   pure function model_rows(model) result(rows)
      class(model_type), intent(in) :: model
      integer :: rows(size(model%times))
      integer :: i

      do i = 1, size(model%used)
         if (model%all(model%used(i))%time_place > 0) rows(model%all(model%used(i))%time_place) = &
            model%all(model%used(i))%row
      end do
   end function model_rows

   !> Residuals in sigmas, what the loss makes of them, priors and springs.
   subroutine evaluate_model(problem, x, f, failed, jacobian)
      class(model_type), intent(inout) :: problem
      real(wp), intent(in) :: x(:)
      real(wp), intent(out) :: f(:)
      logical, intent(out) :: failed
      real(wp), intent(out), optional :: jacobian(:, :)
      real(wp), allocatable :: h(:), rates(:)
      integer :: i, n, j, k

      n = size(problem%used)
      allocate (h(n), rates(n))
      rates = 0
      if (present(jacobian)) then
         call predict(problem, x, h, failed, rates, jacobian(:, :n))
      else
         call predict(problem, x, h, failed, rates)
      end if
      if (failed) return
      do i = 1, n
         associate (one => problem%all(problem%used(i)))
            f(i) = (h(i) - one%value)/one%sigma
            if (present(jacobian)) jacobian(:, i) = jacobian(:, i)/one%sigma
            if (one%column == column_period .and. one%amplitude_sigma > 0) call widen(i, one%amplitude_sigma* &
               (unit_period(one%amplitude + 1e-5_wp) - unit_period(one%amplitude - 1e-5_wp))/2e-5_wp*h(i)/ &
               unit_period(one%amplitude)/one%sigma)
         end associate
      end do
      if (allocated(problem%time_sigma)) then
         if (present(jacobian)) then
            call allow_for_time(problem, f, rates, jacobian)
         else
            call allow_for_time(problem, f, rates)
         end if
      end if
      if (problem%loss /= loss_squares) then
         do i = 1, n
            if (present(jacobian)) then
               call soften(problem%loss, problem%loss_scale, f(i), jacobian(:, i))
            else
               call soften(problem%loss, problem%loss_scale, f(i))
            end if
         end do
      end if
      k = n
      if (allocated(problem%prior)) then
         do j = 1, size(problem%prior)
            k = k + 1
            if (present(jacobian)) then
               call add_prior(problem, x, j, f(k), k, jacobian)
            else
               call add_prior(problem, x, j, f(k), k)
            end if
         end do
      end if
      if (allocated(problem%pull)) then
         do j = 1, size(problem%pull)
            k = k + 1
            f(k) = (x(j) - problem%pull_to(j))/problem%pull(j)
            if (present(jacobian)) then
               jacobian(:, k) = 0
               jacobian(j, k) = 1/problem%pull(j)
            end if
         end do
      end if
      if (present(jacobian)) failed = .not. all(abs(jacobian) <= huge(1.0_wp))
      if (present(jacobian)) problem%outward = outward_slopes(problem%motion, x)

   contains

      subroutine widen(i, more)
         integer, intent(in) :: i
         real(wp), intent(in) :: more
         real(wp) :: factor

         factor = 1/sqrt(1 + more**2)
         f(i) = f(i)*factor
         if (present(jacobian)) jacobian(:, i) = jacobian(:, i)*factor
      end subroutine widen
   end subroutine evaluate_model

   subroutine add_prior(problem, x, j, f, k, jacobian)
      class(model_type), intent(in) :: problem
      real(wp), intent(in) :: x(:)
      integer, intent(in) :: j, k
      real(wp), intent(out) :: f
      real(wp), intent(inout), optional :: jacobian(:, :)
      real(wp) :: number(3, size(settings))
      type(physics_type) :: physics
      logical :: failed

      f = (value_at(0.0_wp) - problem%prior_value(j))/problem%prior_sigma(j)
      if (.not. present(jacobian)) return
      jacobian(:, k) = 0
      jacobian(problem%prior(j), k) = (value_at(1e-6_wp) - value_at(-1e-6_wp))/2e-6_wp/problem%prior_sigma(j)

   contains

      real(wp) function value_at(step)
         real(wp), intent(in) :: step
         real(wp) :: y(size(x))

         y = x
         y(problem%prior(j)) = y(problem%prior(j)) + step
         call physics_at(problem%motion, y, number, physics, failed)
         value_at = number(problem%motion%of(problem%prior(j))%element, problem%motion%of(problem%prior(j))%setting)
      end function value_at
   end subroutine add_prior

   !> The errors of t: the residuals of one row together, by the inverse root of 1 + a a', a the rates in sigmas. That
   !> is
   !> what remains of the latent time once it is where it fits best (the delay moves the row there).
   subroutine allow_for_time(problem, f, rates, jacobian)
      class(model_type), intent(in) :: problem
      real(wp), intent(inout) :: f(:)
      real(wp), intent(in) :: rates(:)
      real(wp), intent(inout), optional :: jacobian(:, :)
      real(wp) :: a(columns), square, factor
      integer :: i, first, n

      i = 1
      n = size(problem%used)
      do while (i <= n)
         first = i
         do while (i <= n)
            if (problem%all(problem%used(i))%row /= problem%all(problem%used(first))%row) exit
            i = i + 1
         end do
         if (problem%all(problem%used(first))%time_place == 0) cycle
         associate (s => problem%time_sigma(problem%all(problem%used(first))%row), last => i - 1, &
               delay => problem%delay(problem%all(problem%used(first))%row))
            if (.not. s > 0) cycle
            a(:last - first + 1) = rates(first:last)*s/problem%all(problem%used(first:last))%sigma
            ! Back to the time that was read.
            f(first:last) = f(first:last) - a(:last - first + 1)*delay/s
            square = sum(a(:last - first + 1)**2)
            if (.not. square > 0) cycle
            factor = (1 - 1/sqrt(1 + square))/square
            f(first:last) = f(first:last) - factor*dot_product(a(:last - first + 1), f(first:last))*a(:last - first + 1)
            if (present(jacobian)) jacobian(:, first:last) = jacobian(:, first:last) - &
               factor*spread(matmul(jacobian(:, &
               first:last), a(:last - first + 1)), 2, last - first + 1)*spread(a(:last - first + 1), 1, &
                  size(jacobian, 1))
         end associate
      end do
   end subroutine allow_for_time

   !> A residual r becomes sqrt(2 rho(r)), whose square sums to the loss.
   pure subroutine soften(loss, scale, f, jacobian)
      integer, intent(in) :: loss
      real(wp), intent(in) :: scale
      real(wp), intent(inout) :: f
      real(wp), intent(inout), optional :: jacobian(:)
      real(wp) :: r, slope

      r = abs(f)/scale
      slope = 1
      if (loss == loss_huber .and. r > 1) then
         slope = 1/sqrt(2*r - 1)
         f = sign(scale*sqrt(2*r - 1), f)
      else if (loss == loss_cauchy .and. r > 1e-4_wp) then
         slope = r/((1 + r**2)*sqrt(log(1 + r**2)))
         f = sign(scale*sqrt(log(1 + r**2)), f)
      end if
      if (present(jacobian)) jacobian = jacobian*slope
   end subroutine soften

end module kyvadlo_fit_model
