!> Computes the samples of a scene along the path chosen, block by block, in memory that does not grow with their
!> number.
module kyvadlo_simulate
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_buoyancy, only: effective_gravity
   use kyvadlo_crossings, only: extreme_type, probe_type, step_watcher_type
   use kyvadlo_derivative_samples, only: begin_derivatives, derivative_samples_type, fill_derivatives, find_matrices
   use kyvadlo_event_order, only: hand_over, merge_events, take_last
   use kyvadlo_exact_samples, only: fill_closed_form, fill_constant, fill_string
#ifdef KYVADLO_WITH_GSL
   use kyvadlo_integration_failure, only: explain_failure
   use kyvadlo_integrated_samples, only: begin_integration, end_integration, fill_integrated, fill_within, &
      integrated_type
#endif
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: place_of
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_quantities, only: quantity_derivatives, quantity_position, quantity_velocity
   use kyvadlo_sample_block
   use kyvadlo_sample_times, only: set_times
   use kyvadlo_samples, only: longest_cell, sample_sink_type, scene_event_type
   use kyvadlo_scene_events, only: begin_search, event_search_type, forget_found, search_orbit, search_stretch, &
      search_string
   use kyvadlo_scene_groups, only: event_group, output_group, turning_frame_group
   use kyvadlo_scene_derivatives, only: derivative_type
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_simulation_path
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_swing_ellipse, only: apsides_type
   use kyvadlo_wide_samples, only: fill_wide, is_wide, sharpen_events
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

   !> All quantities of a scene at times within the stretch that is looked at.
   type, extends(probe_type) :: scene_probe_type
      private
      type(work_type), pointer :: work => null()
      type(simulation_type), pointer :: simulation => null()
      type(path_type), pointer :: path => null()
      type(block_type) :: block
      type(derivative_samples_type) :: derivatives   !! Of events: later than those of the samples
   contains
      procedure :: at => probe_scene
      procedure :: settle => settle_probe
   end type scene_probe_type

   !> The events of a scene, and who finds them.
   type, extends(step_watcher_type) :: event_watcher_type
      type(scene_probe_type) :: probe
      type(event_search_type) :: search
   contains
      procedure :: look => look_for_events
   end type event_watcher_type

   !> Points of a step of the integrator, at most a tenth of a swing, where quantities are looked at.
   integer, parameter :: points_of_step = 8

contains

   !> Computes a scene and hands the samples, and the events between them, to a sink.
   !>
   !> Samples are equidistant in time, both ends included. The sink may end the run early. Errors: those of the
   !> integrator; what was handed over before then is of no use.
   subroutine simulate(simulation, path, sink, error, check, extremes)
      type(simulation_type), intent(in), target :: simulation
      type(path_type), intent(in), target :: path             !! From `choose_path`
      class(sample_sink_type), intent(inout) :: sink
      type(error_type), allocatable, intent(out) :: error
      type(check_type), intent(inout), optional :: check  !! Of an integrated scene: at a tenth of the tolerance beside
      type(extreme_type), intent(inout), optional :: extremes(:) !! Of columns of the samples, to the last digits
      type(block_type) :: block
      type(work_type), target :: work
      type(event_watcher_type), allocatable :: watcher        !! Of a scene with events
      type(scene_event_type), allocatable :: events(:)
      character(len=longest_cell), allocatable :: cells(:, :)
      real(wp) :: last_time
      integer(int64) :: first
      integer :: noted
      logical :: goes_on, is_written

      if (present(check)) check = check_type()
      call new_block(simulation, is_one_orbit(path), block)
      call sink%begin(columns_of(simulation))
      work%is_checked = present(check)
      call begin_work(work, simulation, path, block, error)
      if (.not. allocated(error)) call begin_watcher(watcher, work, simulation, path, block, error, extremes)
      is_written = is_wide(path) .and. path%figures > 0
      allocate (cells(merge(block_samples, 0, is_written), merge(block%visible, 0, is_written)))
      noted = 0
      goes_on = .not. allocated(error)
      first = 0
      last_time = 0
      do while (first < simulation%settings%samples .and. goes_on)
         block%count = int(min(int(block_samples, int64), simulation%settings%samples - first))
         call set_times(simulation%settings%samples, path%duration, path%duration_rest, path%duration_typed, &
            simulation%settings%sample_rate, first, block%values(:block%count, 1))
         first = first + block%count
         associate (next_time => block%values(block%count, 1))
            if (allocated(watcher)) call search_exactly(watcher, path, last_time, block)
            last_time = next_time
         end associate
         if (is_wide(path)) then
            call fill_wide(simulation, path, block, cells)
         else
            call fill_block(work, simulation, path, block, error, watcher)
         end if
         if (allocated(error)) exit
         call gather_events(work, simulation, path, watcher, last_time, noted, events)
         if (is_written) call sharpen_events(simulation, path, block, events)
         call hand_over(block, events, sink, goes_on, cells)
         if (.not. allocated(watcher)) cycle
         if (watcher%search%is_over) then
            if (goes_on) call take_last(block, events(size(events)), sink)
            exit
         end if
      end do
      if (present(extremes) .and. allocated(watcher)) extremes = watcher%search%extremes
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

   !> All columns of a block, at its times; of fewer times where an integration comes to its end.
   subroutine fill_block(work, simulation, path, block, error, watcher)
      type(work_type), intent(inout), target :: work
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block
      type(error_type), allocatable, intent(out) :: error
      type(event_watcher_type), intent(inout), optional :: watcher
      logical :: has_derivatives

      has_derivatives = block%column(quantity_derivatives) > 0
#ifndef KYVADLO_WITH_GSL
      if (present(watcher)) continue  ! Only an integration needs it
#endif
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
            call fill_integrated(work%integrated, path, block, error, work%derivatives%matrices, watcher)
         else
            call fill_integrated(work%integrated, path, block, error, watcher=watcher)
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
      call show_block(simulation, path, block)
   end subroutine fill_block

   !> What follows from the motion relative to the pivot, and the motion as it is seen.
   subroutine show_block(simulation, path, block)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block

      if (path%mass > 0) call fill_newtons(path%mass, path%centre_part, path%gravity, path%effects, block)
      call fill_inclination(block)
      call fill_ellipse(effective_gravity(path%gravity, path%effects%density_ratio, path%effects%added_mass), &
         merge(path%length*(1 - slack_part), 0.0_wp, path%effects%is_string), simulation%settings%frame_rate, block)
      if (simulation%settings%given(turning_frame_group)) call turn_azimuth(simulation%settings%frame_rate, block)
      if (in_laboratory(simulation)) call move_with_pivot(path%effects, block)
      if (simulation%settings%given(turning_frame_group)) call turn_frame(simulation%settings%frame_rate, block)
      call fill_speed(block)
   end subroutine show_block

   !> A watcher where there is something to watch. Error: for so long that doubles do not know the phase.
   subroutine begin_watcher(watcher, work, simulation, path, block, error, extremes)
      type(event_watcher_type), allocatable, intent(out) :: watcher
      type(work_type), intent(in), target :: work
      type(simulation_type), intent(in), target :: simulation
      type(path_type), intent(in), target :: path
      type(block_type), intent(in) :: block
      type(error_type), allocatable, intent(out) :: error
      type(extreme_type), intent(in), optional :: extremes(:)

      if (size(simulation%settings%events) == 0 .and. .not. present(extremes)) return
      if (is_wide(path) .and. path%figures == 0 .and. size(simulation%settings%events) > 0) then
         call fail(error, code_input, place_of(simulation%settings%file, simulation%settings%line(event_group))// &
            '&event: over so long double precision cannot tell one swing from the next, nor find events')
         return
      end if
      allocate (watcher)
      if (present(extremes)) watcher%search%extremes = extremes
      associate (probe => watcher%probe)
         probe%work => work
         probe%simulation => simulation
         probe%path => path
         probe%block = block
         probe%block%values = quiet_nan_real64
         probe%columns = size(block%values, 2)
         probe%is_approximate = path%path == path_integrated
         if (block%column(quantity_derivatives) > 0) call begin_derivatives(probe%derivatives, simulation, path, &
            error, count=1)
         if (allocated(error)) return
         call probe%settle(0.0_wp)
      end associate
      call begin_search(watcher%search, simulation, path, block%column, block%visible)
   end subroutine begin_watcher

   subroutine probe_scene(probe, times, values, exactly)
      class(scene_probe_type), intent(inout) :: probe
      real(wp), intent(in) :: times(:)
      real(wp), intent(out) :: values(:, :)
      logical, intent(in) :: exactly
      type(apsides_type) :: apsides
      real(wp) :: azimuth
      integer :: piece

      apsides = probe%block%apsides
      azimuth = probe%block%azimuth
      piece = probe%block%piece
      call fill_probe(probe, times, exactly)
      values = probe%block%values(:size(times), :)
      probe%block%apsides = apsides
      probe%block%azimuth = azimuth
      probe%block%piece = piece
   end subroutine probe_scene

   subroutine settle_probe(probe, time)
      class(scene_probe_type), intent(inout) :: probe
      real(wp), intent(in) :: time

      call fill_probe(probe, [time], .false.)
   end subroutine settle_probe

   !> All columns; derivatives of one time, asked for exactly.
   subroutine fill_probe(probe, times, exactly)
      class(scene_probe_type), intent(inout) :: probe
      real(wp), intent(in) :: times(:)
      logical, intent(in) :: exactly
      type(error_type), allocatable :: error
      logical :: has_derivatives

      has_derivatives = exactly .and. size(times) == 1 .and. probe%block%column(quantity_derivatives) > 0
      probe%block%count = size(times)
      if (probe%block%column(quantity_derivatives) > 0) probe%block%values(:size(times), :) = quiet_nan_real64
      probe%block%values(:size(times), 1) = times
      select case (probe%path%path)
      case (path_constant)
         call fill_constant(probe%path, probe%block)
      case (path_closed_form)
         call fill_closed_form(probe%path, probe%block)
      case (path_string)
         call fill_string(probe%path, probe%block)
#ifdef KYVADLO_WITH_GSL
      case (path_integrated)
         if (has_derivatives) then
            call fill_within(probe%work%integrated, probe%path, probe%block, exactly, probe%derivatives%matrices)
         else
            call fill_within(probe%work%integrated, probe%path, probe%block, exactly)
         end if
#endif
      end select
      if (has_derivatives) then
         if (probe%path%path /= path_integrated) call find_matrices(probe%derivatives, probe%simulation, probe%path, &
            probe%block, error)
         ! Behind an event met tangentially there are none, and the samples end with that error.
         if (allocated(error)) probe%derivatives%matrices = quiet_nan_real64
         call fill_derivatives(probe%derivatives, probe%simulation, probe%path, probe%block)
      end if
      call show_block(probe%simulation, probe%path, probe%block)
   end subroutine fill_probe

   !> What happens up to the last sample of a block of a path in closed form; later samples go.
   subroutine search_exactly(watcher, path, from, block)
      type(event_watcher_type), intent(inout) :: watcher
      type(path_type), intent(in) :: path
      real(wp), intent(in) :: from                            !! [s]
      type(block_type), intent(inout) :: block

      call forget_found(watcher%search)
      associate (search => watcher%search, to => block%values(block%count, 1))
         if (path%path == path_closed_form) then
            call search_orbit(search, path%orbit, watcher%probe, from, to)
         else if (path%path == path_string) then
            call search_string(search, path, watcher%probe, from, to)
         else if (path%path == path_constant .and. .not. from > 0) then
            call search_stretch(search, watcher%probe, [0.0_wp], .true.)
         end if
         if (search%is_over) block%count = count(block%values(:block%count, 1) <= search%found(search%count)%time)
      end associate
   end subroutine search_exactly

   !> After a step of the integrator.
   subroutine look_for_events(watcher, from, to)
      class(event_watcher_type), intent(inout) :: watcher
      real(wp), intent(in) :: from, to
      real(wp) :: times(0:points_of_step)
      integer :: i

      do i = 0, points_of_step
         times(i) = from + (to - from)*(real(i, wp)/points_of_step)
      end do
      times(points_of_step) = to
      call search_stretch(watcher%search, watcher%probe, times, .true.)
      call watcher%probe%settle(to)
      watcher%is_over = watcher%search%is_over
   end subroutine look_for_events

   !> All events up to a time that were not handed over yet.
   subroutine gather_events(work, simulation, path, watcher, until, noted, events)
      type(work_type), intent(in) :: work
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(event_watcher_type), intent(in), optional :: watcher
      real(wp), intent(in) :: until                           !! [s]
      integer, intent(inout) :: noted                         !! Events of the string handed over so far
      type(scene_event_type), allocatable, intent(out) :: events(:)
      type(scene_event_type), allocatable :: found(:)
      real(wp) :: last

      allocate (found(0))
      last = until
      if (present(watcher)) then
         found = watcher%search%found(:watcher%search%count)
         if (watcher%search%is_over) last = found(size(found))%time
      end if
      select case (path%path)
      case (path_string)
         call merge_events(simulation, path, found, path%events, last, noted, events)
#ifdef KYVADLO_WITH_GSL
      case (path_integrated)
         associate (run => work%integrated%run)
            call merge_events(simulation, path, found, run%events(:run%event_count), last, noted, events)
         end associate
#endif
      case default
         if (work%is_checked) continue  ! Only an integration has more in it
         call move_alloc(found, events)
      end select
   end subroutine gather_events

#ifdef KYVADLO_WITH_GSL
   !> What of the scene made it fail, and the memory back.
   subroutine end_work(work, simulation, path, error)
      type(work_type), intent(inout) :: work
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(error_type), allocatable, intent(inout) :: error

      if (path%path /= path_integrated) return
      if (allocated(error)) call explain_failure(simulation, path, work%integrated%run, error)
      call end_integration(work%integrated)
   end subroutine end_work
#endif

end module kyvadlo_simulate
