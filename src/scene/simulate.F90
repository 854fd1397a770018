!> Computes the samples of a scene along the path chosen, block by block, in memory that does not grow with their
!> number.
module kyvadlo_simulate
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_buoyancy, only: effective_gravity
   use kyvadlo_derivative_samples, only: begin_derivatives, derivative_samples_type, fill_derivatives, find_matrices
   use kyvadlo_exact_samples, only: fill_closed_form, fill_constant, fill_string
#ifdef KYVADLO_WITH_GSL
   use kyvadlo_integrator, only: failure_events, failure_short_step, failure_steps, failure_tangential
   use kyvadlo_integrated_samples, only: begin_integration, end_integration, fill_integrated, integrated_type
#endif
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: place_of
   use kyvadlo_number_text, only: digits_text, shortest_text
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_pivot, only: pivot_motion
   use kyvadlo_quantities, only: quantity_derivatives, quantity_position, quantity_velocity
   use kyvadlo_sample_block
   use kyvadlo_sample_times, only: last_before, set_times
   use kyvadlo_samples, only: sample_sink_type, scene_event_type
   use kyvadlo_scene_groups, only: moving_pivot_group, output_group, string_group, turning_frame_group
   use kyvadlo_scene_derivatives, only: derivative_type
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_simulation_path
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_string, only: event_rebound, event_slack, event_taut, string_event_type
   use kyvadlo_turning_frame, only: seen_from_turning_frame
   use kyvadlo_wide_samples, only: fill_wide, is_wide, longest_cell
   implicit none
   private
   public :: simulate, states_with_derivatives

   !> A bob on a string that is nearer to the pivot than by this part of the length is in free flight.
   real(wp), parameter :: slack_part = 1e-9_wp

   !> What the samples of a scene are computed with, block by block.
   type :: work_type
      type(derivative_samples_type) :: derivatives
      logical :: is_checked = .false.      !! An integration runs beside one at a tenth of the tolerance
#ifdef KYVADLO_WITH_GSL
      type(integrated_type) :: integrated
#endif
   end type work_type

contains

   !> Computes a scene and hands the samples, and the events between them, to a sink.
   !>
   !> Samples are equidistant in time, both ends included. The sink may end the run early. Errors: those of the
   !> integrator; what was handed over before then is of no use.
   subroutine simulate(simulation, path, sink, error, check)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path                     !! From `choose_path`
      class(sample_sink_type), intent(inout) :: sink
      type(error_type), allocatable, intent(out) :: error
      type(check_type), intent(inout), optional :: check  !! Of an integrated scene: at a tenth of the tolerance beside
      type(block_type) :: block
      type(work_type) :: work
      character(len=longest_cell), allocatable :: cells(:, :)
      integer(int64) :: first
      integer :: noted
      logical :: goes_on

      if (present(check)) check = check_type()
      call new_block(simulation, is_one_orbit(path), block)
      call sink%begin(columns_of(simulation))
      work%is_checked = present(check)
      call begin_work(work, simulation, path, block, error)
      allocate (cells(merge(block_samples, 0, path%figures > 0), merge(block%visible, 0, path%figures > 0)))
      noted = 0
      goes_on = .not. allocated(error)
      first = 0
      do while (first < simulation%settings%samples .and. goes_on)
         block%count = int(min(int(block_samples, int64), simulation%settings%samples - first))
         call set_times(simulation%settings%samples, path%duration, path%duration_rest, path%duration_typed, &
            simulation%settings%sample_rate, first, block%values(:block%count, 1))
         if (is_wide(path)) then
            call fill_wide(simulation, path, block, cells)
            if (path%figures > 0) then
               call sink%take_written(block%values(:block%count, :block%visible), cells(:block%count, :), goes_on)
            else
               call sink%take(block%values(:block%count, :block%visible), goes_on)
            end if
            first = first + block%count
            cycle
         end if
         call fill_block(work, simulation, path, block, error)
         if (allocated(error)) exit
         select case (path%path)
         case (path_string)
            call hand_over(simulation, path, block, path%events, sink, noted, goes_on)
#ifdef KYVADLO_WITH_GSL
         case (path_integrated)
            call hand_over(simulation, path, block, work%integrated%run%events(:work%integrated%run%event_count), &
               sink, noted, goes_on)
#endif
         case default
            call sink%take(block%values(:block%count, :block%visible), goes_on)
         end select
         first = first + block%count
      end do
#ifdef KYVADLO_WITH_GSL
      if (present(check) .and. path%path == path_integrated) check = work%integrated%check
      call end_work(work, simulation, path, error)
#endif
   end subroutine simulate

   !> Position and velocity of a scene at any times, as its samples show them, and their derivatives with respect to
   !> some of its settings, each in the unit of the setting.
   !>
   !> Errors: those of `choose_path` and of the integrator; an event of a string that is met tangentially.
   subroutine states_with_derivatives(simulation, list, times, states, matrices, error, accuracy, most_steps)
      type(simulation_type), intent(in) :: simulation         !! What its &output asks for does not matter
      type(derivative_type), intent(in) :: list(:)            !! (p) from `parse_derivatives`
      real(wp), intent(in) :: times(:)                        !! (n) ascending from 0 [s]
      real(wp), intent(out) :: states(:, :)                   !! (6, n) x y z [m], vx vy vz [m/s]
      real(wp), intent(out) :: matrices(:, :, :)              !! (6, p, n)
      type(error_type), allocatable, intent(out) :: error
      real(wp), intent(in), optional :: accuracy              !! Of a step (1e-12)
      real(wp), intent(in), optional :: most_steps            !! Of an integration (1e7)
      type(simulation_type) :: wanted
      type(path_type) :: path
      type(block_type) :: block
      type(work_type) :: work
      integer :: first, i

      states = quiet_nan_real64
      matrices = quiet_nan_real64
      wanted = simulation
      wanted%settings%derivatives = list
      wanted%settings%differentiated = [quantity_position, quantity_velocity]
      wanted%settings%quantities = [quantity_position, quantity_velocity, quantity_derivatives]
      wanted%settings%duration = tiny(times)
      if (size(times) > 0) wanted%settings%duration = max(wanted%settings%duration, times(size(times)))
      wanted%settings%duration_typed = ''
      wanted%settings%sample_rate = ''
      call choose_path(wanted, path, error, accuracy, most_steps)
      if (allocated(error)) return
      call new_block(wanted, is_one_orbit(path), block)
      call begin_work(work, wanted, path, block, error)
      first = 0
      do while (first < size(times) .and. .not. allocated(error))
         block%count = min(block_samples, size(times) - first)
         block%values(:block%count, 1) = times(first + 1:first + block%count)
         call fill_block(work, wanted, path, block, error)
         if (allocated(error)) exit
         do i = 1, block%count
            states(:, first + i) = block%values(i, 2:7)
            matrices(:, :, first + i) = transpose(reshape(block%values(i, 8:7 + 6*size(list)), [size(list), 6]))
         end do
         first = first + block%count
      end do
#ifdef KYVADLO_WITH_GSL
      call end_work(work, wanted, path, error)
#endif
   end subroutine states_with_derivatives

   !> Whether the constants of one orbit are those of the motion.
   pure logical function is_one_orbit(path)
      type(path_type), intent(in) :: path

      is_one_orbit = path%path == path_closed_form .or. path%path == path_constant
   end function is_one_orbit

   subroutine begin_work(work, simulation, path, block, error)
      type(work_type), intent(inout) :: work
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(block_type), intent(in) :: block
      type(error_type), allocatable, intent(out) :: error

      if (block%column(quantity_derivatives) > 0) then
         associate (settings => simulation%settings)
            if (is_wide(path)) then
               call fail(error, code_input, place_of(settings%file, settings%line(output_group)) &
                  //'&output: derivatives are computed in double precision, and neither to this accuracy nor for '// &
                  'so long')
            else
               call begin_derivatives(work%derivatives, simulation, path, error)
               if (allocated(error)) error%message = place_of(settings%file, settings%line(output_group))// &
                  '&output: derivatives: '//trim(error%message)
            end if
         end associate
      end if
#ifdef KYVADLO_WITH_GSL
      if (path%path /= path_integrated .or. allocated(error)) return
      if (block%column(quantity_derivatives) > 0) then
         call begin_integration(work%integrated, path, block, work%is_checked, error, work%derivatives%changes%change)
      else
         call begin_integration(work%integrated, path, block, work%is_checked, error)
      end if
#endif
   end subroutine begin_work

   !> All columns of a block, at its times.
   subroutine fill_block(work, simulation, path, block, error)
      type(work_type), intent(inout) :: work
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block
      type(error_type), allocatable, intent(out) :: error
      logical :: has_derivatives

      has_derivatives = block%column(quantity_derivatives) > 0
      select case (path%path)
      case (path_constant)
         call fill_constant(path, block)
      case (path_closed_form)
         call fill_closed_form(path, block)
      case (path_string)
         call fill_string(path, block)
#ifdef KYVADLO_WITH_GSL
      case (path_integrated)
         if (has_derivatives) then
            call fill_integrated(work%integrated, path, block, error, work%derivatives%matrices)
         else
            call fill_integrated(work%integrated, path, block, error)
         end if
         if (allocated(error)) return
#endif
      end select
      if (has_derivatives) then
         if (path%path /= path_integrated) call find_matrices(work%derivatives, simulation, path, block, error)
         if (allocated(error)) then
            error%message = place_of(simulation%settings%file, simulation%settings%line(output_group))// &
               '&output: derivatives: '//trim(error%message)
            return
         end if
         call fill_derivatives(work%derivatives, simulation, path, block)
      end if
      call fill_inclination(block)
      call fill_ellipse(effective_gravity(path%gravity, path%effects%density_ratio, path%effects%added_mass), &
         merge(path%length*(1 - slack_part), 0.0_wp, path%effects%is_string), simulation%settings%frame_rate, block)
      if (simulation%settings%given(turning_frame_group)) call turn_azimuth(simulation%settings%frame_rate, block)
      if (in_laboratory(simulation)) call move_with_pivot(path%effects, block)
      if (simulation%settings%given(turning_frame_group)) call turn_frame(simulation%settings%frame_rate, block)
      call fill_speed(block)
   end subroutine fill_block

#ifdef KYVADLO_WITH_GSL
   !> What of the scene made it fail, and the memory back.
   subroutine end_work(work, simulation, path, error)
      type(work_type), intent(inout) :: work
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(error_type), allocatable, intent(inout) :: error

      if (path%path /= path_integrated) return
      if (allocated(error)) call explain_failure(simulation, path, work%integrated, error)
      call end_integration(work%integrated)
   end subroutine end_work

   !> What of the scene made an integration fail.
   subroutine explain_failure(simulation, path, integrated, error)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(integrated_type), intent(in) :: integrated
      type(error_type), allocatable, intent(inout) :: error

      associate (settings => simulation%settings, run => integrated%run)
         select case (run%failure)
         case (failure_short_step)
            error%message = path%hardest//'no step is short enough at t = '//shortest_text(run%time) &
               //' s; the motion is singular there, or too fast for the accuracy (option --accuracy)'
         case (failure_steps)
            error%message = path%hardest//'the integration got to t = '//shortest_text(run%time)//' s in ' &
               //trim(digits_text(path%most_steps, 2))//' steps (option --most-steps); shorten &output duration'
         case (failure_tangential)
            error%message = place_of(settings%file, settings%line(output_group))// &
               '&output: there are no derivatives after t = '//shortest_text(run%time)// &
               ' s, where the string goes slack or taut tangentially'
         case (failure_events)
            error%message = place_of(settings%file, settings%line(string_group)) &
               //'&string: too many events, by t = '//shortest_text(run%time)//' s; shorten &output duration'
         case default
            error%message = settings%file//': '//error%message
         end select
      end associate
   end subroutine explain_failure
#endif

   !> Whether what is shown moves with the pivot.
   pure logical function in_laboratory(simulation)
      type(simulation_type), intent(in) :: simulation

      in_laboratory = simulation%settings%given(moving_pivot_group) .and. .not. simulation%settings%relative
   end function in_laboratory

   !> Gives the samples to the sink, and each event before the samples that follow it.
   subroutine hand_over(simulation, path, block, events, sink, noted, goes_on)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(block_type), intent(in) :: block
      type(string_event_type), intent(in) :: events(:)        !! All that are known yet
      class(sample_sink_type), intent(inout) :: sink
      integer, intent(inout) :: noted                         !! Events handed over so far
      logical, intent(inout) :: goes_on
      integer :: first, last

      first = 1
      do while (first <= block%count .and. goes_on)
         last = block%count
         do while (noted < size(events))
            if (events(noted + 1)%time > block%values(first, 1)) exit
            noted = noted + 1
            call sink%note(scene_event(simulation, path, events(noted)))
         end do
         if (noted < size(events)) last = last_before(block%values(:block%count, 1), first, events(noted + 1)%time)
         call sink%take(block%values(first:last, :block%visible), goes_on)
         first = last + 1
      end do
   end subroutine hand_over

   !> An event of the string in words, and where the samples show it.
   pure function scene_event(simulation, path, from) result(event)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(string_event_type), intent(in) :: from
      type(scene_event_type) :: event
      real(wp) :: displacement(3), velocity(3)

      event%time = from%time
      event%position = from%position
      event%energy_lost = from%energy_lost
      ! The integrator knows of the fluid.
      if (path%path == path_string) event%energy_lost = path%inertia*from%energy_lost
      if (in_laboratory(simulation)) then
         call pivot_motion(path%effects, from%time, displacement, velocity)
         event%position = event%position + displacement
      end if
      if (simulation%settings%given(turning_frame_group)) then
         velocity = 0
         call seen_from_turning_frame(simulation%settings%frame_rate, from%time, event%position, velocity)
      end if
      select case (from%kind)
      case (event_slack)
         event%what = 'slack'
      case (event_taut)
         event%what = 'taut'
      case (event_rebound)
         event%what = 'rebound'
      case default
         event%what = 'taut after rattling'
      end select
   end function scene_event

end module kyvadlo_simulate
