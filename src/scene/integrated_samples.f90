!> Samples of an integrated scene; beside it, on request, the same at a tenth of the tolerance.
module kyvadlo_integrated_samples
   use kyvadlo_crossings, only: step_watcher_type
   use kyvadlo_force_changes, only: change_type
   use kyvadlo_forces, only: mechanical_energy
   use kyvadlo_integrator, only: integration_type, new_integration
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_quantities
   use kyvadlo_sample_block, only: block_samples, block_type
   use kyvadlo_simulation_path, only: check_type, path_type
   use kyvadlo_status, only: error_type
   use kyvadlo_turned_azimuth, only: is_upright
   implicit none
   private
   public :: integrated_type, begin_integration, fill_integrated, fill_within, end_integration

   type :: integrated_type
      type(integration_type) :: run
      type(check_type) :: check
      type(integration_type), private :: finer
      logical, private :: is_checked = .false.
      real(wp), private :: last_time = 0                                                 !! Of the last sample [s]
      real(wp), allocatable, private, dimension(:, :) :: positions, velocities           !! (3, block_samples)
      real(wp), allocatable, private, dimension(:, :) :: other_positions, other_velocities
   end type integrated_type

contains

   !> Starts at time 0.
   subroutine begin_integration(integrated, path, block, is_checked, error, changes)
      type(integrated_type), intent(inout) :: integrated
      type(path_type), intent(in) :: path
      type(block_type), intent(in) :: block
      logical, intent(in) :: is_checked                       !! A second run at a tenth of the tolerance is compared
      type(error_type), allocatable, intent(out) :: error
      type(change_type), intent(in), optional :: changes(:)   !! (p) whose derivatives are integrated too
      real(wp) :: azimuth
      logical :: with_work, with_azimuth

      with_work = any(block%column([quantity_drag_work, quantity_pivot_work]) > 0)
      with_azimuth = block%column(quantity_azimuth) > 0
      allocate (integrated%positions(3, block_samples), integrated%velocities(3, block_samples))
      azimuth = quiet_nan_real64
      if (with_azimuth .and. all(is_upright([path%position(1), path%velocity(1)], &
         [path%position(2), path%velocity(2)]))) call look_ahead(path, azimuth, error)
      if (allocated(error)) return
      if (present(changes)) then
         call new_integration(integrated%run, path%effects, path%length, path%gravity, path%position, path%velocity, &
            path%tolerance, error, with_work, with_azimuth, azimuth, path%most_steps, changes)
      else
         call new_integration(integrated%run, path%effects, path%length, path%gravity, path%position, path%velocity, &
            path%tolerance, error, with_work, with_azimuth, azimuth, path%most_steps)
      end if
      integrated%is_checked = is_checked
      if (allocated(error) .or. .not. is_checked) return
      allocate (integrated%other_positions(3, block_samples), integrated%other_velocities(3, block_samples))
      call new_integration(integrated%finer, path%effects, path%length, path%gravity, path%position, path%velocity, &
         path%tolerance/10, error, .false., most_steps=2*path%most_steps)
   end subroutine begin_integration

   !> The azimuth of the direction in which a bob at rest on the axis will leave it; NaN if it never does.
   subroutine look_ahead(path, azimuth, error)
      type(path_type), intent(in) :: path
      real(wp), intent(out) :: azimuth                        !! [rad]
      type(error_type), allocatable, intent(out) :: error
      type(integration_type) :: run
      real(wp), dimension(3, 1) :: there, moving
      real(wp), dimension(1) :: tension, drag_work, pivot_work
      integer, parameter :: looks = 100
      integer :: i

      call new_integration(run, path%effects, path%length, path%gravity, path%position, path%velocity, path%tolerance, &
         error, .false., .true., most_steps=path%most_steps)
      do i = 1, looks
         if (allocated(error) .or. run%first_azimuth == run%first_azimuth) exit
         call run%advance([path%duration*(real(i, wp)/looks)], there, moving, tension, drag_work, pivot_work, error)
      end do
      azimuth = run%first_azimuth
      call run%finish()
   end subroutine look_ahead

   !> The samples at the times of the block, relative to the pivot; fewer where a watcher ends the run before the last.
   subroutine fill_integrated(integrated, path, block, error, matrices, watcher)
      type(integrated_type), intent(inout), target :: integrated
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block
      type(error_type), allocatable, intent(out) :: error
      real(wp), intent(inout), optional :: matrices(:, :, :)  !! (6, p, block_samples) derivatives by the changes
      class(step_watcher_type), intent(inout), optional :: watcher
      real(wp), dimension(block%count) :: tensions, drag_work, pivot_work, azimuths
      integer :: first, last

      first = 1
      last = block%count
      do while (first <= block%count)
         if (present(watcher)) then
            last = first
            call watch_steps(integrated, block%values(first, 1), watcher, error)
            if (watcher%is_over) block%count = first - 1
            if (watcher%is_over .or. allocated(error)) exit
         end if
         associate (times => block%values(first:last, 1), p => integrated%positions(:, first:last), &
            v => integrated%velocities(:, first:last), tension => tensions(first:last), &
            drag => drag_work(first:last), pivot => pivot_work(first:last))
            if (present(matrices)) then
               call integrated%run%advance(times, p, v, tension, drag, pivot, error, azimuths(first:last), &
                  matrices(:, :, first:last))
            else if (block%column(quantity_azimuth) > 0) then
               call integrated%run%advance(times, p, v, tension, drag, pivot, error, azimuths(first:last))
            else
               call integrated%run%advance(times, p, v, tension, drag, pivot, error)
            end if
         end associate
         if (allocated(error)) return
         integrated%last_time = block%values(last, 1)
         first = last + 1
      end do
      if (allocated(error)) return
      associate (n => block%count)
         call put_columns(path, block, integrated%positions(:, :n), integrated%velocities(:, :n), tensions(:n), &
            drag_work(:n), pivot_work(:n), azimuths(:n))
      end associate
      if (integrated%is_checked) call compare(integrated, block, error)
   end subroutine fill_integrated

   !> Steps up to the time of a sample, each shown to a watcher.
   subroutine watch_steps(integrated, time, watcher, error)
      type(integrated_type), intent(inout), target :: integrated
      real(wp), intent(in) :: time                            !! [s]
      class(step_watcher_type), intent(inout) :: watcher
      type(error_type), allocatable, intent(out) :: error

      do while (integrated%run%time < time)
         call integrated%run%step_on(time, time - integrated%last_time, error)
         if (allocated(error)) return
         call watcher%look(integrated%run%step_start, integrated%run%time)
         if (watcher%is_over) return
      end do
   end subroutine watch_steps

   !> The columns of states.
   subroutine put_columns(path, block, positions, velocities, tensions, drag_work, pivot_work, azimuths)
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block
      real(wp), intent(in), dimension(:, :) :: positions, velocities !! (3, block%count)
      real(wp), intent(in), dimension(:) :: tensions, drag_work, pivot_work, azimuths
      integer :: i

      associate (values => block%values, n => block%count, column => block%column)
         do i = 1, 3
            if (column(quantity_position) > 0) values(:n, column(quantity_position) + i - 1) = positions(i, :n)
            if (column(quantity_velocity) > 0) values(:n, column(quantity_velocity) + i - 1) = velocities(i, :n)
         end do
         if (column(quantity_tension) > 0) values(:n, column(quantity_tension)) = tensions
         if (column(quantity_azimuth) > 0) values(:n, column(quantity_azimuth)) = azimuths
         if (column(quantity_drag_work) > 0) values(:n, column(quantity_drag_work)) = drag_work
         if (column(quantity_pivot_work) > 0) values(:n, column(quantity_pivot_work)) = pivot_work
         if (column(quantity_momentum) > 0) values(:n, column(quantity_momentum)) = positions(1, :n)*velocities(2, :n) &
            - positions(2, :n)*velocities(1, :n)
         if (column(quantity_energy) > 0) then
            do i = 1, n
               values(i, column(quantity_energy)) = mechanical_energy(path%effects, path%length, path%gravity, &
                  values(i, 1), positions(:, i), velocities(:, i))
            end do
         end if
      end associate
   end subroutine put_columns

   !> The columns at times within the last step, as samples show them, or each by a step of its own.
   subroutine fill_within(integrated, path, block, exactly, matrices)
      type(integrated_type), intent(inout) :: integrated
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block
      logical, intent(in) :: exactly
      real(wp), intent(inout), optional :: matrices(:, :, :)  !! (6, p, block%count) derivatives by the changes
      real(wp), dimension(3, block%count) :: positions, velocities
      real(wp), dimension(block%count) :: tensions, azimuths
      real(wp) :: work(2, block%count)
      integer :: i

      do i = 1, block%count
         call integrated%run%within(block%values(i, 1), exactly, positions(:, i), velocities(:, i), tensions(i), &
            work(:, i), azimuths(i))
         if (present(matrices)) call integrated%run%columns_within(block%values(i, 1), matrices(:, :, i))
      end do
      call put_columns(path, block, positions, velocities, tensions, work(1, :), work(2, :), azimuths)
   end subroutine fill_within

   !> What the finer run says of the block.
   subroutine compare(integrated, block, error)
      type(integrated_type), intent(inout) :: integrated
      type(block_type), intent(in) :: block
      type(error_type), allocatable, intent(out) :: error
      real(wp), dimension(block%count) :: tensions, drag_work, pivot_work
      real(wp) :: difference
      integer :: i

      associate (n => block%count, check => integrated%check)
         call integrated%finer%advance(block%values(:n, 1), integrated%other_positions(:, :n), &
            integrated%other_velocities(:, :n), tensions, drag_work, pivot_work, error)
         if (allocated(error)) return
         do i = 1, n
            difference = norm2(integrated%positions(:, i) - integrated%other_positions(:, i))
            if (.not. difference <= check%position) then
               check%position = difference
               check%position_time = block%values(i, 1)
            end if
            difference = norm2(integrated%velocities(:, i) - integrated%other_velocities(:, i))
            if (.not. difference <= check%velocity) then
               check%velocity = difference
               check%velocity_time = block%values(i, 1)
            end if
         end do
      end associate
   end subroutine compare

   !> Gives the memory back.
   subroutine end_integration(integrated)
      type(integrated_type), intent(inout) :: integrated

      call integrated%run%finish()
      call integrated%finer%finish()
   end subroutine end_integration

end module kyvadlo_integrated_samples
