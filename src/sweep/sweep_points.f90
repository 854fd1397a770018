!> What is computed at the points of a sweep. Each point by itself: what comes out depends on the plan and the point
!> alone, not on who computes it.
module kyvadlo_sweep_points
   use, intrinsic :: iso_fortran_env, only: int8, int64
   use kyvadlo_buoyancy, only: effective_gravity, effective_gravity_rest
   use kyvadlo_derivatives_real64
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_many_orbits, only: constants_of_orbit
   use kyvadlo_number_text, only: shortest_text
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_scene, only: pendulum_type
   use kyvadlo_scene_groups, only: pendulum_group, settings, start_energy, start_gaps, start_heights, start_release, &
      start_rises
   use kyvadlo_scene_reader, only: pendulums_from_groups
   use kyvadlo_scene_settings_reader, only: settings_from_groups
   use kyvadlo_simulate, only: simulate
   use kyvadlo_simulation_path, only: choose_path, path_type
   use kyvadlo_start_real64, only: new_orbit
   use kyvadlo_status, only: code_unsupported, error_type
   use kyvadlo_sweep_axes, only: axis_values
   use kyvadlo_sweep_chunks, only: chunk_range
   use kyvadlo_sweep_constants, only: compute_constants, has_kernel
   use kyvadlo_sweep_measures
   use kyvadlo_sweep_periods, only: compute_periods, edge, least_run, reduce_periods
   use kyvadlo_sweep_plan
   use kyvadlo_sweep_reductions
   use kyvadlo_sweep_samples, only: begin_measures, get_measures, measured_samples_type
   use kyvadlo_sweep_worker, only: worker_type
   implicit none
   private
   public :: compute_chunk

contains

   !> Everything of one chunk.
   subroutine compute_chunk(plan, worker, chunk, found)
      type(plan_type), intent(in) :: plan
      type(worker_type), intent(inout) :: worker
      integer(int64), intent(in) :: chunk
      type(chunk_type), intent(inout) :: found
      integer(int64) :: first, count, done
      integer :: i, n, at

      call chunk_range(plan%cut, chunk, first, count)
      call size_chunk(plan, worker%bins, chunk, count, found)
      at = status_count
      do i = 1, size(worker%bins)
         call begin_reduction(worker%bins(i), found%reduction(at + 1:at + items + worker%bins(i)%count))
         at = at + items + worker%bins(i)%count
      end do
      if (plan%is_period_of_gaps .and. .not. plan%stores_values .and. &
         plan%dimensions(size(plan%dimensions))%count >= least_run) then
         call reduce_periods(plan, worker, first, count, found)
      else
         done = 0
         do while (done < count)
            n = int(min(int(block_points, int64), count - done))
            call compute_block(plan, worker, first + done, done, n, found)
            done = done + n
         end do
      end if
      at = status_count
      do i = 1, size(worker%bins)
         call end_reduction(worker%bins(i), found%reduction(at + 1:at + items + worker%bins(i)%count))
         at = at + items + worker%bins(i)%count
      end do
   end subroutine compute_chunk

   !> Some points of a chunk, from one on.
   subroutine compute_block(plan, worker, first, done, n, found)
      type(plan_type), intent(in) :: plan
      type(worker_type), intent(inout) :: worker
      integer(int64), intent(in) :: first, done      !! Point of the sweep; points of the chunk before it
      integer, intent(in) :: n
      type(chunk_type), intent(inout), target :: found
      real(wp), pointer, contiguous :: column(:)
      real(wp) :: values(block_points)
      integer :: i, j, at

      call set_coordinates(plan, worker, first, n)
      if (plan%is_period_of_gaps) then
         call compute_periods(plan, worker, n)
      else
         worker%status(:n) = status_inadmissible
         if (has_kernel(plan)) call compute_constants(plan, worker, n)
         do i = 1, n
            if (worker%status(i) /= status_computed) call compute_point(plan, worker, i)
         end do
      end if
      do i = 1, status_count
         found%reduction(i) = found%reduction(i) + count_status(worker%status(:n), i)
      end do
      if (allocated(found%status)) found%status(done + 1:done + n) = worker%status(:n)
      at = 0
      do i = 1, size(plan%measures)
         associate (m => plan%measures(i)%components)
            if (plan%measures(i)%histogram == 0) then
               if (m == 1) then
                  column(1:size(found%stored(i)%values)) => found%stored(i)%values
                  column(done + 1:done + n) = worker%values(:n, at + 1)
               else
                  found%stored(i)%values(:, done + 1:done + n) = transpose(worker%values(:n, at + 1:at + m))
               end if
            end if
            at = at + m
         end associate
      end do
      j = status_count
      do i = 1, size(plan%histograms)
         values(:n) = worker%values(:n, component_of(plan, i))
         call reduce_block(worker%bins(i), values(:n), found%reduction(j + 1:j + items + worker%bins(i)%count))
         j = j + items + worker%bins(i)%count
      end do
   end subroutine compute_block

   !> Whether two turning heights are none by more than what rounding may change. The set-up refuses them too, but its
   !> message takes many times as long as an orbit.
   pure logical function is_far_off(start, length, first, second)
      integer, intent(in) :: start
      real(wp), intent(in) :: length, first, second
      real(wp) :: upper, lower, margin

      is_far_off = .false.
      lower = second - length
      select case (start)
      case (start_heights)
         upper = first
         lower = second
      case (start_gaps)
         upper = length - first
      case (start_rises)
         upper = first - length
      case default
         return
      end select
      margin = 2*abs(length)*edge
      is_far_off = lower > upper + margin .or. upper + lower > margin .or. lower < -length - margin
   end function is_far_off

   !> Where the quantity of a histogram stands among the components.
   pure integer function component_of(plan, histogram) result(at)
      type(plan_type), intent(in) :: plan
      integer, intent(in) :: histogram

      at = findloc(plan%measures%histogram, histogram, 1)
      at = sum(plan%measures(:at)%components)
   end function component_of

   pure real(wp) function count_status(status, which)
      integer(int8), intent(in) :: status(:)
      integer, intent(in) :: which

      count_status = count(status == which)
   end function count_status

   !> Room for a chunk, and reductions of nothing.
   subroutine size_chunk(plan, bins, chunk, count, found)
      type(plan_type), intent(in) :: plan
      type(bins_type), intent(in) :: bins(:)
      integer(int64), intent(in) :: chunk, count
      type(chunk_type), intent(inout) :: found
      integer :: i

      found%chunk = chunk
      if (.not. allocated(found%reduction)) allocate (found%reduction(reduction_size(bins)))
      found%reduction = 0
      if (found%count == count) return
      found%count = count
      if (.not. plan%stores_values) return
      if (allocated(found%stored)) deallocate (found%stored, found%status)
      allocate (found%stored(size(plan%measures)), found%status(count))
      do i = 1, size(plan%measures)
         allocate (found%stored(i)%values(plan%measures(i)%components, &
            merge(count, 0_int64, plan%measures(i)%histogram == 0)))
      end do
   end subroutine size_chunk

   !> The coordinates of some points that follow each other.
   subroutine set_coordinates(plan, worker, first, count)
      type(plan_type), intent(in) :: plan
      type(worker_type), intent(inout) :: worker
      integer(int64), intent(in) :: first
      integer, intent(in) :: count
      integer(int64) :: stride, index, point
      integer :: i, run, done
      real(wp) :: one(1)

      do i = 1, size(plan%axes)
         associate (axis => plan%axes(i), d => plan%dimension_of(i))
            stride = product(plan%dimensions(d + 1:)%count)
            done = 0
            do while (done < count)
               point = first + done
               index = mod(point/stride, axis%count)
               if (stride == 1) then
                  run = int(min(axis%count - index, int(count - done, int64)))
                  if (allocated(worker%axes(i)%values)) then
                     worker%coordinates(done + 1:done + run, i) = worker%axes(i)%values(index + 1:index + run)
                  else
                     call axis_values(axis, index, worker%coordinates(done + 1:done + run, i))
                  end if
               else
                  run = int(min(stride - mod(point, stride), int(count - done, int64)))
                  if (allocated(worker%axes(i)%values)) then
                     one = worker%axes(i)%values(index + 1)
                  else
                     call axis_values(axis, index, one)
                  end if
                  worker%coordinates(done + 1:done + run, i) = one(1)
               end if
               done = done + run
            end do
         end associate
      end do
   end subroutine set_coordinates

   !> One point of the block.
   subroutine compute_point(plan, worker, point)
      type(plan_type), intent(in) :: plan
      type(worker_type), intent(inout) :: worker
      integer, intent(in) :: point
      integer :: status

      status = status_computed
      worker%values(point, :) = quiet_nan_real64
      if (plan%is_exact) call measure_orbit(plan, worker%coordinates(point, :), worker%values(point, :), status)
      if (plan%is_sampled .and. status == status_computed) call measure_samples(plan, worker, point, status)
      if (status /= status_computed) worker%values(point, :) = quiet_nan_real64
      worker%status(point) = int(status, int8)
   end subroutine compute_point

   !> The constants of an orbit.
   subroutine measure_orbit(plan, coordinates, values, status)
      type(plan_type), intent(in) :: plan
      real(wp), intent(in) :: coordinates(:)
      real(wp), intent(inout) :: values(:)
      integer, intent(inout) :: status
      type(orbit_type) :: orbit
      type(derivatives_type) :: slopes
      type(error_type), allocatable :: error
      real(wp) :: numbers(orbit_columns), gravity, rest, constants(8), period_slopes(8), advance_slopes(8)
      integer :: i, n, at

      associate (effects => plan%scene%settings%effects, start => plan%scene%pendulum%start)
         numbers = [plan%numbers%length, plan%numbers%gravity, plan%numbers%first, plan%numbers%second, &
            effects%density_ratio, effects%added_mass]
         do i = 1, size(coordinates)
            if (plan%targets(i)%column > 0) numbers(plan%targets(i)%column) = coordinates(i)
         end do
         status = status_inadmissible
         associate (ratio => numbers(column_density_ratio), mass => numbers(column_added_mass))
            if (.not. (ratio >= 0 .and. ratio < 1 .and. mass >= 0)) return
            gravity = effective_gravity(numbers(column_gravity), ratio, mass)
            rest = effective_gravity_rest(numbers(column_gravity), ratio, mass)
         end associate
         if (is_far_off(start, numbers(column_length), numbers(column_first), numbers(column_second))) return
         n = plan%scene%pendulum%values
         call new_orbit(orbit, start, numbers(column_length), gravity, numbers(column_first:column_first + n - 1), &
            numbers(column_second:column_second + n - 1), error, [0.0_wp, rest])
         if (allocated(error)) return
         constants = constants_of_orbit(orbit)
         ! What `eval orbit` refuses.
         if (any(constants /= constants)) return
         status = status_computed
         if (any(plan%measures%slope > 0)) then
            associate (length => numbers(column_length), first => numbers(column_first), &
               second => numbers(column_second))
               select case (start)
               case (start_heights)
                  call new_derivatives_from_heights(slopes, length, gravity, first, second, error)
               case (start_gaps)
                  call new_derivatives_from_gaps(slopes, length, gravity, first, second, error)
               case (start_rises)
                  call new_derivatives_from_rises(slopes, length, gravity, first, second, error)
               case (start_energy)
                  call new_derivatives_from_energy(slopes, length, gravity, first, second, error)
               case (start_release)
                  call new_derivatives_from_release(slopes, length, gravity, first, second, error)
               case default
                  call new_derivatives_from_state(slopes, length, gravity, numbers(column_first:column_first + 2), &
                     numbers(column_second:column_second + 2), error)
               end select
            end associate
            period_slopes = quiet_nan_real64
            advance_slopes = quiet_nan_real64
            if (.not. allocated(error)) call slopes%of_period(period_slopes, advance_slopes)
         end if
      end associate
      at = 0
      do i = 1, size(plan%measures)
         associate (measure => plan%measures(i), turning => orbit%turning)
            select case (measure%kind)
            case (exact_period:exact_advance)
               values(at + 1) = constants(measure%kind)
            case (exact_turning)
               values(at + 1:at + 8) = [turning%lower, turning%upper, turning%outer, turning%lower_rise, &
                  turning%upper_gap, turning%swing, turning%outer_gap, turning%outer_excess]
            case (exact_heights)
               values(at + 1:at + 2) = [turning%upper, turning%lower]
            case (exact_rates)
               values(at + 1:at + 3) = [orbit%phase_rate(), orbit%azimuth_rate(), orbit%apsidal_rate()]
            case (exact_period_slope)
               values(at + 1) = period_slopes(measure%slope)
            case (exact_advance_slope)
               values(at + 1) = advance_slopes(measure%slope)
            end select
            at = at + measure%components
         end associate
      end do
   end subroutine measure_orbit

   !> What the samples of a scene show.
   subroutine measure_samples(plan, worker, point, status)
      type(plan_type), intent(in) :: plan
      type(worker_type), intent(inout) :: worker
      integer, intent(in) :: point
      integer, intent(inout) :: status
      type(pendulum_type), allocatable :: pendulums(:)
      type(path_type) :: path
      type(measured_samples_type) :: samples
      type(error_type), allocatable :: error
      integer :: i

      do i = 1, size(plan%axes)
         associate (target => plan%targets(i))
            worker%groups(target%group)%entries(target%entry)%values(target%value)%text = &
               shortest_text(worker%coordinates(point, i))
         end associate
      end do
      status = status_inadmissible
      ! What no axis varies stays as it was read.
      if (any(settings(plan%targets%setting)%group /= pendulum_group)) then
         call settings_from_groups(worker%groups, plan%file, worker%scene%settings, error)
         worker%scene%settings%quantities = plan%scene%settings%quantities
      end if
      if (.not. allocated(error) .and. any(settings(plan%targets%setting)%group == pendulum_group)) then
         call pendulums_from_groups(worker%groups, plan%file, pendulums, error)
         if (.not. allocated(error)) worker%scene%pendulum = pendulums(1)
      end if
      if (allocated(error)) return
      call choose_path(worker%scene, path, error)
      if (allocated(error)) then
         if (error%code == code_unsupported) status = status_refused
         return
      end if
      path%threads = 1
      call begin_measures(samples, plan%measures, plan%watch)
      call simulate(worker%scene, path, samples, error)
      status = merge(status_failed, status_computed, allocated(error))
      if (.not. allocated(error)) call get_measures(samples, worker%values(point, :))
   end subroutine measure_samples

end module kyvadlo_sweep_points
