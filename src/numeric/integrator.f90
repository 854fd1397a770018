!> The motion under effects that have no closed form, at any number of ascending times in bounded memory.
!>
!>    call new_integration(run, effects, length, gravity, position, velocity, tolerance, error)
!>    call run%advance(times, positions, velocities, tensions, drag_work, pivot_work, error)   ! block by block
!>    call run%finish()
!>
!> The integrator takes the steps that the tolerance asks for, however many times are asked for: where there are several
!> in a step they are taken from a polynomial through the ends of the last steps (kyvadlo_dense_output), if it satisfies
!> the equations of motion within the tolerance, and else from a step of their own. Derivatives with respect to
!> `changes` of the start, length, gravity and effects come with it on request, by the variational equations.
module kyvadlo_integrator
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: is_finite, quiet_nan_real64
   use kyvadlo_status, only: error_type, fail, code_domain, code_unsupported
   use kyvadlo_effects, only: effects_type
   use kyvadlo_forces, only: forces_type, lengthen, move, new_forces
   use kyvadlo_force_changes, only: change_type
   use kyvadlo_pivot, only: last_time, pivot_speed
   use kyvadlo_integrated_columns
   use kyvadlo_integration_start, only: begin_motion
   use kyvadlo_suspension, only: put_on_surface
   use kyvadlo_knots, only: pass_knot, show_behind_knot, show_columns_behind_knot
   use kyvadlo_dense_output, only: interpolant_type, add_node, clear, defect_point, defect_to_position, &
      defect_to_velocity, interpolate, nodes, prepare
   use kyvadlo_stepper, only: stepper_type, free_stepper, new_stepper, take_step, trial_step, unknowns, works
   use kyvadlo_string, only: event_slack, string_event_type
   use kyvadlo_string_contact, only: contact_type, find_contact, make_contact
   use kyvadlo_turned_azimuth, only: is_upright, turned_azimuth
   implicit none
   private
   public :: integration_type, new_integration
   public :: failure_request, failure_short_step, failure_events, failure_steps, failure_tangential

   !> Why `advance` failed.
   integer, parameter :: failure_request = 1      !! It was called wrongly
   integer, parameter :: failure_short_step = 2   !! No step is short enough: the motion is singular there, or too stiff
   integer, parameter :: failure_events = 3       !! The string went slack too often
   integer, parameter :: failure_steps = 4        !! More steps than `most_steps`
   integer, parameter :: failure_tangential = 5   !! There are no derivatives beyond an event met tangentially
   integer, parameter :: unknown = 0, by_polynomial = 1, by_steps = 2

   !> A run in progress. Read the public components; change none, and do not copy a run.
   type :: integration_type
      type(string_event_type), allocatable :: events(:) !! Of a string, as they come; the first `event_count` count
      integer :: event_count = 0                       !! Places are relative to the pivot
      integer(int64) :: steps = 0, rejected = 0        !! Steps taken, and steps repeated
      !> Samples between steps, by polynomial and by a step of their own
      integer(int64) :: interpolated = 0, stepped = 0
      integer :: failure = 0                           !! One of the `failure_*` constants after an error of `advance`
      real(wp) :: time = 0, step_start = 0             !! How far the integration got, and by its last step from [s]
      real(wp) :: most_steps = huge(1.0_wp)            !! Taken and repeated; more fail
      integer(int64) :: evaluations = 0                !! Of the right side, by GSL
      type(stepper_type), private :: stepper
      type(columns_type), private :: columns
      type(contact_type), private :: contact
      type(interpolant_type), private :: interpolant
      real(wp), private :: tolerance = 0, unit_length = 1, unit_speed = 1
      real(wp), private :: last_time = 0               !! Of the last sample [s]
      real(wp), private :: work_time = 0, work(2) = 0  !! Works known last within the present step
      real(wp), private :: ends = huge(1.0_wp)         !! Of the tables of pivot and winch, or of all length [s]
      logical, private :: has_contact = .false.        !! The last step ended where the string goes slack or taut
      logical, private :: is_at_knot = .false.         !! ... or at a knot of a table
      integer, private :: between = unknown            !! How samples in the last step are found
      logical, private :: with_azimuth = .false.
      !> At both ends of the last step, turns counted; NaN while the bob has not left the axis [rad]
      real(wp) :: azimuth = 0, azimuth_before = 0
      real(wp) :: first_azimuth = 0                    !! The first one known; NaN as long as there is none [rad]
   contains
      procedure, non_overridable :: advance, step_on, within, columns_within, finish
   end type integration_type

   !> A motion of more slack and taut stretches than this fails, as in kyvadlo_string: 6 MB of events.
   integer, parameter :: most_events = 100000
   !> Part of sqrt(length/gravity) for the first step; steps grow by up to 5, so that four find their length.
   real(wp), parameter :: first_step = 1e-3_wp
   !> Abscissas and weights of Gauss's rule with five points on [-1, 1] (DLMF 3.5.v).
   real(wp), parameter :: gauss_abscissas(5) = [-0.906179845938663992797627_wp, -0.538469310105683091036314_wp, &
      0.0_wp, 0.538469310105683091036314_wp, 0.906179845938663992797627_wp]
   real(wp), parameter :: gauss_weights(5) = [0.236926885056189087514264_wp, 0.478628670499366468041292_wp, &
      0.568888888888888888888889_wp, 0.478628670499366468041292_wp, 0.236926885056189087514264_wp]

contains

   !> A start at time 0. The tolerance is that of the error of a step, in units of the length and of
   !> sqrt(gravity length + squares of the speeds of start, wind and pivot).
   !>
   !> Where it may start says `begin_motion`; a string that is slack at the start has its first event there.
   !>
   !> On the axis the azimuth is where the bob moves, or is about to; `azimuth` says it of one that nothing moves yet.
   subroutine new_integration(run, effects, length, gravity, position, velocity, tolerance, error, with_work, &
      with_azimuth, azimuth, most_steps, changes)
      type(integration_type), intent(inout) :: run
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: length, gravity           !! [m], [m/s2]
      real(wp), intent(in) :: position(3), velocity(3)  !! Relative to the pivot [m], [m/s]
      real(wp), intent(in) :: tolerance                 !! 1e-15 to 0.1
      type(error_type), allocatable, intent(out) :: error
      logical, intent(in), optional :: with_work        !! .false.: works are not wanted, and zero (default .true.)
      logical, intent(in), optional :: with_azimuth  !! Turns are counted, for `azimuths` of `advance` (default .false.)
      real(wp), intent(in), optional :: azimuth         !! Of the direction in which it will leave the axis [rad]
      real(wp), intent(in), optional :: most_steps      !! More steps, taken and repeated, fail
      type(change_type), intent(in), optional :: changes(:) !! (p) for `matrices` of `advance`
      type(forces_type) :: forces
      real(wp) :: p(3), v(3), slack
      logical :: is_taut, wants_work, was_put(2)

      call run%finish()
      call new_forces(forces, effects, length, gravity, error)
      if (allocated(error)) return
      p = position
      v = velocity
      if (.not. (tolerance >= 1e-15_wp .and. tolerance <= 0.1_wp)) then
         call fail(error, code_domain, 'integrate: the tolerance must lie between 1e-15 and 0.1, got'// &
            listed([tolerance]))
      else if (allocated(effects%pivot_times)) then
         if (effects%pivot_times(1) > 0) &
            call fail(error, code_domain, 'integrate: the table of the pivot must begin at time 0 or before')
      end if
      run%ends = last_time(effects, length)
      if (allocated(error)) return
      call begin_motion(forces, p, v, is_taut, slack, error, was_put)
      if (allocated(error)) error%message = 'integrate: '//error%message
      if (allocated(error)) return
      wants_work = .true.
      if (present(with_work)) wants_work = with_work
      if (present(with_azimuth)) run%with_azimuth = with_azimuth
      if (present(most_steps)) run%most_steps = most_steps
      run%tolerance = tolerance
      run%unit_length = length
      run%unit_speed = sqrt(gravity*length + dot_product(velocity, velocity) &
         + merge(dot_product(effects%wind, effects%wind), 0.0_wp, forces%has_drag) + pivot_speed(effects)**2)
      ! Under the gravity of the closed form.
      run%contact%unit_speed = sqrt(forces%weight/forces%inertia*length)
      call begin_azimuth(run, forces, is_taut, p, v, azimuth)
      call new_stepper(run%stepper, forces, is_taut, wants_work, p, v, tolerance, [run%unit_length, run%unit_speed, &
         run%unit_speed**2], first_step*sqrt(length/gravity))
      run%contact%closeness = 16*max(tolerance, 64*epsilon(tolerance))
      if (present(changes)) call begin_columns(run%columns, run%stepper, changes, length, gravity, position, velocity, &
         was_put, tolerance)
      allocate (run%events(8))
      if (.not. is_taut) then
         call append(run, string_event_type(kind=event_slack, position=p))
         run%stepper%problem%slack = slack
         call count_from_here(run)
      end if
      call note_step(run)
   end subroutine new_integration

   !> The azimuth at the start.
   subroutine begin_azimuth(run, forces, is_taut, position, velocity, azimuth)
      type(integration_type), intent(inout) :: run
      type(forces_type), intent(inout) :: forces
      logical, intent(in) :: is_taut
      real(wp), intent(in) :: position(3), velocity(3)
      real(wp), intent(in), optional :: azimuth
      real(wp) :: acceleration(3), tension, powers(2), rounding

      run%azimuth = turned_azimuth(position(1), position(2), velocity(1), velocity(2), quiet_nan_real64)
      if (is_upright(position(1), position(2)) .and. is_upright(velocity(1), velocity(2))) then
         if (present(azimuth)) run%azimuth = azimuth
         call move(forces, is_taut, 0.0_wp, position, velocity, acceleration, tension, powers)
         ! What is left of accelerations that balance has no direction.
         rounding = 64*epsilon(tension)*(forces%weight + norm2(forces%effects%pivot_amplitude* &
            forces%effects%pivot_frequency**2))
         if (maxval(abs(acceleration(:2))) > rounding) run%azimuth = atan2(acceleration(2) + 0, acceleration(1))
      end if
      run%azimuth_before = run%azimuth
      run%first_azimuth = run%azimuth
   end subroutine begin_azimuth

   !> In flight places are counted from where it began.
   subroutine count_from_here(run)
      type(integration_type), intent(inout) :: run

      run%stepper%problem%base = run%stepper%y(1:3)
      run%stepper%y(1:3) = 0
      run%stepper%start_y(1:3) = 0
   end subroutine count_from_here

   !> The motion at ascending times, none before those of the call before. At a failure what follows is NaN.
   subroutine advance(run, times, positions, velocities, tensions, drag_work, pivot_work, error, azimuths, matrices)
      class(integration_type), intent(inout) :: run
      real(wp), intent(in) :: times(:)                           !! (n) from 0 on [s]
      real(wp), intent(out) :: positions(:, :), velocities(:, :) !! (3, n) relative to the pivot [m], [m/s]
      real(wp), intent(out) :: tensions(:)  !! (n) force of rod or string over the bob's mass [m/s2]
      real(wp), intent(out) :: drag_work(:), pivot_work(:)       !! (n) on the bob since time 0, per mass [m2/s2]
      type(error_type), allocatable, intent(out) :: error
      real(wp), intent(out), optional :: azimuths(:)             !! (n) turns counted from step to step [rad]
      real(wp), intent(out), optional :: matrices(:, :, :)       !! (6, p, n) derivatives by `changes`
      integer :: i

      do i = 1, size(times)
         call check_time(run, times(i), error)
         if (allocated(error)) exit
         do while (run%stepper%time < times(i) .and. run%failure == 0)
            call next_step(run, times(i), times(i) - run%last_time)
         end do
         run%time = run%stepper%time
         call tell_failure(run, error)
         if (allocated(error)) exit
         call sample(run, times(i), positions(:, i), velocities(:, i), tensions(i), drag_work(i), pivot_work(i))
         if (present(matrices)) call run%columns_within(times(i), matrices(:, :, i))
         if (present(azimuths)) azimuths(i) = turned_azimuth(positions(1, i), positions(2, i), velocities(1, i), &
            velocities(2, i), run%azimuth_before)
         run%last_time = times(i)
         run%evaluations = run%stepper%problem%evaluations
      end do
      if (.not. allocated(error)) return
      positions(:, i:) = quiet_nan_real64
      velocities(:, i:) = quiet_nan_real64
      tensions(i:) = quiet_nan_real64
      drag_work(i:) = quiet_nan_real64
      pivot_work(i:) = quiet_nan_real64
      if (present(azimuths)) azimuths(i:) = quiet_nan_real64
      if (present(matrices)) matrices(:, :, i:) = quiet_nan_real64
   end subroutine advance

   !> One step, for who looks at every one: not beyond the next sample's time, which comes `gap` after the last one's.
   subroutine step_on(run, sample_time, gap, error)
      class(integration_type), intent(inout) :: run
      real(wp), intent(in) :: sample_time, gap          !! Later than `run%time` [s]
      type(error_type), allocatable, intent(out) :: error

      call check_time(run, sample_time, error)
      if (allocated(error)) return
      call next_step(run, sample_time, gap)
      run%step_start = run%stepper%start
      run%time = run%stepper%time
      call tell_failure(run, error)
   end subroutine step_on

   !> The motion between `run%step_start` and `run%time`, as samples show it, or by a step of its own.
   subroutine within(run, time, exactly, position, velocity, tension, work, azimuth)
      class(integration_type), intent(inout) :: run
      real(wp), intent(in) :: time                      !! [s]
      logical, intent(in) :: exactly
      real(wp), intent(out) :: position(3), velocity(3), tension, work(2), azimuth
      real(wp) :: kept(3), y(unknowns), rates(unknowns)

      if (exactly .and. time < run%time) then
         call trial_step(run%stepper, time - run%stepper%start, y, rates, tension)
         position = run%stepper%problem%base + y(1:3)
         velocity = y(4:6)
         work = works(run%stepper%problem, y)
      else
         kept = [run%work_time, run%work]
         call sample(run, time, position, velocity, tension, work(1), work(2))
         run%work_time = kept(1)
         run%work = kept(2:)
      end if
      azimuth = turned_azimuth(position(1), position(2), velocity(1), velocity(2), run%azimuth_before)
   end subroutine within

   !> The derivatives there, as samples show them.
   subroutine columns_within(run, time, matrix)
      class(integration_type), intent(inout) :: run
      real(wp), intent(in) :: time                      !! [s]
      real(wp), intent(out) :: matrix(:, :)             !! (6, p)

      call columns_now(run%columns, run%stepper, run%interpolant, time, run%between == by_polynomial, matrix)
      if (run%is_at_knot .and. .not. time < run%stepper%time) &
         call show_columns_behind_knot(run%stepper%problem, time, run%stepper%y, matrix)
   end subroutine columns_within

   !> Whether a time may be asked for.
   subroutine check_time(run, time, error)
      type(integration_type), intent(inout) :: run
      real(wp), intent(in) :: time
      type(error_type), allocatable, intent(out) :: error

      if (run%failure == failure_request) run%failure = 0
      if (.not. associated(run%stepper%problem)) then
         call fail(error, code_domain, 'integrate: the run has not begun')
      else if (.not. (time >= run%last_time .and. is_finite(time))) then
         call fail(error, code_domain, 'integrate: the times must ascend from 0, got'//listed([run%last_time, time]))
      else if (time > run%ends) then
         call fail(error, code_domain, 'integrate: a table of pivot or length, or the length, ends before, at'// &
            listed([run%ends]))
      end if
      if (allocated(error)) run%failure = failure_request
   end subroutine check_time

   !> An error for a run that went wrong.
   subroutine tell_failure(run, error)
      type(integration_type), intent(in) :: run
      type(error_type), allocatable, intent(out) :: error

      select case (run%failure)
      case (failure_short_step)
         call fail(error, code_unsupported, 'integrate: no step is short enough at the time'//listed([run%time])// &
            trim(merge('; drag of a sphere ends at the Reynolds number 2e5            ', &
            '; a larger tolerance may help, or the motion is singular there', run%stepper%problem%forces%is_beyond)))
      case (failure_events)
         call fail(error, code_unsupported, 'integrate: the string went slack too often, by'//listed([run%time]))
      case (failure_tangential)
         call fail(error, code_unsupported, 'integrate: the motion has no derivatives after the time'// &
            listed([run%time])//', where the string goes slack or taut tangentially')
      case (failure_steps)
         call fail(error, code_unsupported, 'integrate: the steps came to an end at the time'//listed([run%time]))
      end select
   end subroutine tell_failure

   !> Frees the memory.
   subroutine finish(run)
      class(integration_type), intent(inout) :: run

      call free_stepper(run%stepper)
      call forget(run)
   end subroutine finish

   !> Everything as in a run that has not begun.
   subroutine forget(run)
      type(integration_type), intent(out) :: run

      run%event_count = 0
   end subroutine forget

   !> One step. It ends at the time asked for if that is the only one in it; if the next may be expected in it too it
   !> goes its own way, so that where the samples lie has no part in the steps.
   subroutine next_step(run, target, gap)
      type(integration_type), intent(inout) :: run
      real(wp), intent(in) :: target, gap
      type(string_event_type) :: event
      real(wp) :: limit, knot
      logical :: is_far, failed, has_event

      associate (stepper => run%stepper, contact => run%contact)
         if (run%has_contact) then
            call make_contact(stepper, contact, event)
            call append(run, event)
         end if
         call pass_knot(stepper, contact%closeness, contact%is_tangential, contact%left_with, knot, event, has_event)
         if (has_event) call append(run, event)
         if (run%event_count > most_events) run%failure = failure_events
         if (contact%is_tangential) run%failure = failure_tangential
         if (run%failure > 0) return
         if (run%has_contact .or. run%is_at_knot) then
            call forget_steps(run)
            call note_step(run)
            run%has_contact = .false.
         end if
         limit = merge(min(knot, target), knot, target + gap > stepper%time + stepper%next)
         ! Where samples are far apart no polynomial is wanted.
         is_far = gap > 2*stepper%next
         call take_step(stepper, limit, failed)
         if (failed) run%failure = failure_short_step
         if (real(run%steps, wp) + stepper%rejected >= run%most_steps) run%failure = failure_steps
         if (run%failure > 0) return
         if (stepper%problem%forces%effects%is_string) call find_contact(stepper, contact, run%has_contact)
         run%is_at_knot = stepper%time >= knot
         if (run%with_azimuth) call turn_azimuth(run)
         run%steps = run%steps + 1
         run%rejected = stepper%rejected
         if (is_far) then
            call forget_steps(run)
            run%between = by_steps
            run%work_time = stepper%start
         else
            call note_step(run)
         end if
      end associate
   end subroutine next_step

   !> Follows the azimuth to the end of a step.
   pure subroutine turn_azimuth(run)
      type(integration_type), intent(inout) :: run

      run%azimuth_before = run%azimuth
      associate (base => run%stepper%problem%base, y => run%stepper%y)
         run%azimuth = turned_azimuth(base(1) + y(1), base(2) + y(2), y(4), y(5), run%azimuth)
      end associate
      if (.not. is_finite(run%first_azimuth)) run%first_azimuth = run%azimuth
   end subroutine turn_azimuth

   !> No polynomial goes beyond here.
   subroutine forget_steps(run)
      type(integration_type), intent(inout) :: run

      call clear(run%interpolant)
      if (allocated(run%columns%interpolants)) call clear_columns(run%columns)
   end subroutine forget_steps

   !> Remembers the end of a step.
   subroutine note_step(run)
      type(integration_type), intent(inout) :: run

      associate (stepper => run%stepper)
         call add_node(run%interpolant, stepper%time, stepper%y(1:3), stepper%y(4:6), stepper%rates(4:6))
         if (allocated(run%columns%interpolants)) call note_columns(run%columns, stepper)
         run%between = unknown
         run%work_time = stepper%start
         run%work = works(run%stepper%problem, stepper%start_y)
      end associate
   end subroutine note_step

   !> The motion at a time within the last step.
   subroutine sample(run, time, position, velocity, tension, drag_work, pivot_work)
      type(integration_type), intent(inout) :: run
      real(wp), intent(in) :: time
      real(wp), intent(out) :: position(3), velocity(3), tension, drag_work, pivot_work
      real(wp) :: y(unknowns), rates(unknowns), work(2), acceleration(3), powers(2)

      associate (stepper => run%stepper, problem => run%stepper%problem)
         if (time < stepper%time) then
            if (run%between == unknown) call choose_between(run)
            if (run%between == by_polynomial) then
               call interpolate(run%interpolant, time, y(1:3), y(4:6))
               if (problem%forces%has_hoist) call lengthen(problem%forces%suspension, problem%forces%effects, time)
               if (problem%is_taut .and. .not. problem%forces%is_elastic) &
                  call put_on_surface(problem%forces%suspension, y(1:3), y(4:6))
               if (problem%unknowns > 6) call add_work(run, time)
               work = run%work
               run%interpolated = run%interpolated + 1
               call move(problem%forces, problem%is_taut, time, problem%base + y(1:3), y(4:6), acceleration, tension, &
                  powers)
            else
               call trial_step(stepper, time - stepper%start, y, rates, tension)
               work = works(run%stepper%problem, y)
               run%stepped = run%stepped + 1
            end if
         else
            y = stepper%y
            tension = stepper%tension
            if (run%is_at_knot) call show_behind_knot(stepper, y, tension)
            work = works(run%stepper%problem, y)
         end if
         position = problem%base + y(1:3)
         velocity = y(4:6)
         drag_work = work(1)
         pivot_work = work(2)
      end associate
   end subroutine sample

   !> Whether the polynomial serves the last step: it satisfies the equations of motion where it should be worst.
   subroutine choose_between(run)
      type(integration_type), intent(inout) :: run
      real(wp) :: y(6), bend(3), acceleration(3), tension, powers(2), time, defect, allowed

      run%between = by_steps
      if (run%interpolant%count < nodes) return
      call prepare(run%interpolant)
      associate (problem => run%stepper%problem, h => run%interpolant%step)
         time = run%interpolant%time(1) + defect_point*h
         call interpolate(run%interpolant, time, y(1:3), y(4:6), bend)
         call move(problem%forces, problem%is_taut, time, problem%base + y(1:3), y(4:6), acceleration, tension, powers)
         defect = norm2(bend - acceleration)
         ! What rounding alone leaves of a second difference.
         allowed = max(4*run%tolerance, 64*epsilon(h))
         if (defect*h**2*defect_to_position <= allowed*run%unit_length &
            .and. defect*h*defect_to_velocity <= allowed*run%unit_speed) run%between = by_polynomial
         if (run%between == by_steps .or. .not. allocated(run%columns%interpolants)) return
         if (.not. columns_fit(run%columns, run%stepper, problem%base + y(1:3), y(4:6), allowed)) &
            run%between = by_steps
      end associate
   end subroutine choose_between

   !> Works up to a time within the last step, by quadrature of the powers from where they were known last.
   subroutine add_work(run, time)
      type(integration_type), intent(inout) :: run
      real(wp), intent(in) :: time
      real(wp) :: y(6), acceleration(3), tension, powers(2), half, at
      integer :: i

      half = (time - run%work_time)/2
      associate (problem => run%stepper%problem)
         do i = 1, size(gauss_weights)
            at = run%work_time + half*(1 + gauss_abscissas(i))
            call interpolate(run%interpolant, at, y(1:3), y(4:6))
            call move(problem%forces, problem%is_taut, at, problem%base + y(1:3), y(4:6), acceleration, tension, &
               powers)
            run%work = run%work + half*gauss_weights(i)*powers
         end do
      end associate
      run%work_time = time
   end subroutine add_work

   subroutine append(run, event)
      type(integration_type), intent(inout) :: run
      type(string_event_type), intent(in) :: event
      type(string_event_type), allocatable :: larger(:)

      if (run%event_count == size(run%events)) then
         allocate (larger(2*size(run%events)))
         larger(:run%event_count) = run%events
         call move_alloc(larger, run%events)
      end if
      run%event_count = run%event_count + 1
      run%events(run%event_count) = event
   end subroutine append

   !> Numbers for a message, a blank before each.
   pure function listed(numbers) result(text)
      real(wp), intent(in) :: numbers(:)
      character(len=24*size(numbers)) :: text

      write (text, '(*(es24.16))') numbers
   end function listed

end module kyvadlo_integrator
