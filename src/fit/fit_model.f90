!> What a motion says of the measurements: residuals in sigmas and their derivatives by the unknowns.
module kyvadlo_fit_model
   use kyvadlo_fit_data
   use kyvadlo_fit_physics, only: direction_type, gravity_felt, moved, physics_type, plane_of, states_procedure, &
      tension_of, unit_period
   use kyvadlo_fit_request, only: loss_cauchy, loss_huber, loss_squares
   use kyvadlo_fit_unknowns, only: camera_at, camera_type, physics_at, unknown_scalar, unknowns_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_least_squares, only: least_squares_type
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_scene_groups
   use kyvadlo_state_real64, only: new_orbit_from_state
   use kyvadlo_status, only: error_type
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
      integer :: i, n, row

      model%until = until
      model%used = pack([(i, i=1, size(model%all))], model%all%time <= until .and. &
         (modulo(model%all%row, stride) == 0 .or. stride == 1))
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
      real(wp), intent(out), optional :: rates(:)         !! (used) with time
      real(wp), intent(out), optional :: derivatives(:, :) !! (unknowns, used)
      real(wp) :: number(3, size(settings))
      type(physics_type) :: physics
      type(direction_type) :: directions(size(x))
      type(camera_type) :: camera
      real(wp), allocatable :: states(:, :), matrices(:, :, :), times(:)
      integer :: i, n

      call physics_at(model%motion, x, number, physics, failed, directions)
      if (failed) return
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
      do i = 1, size(model%used)
         associate (one => model%all(model%used(i)))
            if (one%time_place == 0) cycle
            if (present(derivatives)) then
               call observe(model, one%column, one%value, physics, directions, camera, times(one%time_place), &
                  states(:, one%time_place), h(i), rates(i), matrices(:, :, one%time_place), derivatives(:, i))
            else
               call observe(model, one%column, one%value, physics, directions, camera, times(one%time_place), &
                  states(:, one%time_place), h(i), rates(i))
            end if
         end associate
      end do
      call predict_events(model, physics, directions, h, rates, failed, derivatives)
      if (.not. failed) call predict_periods(model, physics, directions, h, derivatives)
   end subroutine predict

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

   !> One measured number from a state, its rate and its derivatives.
   subroutine observe(model, column, value, physics, directions, camera, time, state, h, rate, matrix, derivatives)
      class(model_type), intent(in) :: model
      integer, intent(in) :: column
      real(wp), intent(in) :: value                      !! Measured; angles count from the nearest turn
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)
      type(camera_type), intent(in) :: camera
      real(wp), intent(in) :: time, state(6)
      real(wp), intent(out) :: h, rate
      real(wp), intent(in), optional :: matrix(:, :)     !! (6, unknowns)
      real(wp), intent(out), optional :: derivatives(:)
      real(wp), parameter :: pi = acos(-1.0_wp), degree = pi/180
      real(wp) :: slope(6), c, s, a, b, square, step, speed
      integer :: j

      slope = 0
      select case (column)
      case (column_x:column_z)
         h = state(column)
         slope(column) = 1
      case (column_azimuth)
         square = max(state(1)**2 + state(2)**2, 1e-12_wp*physics%length**2)
         h = atan2(state(2), state(1))
         h = h + 2*pi*anint((value - h)/(2*pi))
         slope(1:2) = [-state(2), state(1)]/square
      case (column_angle)
         square = max(state(1)**2 + state(3)**2, 1e-12_wp*physics%length**2)
         h = atan2(state(1), -state(3))
         h = h + 2*pi*anint((value - h)/(2*pi))
         slope([1, 3]) = [-state(3), state(1)]/square
      case (column_u, column_v)
         c = camera%scale*cos(camera%angle)
         s = camera%scale*sin(camera%angle)
         a = state(model%axes(1)) + camera%offset(1)
         b = state(model%axes(2)) + camera%offset(2)
         if (column == column_u) then
            slope(model%axes) = [c, -s]
            h = c*a - s*b
         else
            slope(model%axes) = [s, c]
            h = s*a + c*b
         end if
      case (column_tension)
         h = tension_of(physics, time, state)
      case (column_plane)
         h = plane_of(physics, state)
         h = h + pi*anint((value - h)/pi)
      end select
      rate = dot_product(slope(1:3), state(4:6))
      if (.not. present(derivatives)) return
      if (column == column_tension .or. column == column_plane) then
         speed = sqrt(physics%length*physics%gravity)
         do j = 1, size(directions)
            associate (m => matrix(:, j))
               step = 1e-6_wp/max(maxval(abs(m(1:3)))/physics%length, maxval(abs(m(4:6)))/speed, &
                  abs(directions(j)%change%length)/physics%length, abs(directions(j)%change%gravity)/physics%gravity, &
                  1e-6_wp)
               if (column == column_tension) then
                  a = tension_of(moved(physics, directions(j), step), time, state + step*m)
                  b = tension_of(moved(physics, directions(j), -step), time, state - step*m)
               else
                  a = plane_of(moved(physics, directions(j), step), state + step*m)
                  b = plane_of(moved(physics, directions(j), -step), state - step*m)
                  a = a + pi*anint((b - a)/pi)
               end if
               derivatives(j) = (a - b)/(2*step)
            end associate
         end do
         return
      end if
      derivatives = matmul(slope, matrix)
      if (column /= column_u .and. column /= column_v) return
      do j = 1, size(directions)
         associate (one => model%motion%of(j))
            if (one%kind /= unknown_scalar) cycle
            if (settings(one%setting)%group /= camera_group) cycle
            select case (settings(one%setting)%name)
            case ('scale')
               derivatives(j) = derivatives(j) + h
            case ('angle')
               derivatives(j) = derivatives(j) + degree*one%scale*merge(-(s*a + c*b), c*a - s*b, column == column_u)
            case ('offset')
               derivatives(j) = derivatives(j) + slope(model%axes(one%element))*one%scale
            case ('time_offset')
               derivatives(j) = derivatives(j) + rate*one%scale
            end select
         end associate
      end do
   end subroutine observe

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
      real(wp) :: lift, felt, step
      integer :: i, j, k, pass
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      logical :: is_low

      allocate (events(count([(is_event(model%all(model%used(i))%column), i=1, size(model%used))])))
      if (size(events) == 0) return
      k = 0
      do i = 1, size(model%used)
         if (.not. is_event(model%all(model%used(i))%column)) cycle
         k = k + 1
         events(k) = i
      end do
      felt = gravity_felt(physics)
      allocate (states(6, size(events)), matrices(6, size(directions), size(events)))
      times = model%all(model%used(events))%value
      order = [(i, i=1, size(events))]
      do pass = 1, 4
         ! Ascending, of two columns of events too; none before the motion began.
         times = max(times, 0.0_wp)
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
         if (pass == 4 .and. present(derivatives)) then
            call model%find_states(physics, directions, times(order), states, failed, matrices)
         else
            call model%find_states(physics, directions, times(order), states, failed)
         end if
         if (failed) return
         do i = 1, size(order)
            associate (state => states(:, i), k => order(i))
               is_low = model%all(model%used(events(k)))%column == column_crossing_time
               lift = -felt - (dot_product(state(4:6), state(4:6)) - felt*state(3))*state(3)/dot_product(state(1:3), &
                  state(1:3))
               if (pass == 1 .or. (pass == 2 .and. (lift > 0 .neqv. is_low))) then
                  call new_orbit_from_state(orbit, norm2(state(1:3)), felt, state(1:3), state(4:6), error)
                  failed = allocated(error)
                  if (failed) return
                  step = orbit%next_turning_time(0.0_wp)
                  associate (half => orbit%period()/2)
                     failed = .not. (step <= huge(step) .and. half <= huge(half))
                     if (failed) return
                     if ((orbit%rise(step) < orbit%rise(step + half)) .neqv. is_low) step = step + half
                     if (step > half) step = step - 2*half
                     if (times(k) + step < 0) step = step + 2*half
                  end associate
               else
                  step = 0
                  if (abs(lift) > 0) step = -state(6)/lift
                  step = max(-0.1_wp, min(0.1_wp, step/sqrt(physics%length/physics%gravity)))*sqrt(physics%length/ &
                     physics%gravity)
               end if
               times(k) = times(k) + step
               if (pass < 4) cycle
               h(events(k)) = times(k)
               rates(events(k)) = 0
               if (present(derivatives)) derivatives(:, events(k)) = -matrices(6, :, i)/lift
            end associate
         end do
      end do
   end subroutine predict_events

   !> Periods of plane swings, to and fro, with their amplitudes.
   subroutine predict_periods(model, physics, directions, h, derivatives)
      class(model_type), intent(in) :: model
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)
      real(wp), intent(inout) :: h(:)
      real(wp), intent(inout), optional :: derivatives(:, :)
      real(wp) :: unit, r, a, gravity
      integer :: i, j

      do i = 1, size(model%used)
         associate (one => model%all(model%used(i)))
            if (one%column /= column_period) cycle
            unit = unit_period(one%amplitude)
            h(i) = sqrt(physics%length/gravity_felt(physics))*unit
            if (.not. present(derivatives)) cycle
            r = physics%effects%density_ratio
            a = physics%effects%added_mass
            do j = 1, size(directions)
               associate (change => directions(j)%change)
                  gravity = change%gravity/physics%gravity - change%effects%density_ratio*(1/(1 - r) + a/(1 + a*r)) - &
                     change%effects%added_mass*r/(1 + a*r)
                  derivatives(j, i) = h(i)/2*(change%length/physics%length - gravity)
               end associate
            end do
         end associate
      end do
   end subroutine predict_periods

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
      if (allocated(problem%time_sigma)) call allow_for_time(problem, f, rates, jacobian)
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
            call add_prior(problem, x, j, f(k), jacobian, k)
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

   subroutine add_prior(problem, x, j, f, jacobian, k)
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
