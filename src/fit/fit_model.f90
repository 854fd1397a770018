!> What a motion says of the measurements: residuals in sigmas and their derivatives by the unknowns.
module kyvadlo_fit_model
   use kyvadlo_fit_data
   use kyvadlo_fit_loss, only: allow_for_row, loss_squares, soften
   use kyvadlo_fit_observation, only: camera_angle, camera_offset, camera_scale, observe, &
      observe_moved, period_of, to_event
   use kyvadlo_fit_physics, only: camera_type, direction_type, is_seen_otherwise, physics_type, show, &
      states_procedure, unit_period
   use kyvadlo_fit_selection
   use kyvadlo_fit_unknowns, only: camera_at, numbers_at, outward_slopes, physics_at, unknowns_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_scene_groups
   implicit none
   private
   public :: measurement_type, model_type, use_until, count_until, leave_room, predict

   !> What a motion says of measurements in use.
   type, extends(selection_type) :: model_type
      type(unknowns_type) :: motion
      procedure(states_procedure), pointer, nopass :: find_states => null()
   contains
      procedure :: evaluate => evaluate_model
   end type model_type

contains

   !> What the model says of the measurements in use, in their units, with derivatives.
   subroutine predict(model, x, h, failed, rates, derivatives)
      class(model_type), intent(inout) :: model
      real(wp), intent(in) :: x(:)
      real(wp), intent(out) :: h(:)                       !! (used)
      logical, intent(out) :: failed
      real(wp), intent(out) :: rates(:)                   !! (used) with time
      real(wp), intent(out), optional, contiguous :: derivatives(:, :) !! (unknowns, used)
      real(wp) :: number(3, size(settings)), slopes(size(x))
      type(physics_type) :: physics
      type(direction_type) :: directions(size(x))
      type(camera_type) :: camera
      real(wp), allocatable :: times(:)
      integer :: k, parts(size(x))
      logical :: is_moved

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
      times = model%times + camera%time_offset
      if (allocated(model%delay)) times = times + model%delay(model_rows(model))
      if (.not. physics%is_exact .and. size(times) > 0) then
         failed = times(1) < 0
         if (failed) return
      end if
      is_moved = is_seen_otherwise(physics, directions)
      call make_room(model, size(x), merge(6, 3, is_moved .or. model%has_forces), present(derivatives))
      if (present(derivatives)) then
         call model%find_states(physics, directions, times, model%states, failed, model%matrices)
      else
         call model%find_states(physics, directions, times, model%states, failed)
      end if
      if (failed) return
      ! An absent array is not handed on: gfortran would form its bounds from what its descriptor never held.
      ! Forces act relative to the pivot and in resting axes.
      if (model%has_forces .and. present(derivatives)) then
         call predict_forces(model, physics, directions, times, h, rates, derivatives)
      else if (model%has_forces) then
         call predict_forces(model, physics, directions, times, h, rates)
      end if
      if (is_moved) then
         do k = 1, size(times)
            if (present(derivatives)) then
               call show(physics, directions, times(k), model%states(:, k), model%matrices(:, :, k))
            else
               call show(physics, directions, times(k), model%states(:, k))
            end if
         end do
      end if
      if (present(derivatives)) then
         call predict_places(model, physics, camera, parts, slopes, h, rates, derivatives)
      else
         call predict_places(model, physics, camera, parts, slopes, h, rates)
      end if
      if (model%has_events .and. present(derivatives)) then
         call predict_events(model, physics, directions, h, rates, failed, derivatives)
      else if (model%has_events) then
         call predict_events(model, physics, directions, h, rates, failed)
      end if
      if (failed .or. .not. model%has_periods) return
      do k = 1, size(model%used)
         associate (one => model%all(model%used(k)))
            if (one%column /= column_period) cycle
            if (present(derivatives)) then
               call period_of(physics, directions, one%amplitude, h(k), derivatives(:, k))
            else
               call period_of(physics, directions, one%amplitude, h(k))
            end if
         end associate
      end do
   end subroutine predict

   !> Tension and plane, of states relative to the pivot and in resting axes.
   subroutine predict_forces(model, physics, directions, times, h, rates, derivatives)
      class(model_type), intent(in) :: model
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)
      real(wp), intent(in) :: times(:)
      real(wp), intent(inout) :: h(:), rates(:)
      real(wp), intent(inout), optional :: derivatives(:, :)
      integer :: i, k

      do i = 1, size(model%used)
         associate (one => model%all(model%used(i)))
            if (one%column /= column_tension .and. one%column /= column_plane) cycle
            k = one%time_place
            if (present(derivatives)) then
               call observe_moved(one%column, one%value, physics, directions, times(k), model%states(:, k), h(i), &
                  rates(i), model%matrices(:, :, k), derivatives(:, i))
            else
               call observe_moved(one%column, one%value, physics, directions, times(k), model%states(:, k), h(i), &
                  rates(i))
            end if
         end associate
      end do
   end subroutine predict_forces

   !> What is seen of the states, and what a shift of the times does to all that has one.
   subroutine predict_places(model, physics, camera, parts, slopes, h, rates, derivatives)
      class(model_type), intent(in) :: model
      type(physics_type), intent(in) :: physics
      type(camera_type), intent(in) :: camera
      integer, intent(in) :: parts(:)
      real(wp), intent(in) :: slopes(:)
      real(wp), intent(inout) :: h(:), rates(:)
      real(wp), intent(inout), optional, contiguous :: derivatives(:, :)
      integer :: i, j, k

      do i = 1, size(model%used)
         associate (one => model%all(model%used(i)))
            k = one%time_place
            if (k == 0 .or. one%column == column_tension .or. one%column == column_plane) cycle
            if (one%column <= column_z) then
               h(i) = model%states(one%column, k)
               rates(i) = model%states(one%column + 3, k)
               if (.not. present(derivatives)) cycle
               do j = 1, size(slopes)
                  derivatives(j, i) = model%matrices(one%column, j, k)
               end do
            else if (present(derivatives)) then
               call observe(parts, model%axes, one%column, one%value, physics%length, slopes, camera, &
                  model%states(:, k), h(i), rates(i), model%matrices(:, :, k), derivatives(:, i))
            else
               call observe(parts, model%axes, one%column, one%value, physics%length, slopes, camera, &
                  model%states(:, k), h(i), rates(i))
            end if
         end associate
      end do
      if (.not. present(derivatives)) return
      do k = 1, size(slopes)
         if (model%motion%of(k)%setting /= setting_place(camera_group, 'time_offset')) cycle
         do i = 1, size(model%used)
            if (model%all(model%used(i))%time_place > 0) &
               derivatives(k, i) = derivatives(k, i) + rates(i)*slopes(k)
         end do
      end do
   end subroutine predict_places

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
      real(wp), intent(out), optional, contiguous :: jacobian(:, :)
      real(wp), allocatable :: h(:), rates(:)
      real(wp) :: weight
      integer :: i, n, j, k

      n = size(problem%used)
      call move_alloc(problem%h, h)
      call move_alloc(problem%rates, rates)
      if (allocated(h)) then
         if (size(h) /= n) deallocate (h, rates)
      end if
      if (.not. allocated(h)) allocate (h(n), rates(n))
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
            if (present(jacobian)) then
               weight = 1/one%sigma
               do j = 1, size(x)
                  jacobian(j, i) = jacobian(j, i)*weight
               end do
            end if
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
      call move_alloc(h, problem%h)
      call move_alloc(rates, problem%rates)

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

   !> The errors of t, row by row.
   subroutine allow_for_time(problem, f, rates, jacobian)
      class(model_type), intent(in) :: problem
      real(wp), intent(inout) :: f(:)
      real(wp), intent(in) :: rates(:)
      real(wp), intent(inout), optional, contiguous :: jacobian(:, :)
      real(wp) :: a(columns)
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
            if (present(jacobian)) then
               call allow_for_row(a(:last - first + 1), delay/s, f(first:last), jacobian(:, first:last))
            else
               call allow_for_row(a(:last - first + 1), delay/s, f(first:last))
            end if
         end associate
      end do
   end subroutine allow_for_time

end module kyvadlo_fit_model
