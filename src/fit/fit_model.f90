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

   !> What the unknowns say before a state is found, and which measurements in use are in hand: whole rows.
   type :: outlook_type
      type(physics_type) :: physics
      type(direction_type), allocatable :: directions(:)
      type(camera_type) :: camera
      real(wp), allocatable :: slopes(:)                  !! Of the numbers of unknowns that are scalars
      integer, allocatable :: parts(:)                    !! Of the camera, that the unknowns are
      real(wp), allocatable :: times(:)
      logical :: is_moved = .false.                       !! What is seen is not the state itself
      integer :: first = 1, last = 0                      !! In hand
      integer :: before = 0                               !! Times before theirs
   end type outlook_type

   !> Measurements in hand at once, where the closed form answers: their derivatives stay in the cache.
   integer, parameter :: block = 3000

contains

   !> What the model says of the measurements in use, in their units, and its rates with time.
   subroutine predict(model, x, h, failed, rates)
      class(model_type), intent(inout) :: model
      real(wp), intent(in) :: x(:)
      real(wp), intent(out) :: h(:)                       !! (used)
      logical, intent(out) :: failed
      real(wp), intent(inout) :: rates(:)                 !! (used); of events and periods as they are
      type(outlook_type) :: outlook

      call look_from(model, x, outlook, failed)
      if (failed) return
      outlook%last = size(model%used)
      call predict_rows(model, outlook, h, rates, failed)
   end subroutine predict

   subroutine look_from(model, x, outlook, failed)
      class(model_type), intent(in) :: model
      real(wp), intent(in) :: x(:)
      type(outlook_type), intent(out) :: outlook
      logical, intent(out) :: failed
      real(wp) :: number(3, size(settings))
      integer :: k

      allocate (outlook%directions(size(x)), outlook%slopes(size(x)), outlook%parts(size(x)))
      call physics_at(model%motion, x, number, outlook%physics, failed, outlook%directions)
      if (failed) return
      outlook%parts = 0
      do k = 1, size(x)
         associate (one => model%motion%of(k), part => outlook%parts(k))
            if (settings(one%setting)%group /= camera_group) cycle
            if (one%setting == setting_place(camera_group, 'scale')) part = camera_scale
            if (one%setting == setting_place(camera_group, 'angle')) part = camera_angle
            if (one%setting == setting_place(camera_group, 'offset')) part = camera_offset + one%element - 1
         end associate
      end do
      call numbers_at(model%motion, x, number, outlook%slopes)
      call camera_at(model%motion, number, outlook%camera)
      outlook%times = model%times + outlook%camera%time_offset
      if (allocated(model%delay)) outlook%times = outlook%times + model%delay(model_rows(model))
      if (.not. outlook%physics%is_exact .and. size(outlook%times) > 0) failed = outlook%times(1) < 0
      outlook%is_moved = is_seen_otherwise(outlook%physics, outlook%directions)
   end subroutine look_from

   !> The next measurements to take in hand.
   subroutine take_next(model, outlook)
      class(model_type), intent(in) :: model
      type(outlook_type), intent(inout) :: outlook
      integer :: n

      n = size(model%used)
      outlook%first = outlook%last + 1
      outlook%last = n
      if (.not. outlook%physics%is_exact .or. model%has_events .or. model%has_periods) return
      outlook%before = model%all(model%used(outlook%first))%time_place - 1
      outlook%last = min(n, outlook%first + block - 1)
      do while (outlook%last < n)
         if (model%all(model%used(outlook%last + 1))%row /= model%all(model%used(outlook%last))%row) exit
         outlook%last = outlook%last + 1
      end do
   end subroutine take_next

   !> Of the measurements in hand, with derivatives.
   subroutine predict_rows(model, outlook, h, rates, failed, derivatives)
      class(model_type), intent(inout) :: model
      type(outlook_type), intent(in) :: outlook
      real(wp), intent(inout) :: h(:), rates(:)           !! (used)
      logical, intent(out) :: failed
      real(wp), intent(inout), optional, contiguous :: derivatives(:, :) !! (unknowns, used)
      integer :: k, m

      m = size(outlook%times) - outlook%before
      if (outlook%last < size(model%used)) m = model%all(model%used(outlook%last))%time_place - outlook%before
      associate (physics => outlook%physics, directions => outlook%directions, &
            times => outlook%times(outlook%before + 1:outlook%before + m))
         call make_room(model, m, size(directions), merge(6, 3, outlook%is_moved .or. model%has_forces), &
            present(derivatives))
         ! An absent array is not handed on: gfortran would form its bounds from what its descriptor never held.
         if (present(derivatives)) then
            call model%find_states(physics, directions, times, model%states(:, :m), failed, model%matrices(:, :, :m))
         else
            call model%find_states(physics, directions, times, model%states(:, :m), failed)
         end if
         if (failed) return
         ! Forces act relative to the pivot and in resting axes.
         if (model%has_forces .and. present(derivatives)) then
            call predict_forces(model, outlook, h, rates, derivatives)
         else if (model%has_forces) then
            call predict_forces(model, outlook, h, rates)
         end if
         if (outlook%is_moved) then
            do k = 1, m
               if (present(derivatives)) then
                  call show(physics, directions, times(k), model%states(:, k), model%matrices(:, :, k))
               else
                  call show(physics, directions, times(k), model%states(:, k))
               end if
            end do
         end if
         if (present(derivatives)) then
            call predict_places(model, outlook, h, rates, derivatives)
         else
            call predict_places(model, outlook, h, rates)
         end if
         if (model%has_events .and. present(derivatives)) then
            call predict_events(model, physics, directions, h, rates, failed, derivatives)
         else if (model%has_events) then
            call predict_events(model, physics, directions, h, rates, failed)
         end if
         if (failed .or. .not. model%has_periods) return
         do k = outlook%first, outlook%last
            associate (one => model%all(model%used(k)))
               if (one%column /= column_period) cycle
               if (present(derivatives)) then
                  call period_of(physics, directions, one%amplitude, h(k), derivatives(:, k))
               else
                  call period_of(physics, directions, one%amplitude, h(k))
               end if
            end associate
         end do
      end associate
   end subroutine predict_rows

   !> Tension and plane, of states relative to the pivot and in resting axes.
   subroutine predict_forces(model, outlook, h, rates, derivatives)
      class(model_type), intent(in) :: model
      type(outlook_type), intent(in) :: outlook
      real(wp), intent(inout) :: h(:), rates(:)
      real(wp), intent(inout), optional :: derivatives(:, :)
      integer :: i, k

      do i = outlook%first, outlook%last
         associate (one => model%all(model%used(i)), physics => outlook%physics, directions => outlook%directions)
            if (one%column /= column_tension .and. one%column /= column_plane) cycle
            k = one%time_place - outlook%before
            if (present(derivatives)) then
               call observe_moved(one%column, one%value, physics, directions, outlook%times(one%time_place), &
                  model%states(:, k), h(i), rates(i), model%matrices(:, :, k), derivatives(:, i))
            else
               call observe_moved(one%column, one%value, physics, directions, outlook%times(one%time_place), &
                  model%states(:, k), h(i), rates(i))
            end if
         end associate
      end do
   end subroutine predict_forces

   !> What is seen of the states, and what a shift of the times does to all that has one.
   subroutine predict_places(model, outlook, h, rates, derivatives)
      class(model_type), intent(in) :: model
      type(outlook_type), intent(in) :: outlook
      real(wp), intent(inout) :: h(:), rates(:)
      real(wp), intent(inout), optional, contiguous :: derivatives(:, :)
      integer :: i, j, k

      do i = outlook%first, outlook%last
         associate (one => model%all(model%used(i)))
            if (one%time_place == 0 .or. one%column == column_tension .or. one%column == column_plane) cycle
            k = one%time_place - outlook%before
            if (one%column <= column_z) then
               h(i) = model%states(one%column, k)
               rates(i) = model%states(one%column + 3, k)
               if (.not. present(derivatives)) cycle
               do j = 1, size(outlook%slopes)
                  derivatives(j, i) = model%matrices(one%column, j, k)
               end do
            else if (present(derivatives)) then
               call observe(outlook%parts, model%axes, one%column, one%value, outlook%physics%length, outlook%slopes, &
                  outlook%camera, model%states(:, k), h(i), rates(i), model%matrices(:, :, k), derivatives(:, i))
            else
               call observe(outlook%parts, model%axes, one%column, one%value, outlook%physics%length, outlook%slopes, &
                  outlook%camera, model%states(:, k), h(i), rates(i))
            end if
         end associate
      end do
      if (.not. present(derivatives)) return
      do k = 1, size(outlook%slopes)
         if (model%motion%of(k)%setting /= setting_place(camera_group, 'time_offset')) cycle
         do i = outlook%first, outlook%last
            if (model%all(model%used(i))%time_place > 0) &
               derivatives(k, i) = derivatives(k, i) + rates(i)*outlook%slopes(k)
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
            if (.not. present(derivatives)) cycle
            ! A bob that air has brought to rest has no events.
            failed = .not. abs(lift) > tiny(lift)/epsilon(lift)
            if (failed) return
            derivatives(:, events(k)) = -matrices(6, :, i)/lift
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
      type(outlook_type) :: outlook
      integer :: n, j, k

      n = size(problem%used)
      call look_from(problem, x, outlook, failed)
      if (failed) return
      call move_alloc(problem%h, h)
      call move_alloc(problem%rates, rates)
      if (allocated(h)) then
         if (size(h) /= n) deallocate (h, rates)
      end if
      if (.not. allocated(h)) allocate (h(n), rates(n))
      rates = 0
      do while (outlook%last < n)
         call take_next(problem, outlook)
         if (present(jacobian)) then
            call predict_rows(problem, outlook, h, rates, failed, jacobian)
            if (.not. failed) call weigh_rows(problem, outlook, h, rates, f, failed, jacobian)
         else
            call predict_rows(problem, outlook, h, rates, failed)
            if (.not. failed) call weigh_rows(problem, outlook, h, rates, f, failed)
         end if
         if (failed) return
      end do
      k = n
      if (allocated(problem%prior)) then
         do j = 1, size(problem%prior)
            k = k + 1
            if (present(jacobian)) then
               call add_prior(problem, x, j, f(k), k, jacobian)
               failed = failed .or. .not. all(abs(jacobian(:, k)) <= huge(1.0_wp))
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
      if (present(jacobian)) problem%outward = outward_slopes(problem%motion, x)
      call move_alloc(h, problem%h)
      call move_alloc(rates, problem%rates)
   end subroutine evaluate_model

   !> Of the measurements in hand residuals in sigmas, after errors of t and the loss. Fails where derivatives are not
   !> finite.
   subroutine weigh_rows(model, outlook, h, rates, f, failed, jacobian)
      class(model_type), intent(in) :: model
      type(outlook_type), intent(in) :: outlook
      real(wp), intent(in) :: h(:), rates(:)
      real(wp), intent(inout) :: f(:)
      logical, intent(out) :: failed
      real(wp), intent(inout), optional, contiguous :: jacobian(:, :)
      real(wp) :: weight, total
      integer :: i, j

      total = 0
      do i = outlook%first, outlook%last
         associate (one => model%all(model%used(i)))
            weight = 1/one%sigma
            if (one%column == column_period .and. one%amplitude_sigma > 0) weight = weight/sqrt(1 + ( &
               one%amplitude_sigma*(unit_period(one%amplitude + 1e-5_wp) - unit_period(one%amplitude - 1e-5_wp))/ &
               2e-5_wp*h(i)/unit_period(one%amplitude)/one%sigma)**2)
            f(i) = (h(i) - one%value)*weight
         end associate
         if (.not. present(jacobian)) cycle
         do j = 1, size(jacobian, 1)
            jacobian(j, i) = jacobian(j, i)*weight
            total = total + abs(jacobian(j, i))
         end do
      end do
      failed = .not. total <= huge(total)
      if (failed) return
      if (allocated(model%time_sigma)) then
         if (present(jacobian)) then
            call allow_for_time(model, outlook, f, rates, jacobian)
         else
            call allow_for_time(model, outlook, f, rates)
         end if
      end if
      if (model%loss /= loss_squares) then
         do i = outlook%first, outlook%last
            if (present(jacobian)) then
               call soften(model%loss, model%loss_scale, f(i), jacobian(:, i))
            else
               call soften(model%loss, model%loss_scale, f(i))
            end if
         end do
      end if
   end subroutine weigh_rows

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
   subroutine allow_for_time(model, outlook, f, rates, jacobian)
      class(model_type), intent(in) :: model
      type(outlook_type), intent(in) :: outlook
      real(wp), intent(inout) :: f(:)
      real(wp), intent(in) :: rates(:)
      real(wp), intent(inout), optional, contiguous :: jacobian(:, :)
      real(wp) :: a(columns)
      integer :: i, first

      i = outlook%first
      do while (i <= outlook%last)
         first = i
         do while (i <= outlook%last)
            if (model%all(model%used(i))%row /= model%all(model%used(first))%row) exit
            i = i + 1
         end do
         if (model%all(model%used(first))%time_place == 0) cycle
         associate (s => model%time_sigma(model%all(model%used(first))%row), last => i - 1, &
               delay => model%delay(model%all(model%used(first))%row))
            if (.not. s > 0) cycle
            a(:last - first + 1) = rates(first:last)*s/model%all(model%used(first:last))%sigma
            if (present(jacobian)) then
               call allow_for_row(a(:last - first + 1), delay/s, f(first:last), jacobian(:, first:last))
            else
               call allow_for_row(a(:last - first + 1), delay/s, f(first:last))
            end if
         end associate
      end do
   end subroutine allow_for_time

end module kyvadlo_fit_model
