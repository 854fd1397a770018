!> T alone over the gaps above and below the motion, by the vector kernel; on the edges of what is admissible, where
!> that may decide otherwise than `eval orbit`, by the set-up.
module kyvadlo_sweep_periods
   use, intrinsic :: iso_fortran_env, only: int8, int64
   use kyvadlo_buoyancy, only: effective_gravity, effective_gravity_rest
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_many_orbits, only: constants_of_orbit
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_periods, only: orbits_period_from_gaps
   use kyvadlo_scene_groups, only: start_gaps
   use kyvadlo_start_real64, only: new_orbit
   use kyvadlo_status, only: error_type
   use kyvadlo_sweep_axes, only: axis_values
   use kyvadlo_sweep_plan
   use kyvadlo_sweep_reductions
   use kyvadlo_sweep_worker, only: worker_type
   implicit none
   private
   public :: reduce_periods, compute_periods, least_run

   !> Points along the fastest dimension from which on they are computed without a copy.
   integer, parameter :: least_run = 256
   !> Sums of two lengths are rounded: some bits around what is compared.
   real(wp), parameter, public :: edge = 8*epsilon(1.0_wp)

contains

   !> T alone over the two gaps, into histograms alone: nothing is copied that the kernel and the reduction do not need.
   subroutine reduce_periods(plan, worker, first, count, found)
      type(plan_type), intent(in) :: plan
      type(worker_type), intent(inout), target :: worker
      integer(int64), intent(in) :: first, count
      type(chunk_type), intent(inout) :: found
      real(wp), pointer, contiguous :: upper_gap(:), lower_rise(:)
      real(wp) :: period(block_points)
      real(wp), dimension(block_points/group_points) :: least, greatest, total
      real(wp) :: gravity, low(2), high(2)
      integer(int64) :: done, row
      integer :: n
      logical :: is_shared(2)

      gravity = gravity_of(plan)
      row = plan%dimensions(size(plan%dimensions))%count
      done = 0
      do while (done < count)
         n = int(min(int(block_points, int64), count - done, row - mod(first + done, row)))
         call find_gaps(column_first, 1, upper_gap)
         call find_gaps(column_second, 2, lower_rise)
         call orbits_period_from_gaps(plan%numbers%length, gravity, upper_gap, lower_rise, period(:n))
         if (is_near_edge()) then
            if (.not. is_shared(1)) call find_range(upper_gap, low(1), high(1))
            if (.not. is_shared(2)) call find_range(lower_rise, low(2), high(2))
            if (is_near_edge()) call set_edges(plan, upper_gap, lower_rise, period(:n))
         end if
         call reduce_block(worker%bins(1), period(:n), found%reduction(status_count + 1:))
         done = done + n
      end do
      found%reduction(status_computed) = found%reduction(status_count + item_count)
      found%reduction(status_inadmissible) = count - found%reduction(status_count + item_count)

   contains

      !> Whether the range of the gaps allows for a plane or a conical orbit.
      pure logical function is_near_edge()
         associate (diameter => 2*plan%numbers%length)
            is_near_edge = .not. (low(2) > 0 .and. (high(1) + high(2) < diameter*(1 - edge) .or. &
               low(1) + low(2) > diameter*(1 + edge)))
         end associate
      end function is_near_edge

      !> The values of one gap at the points of the run, and a range that they lie in.
      subroutine find_gaps(column, gap, values)
         integer, intent(in) :: column, gap
         real(wp), pointer, contiguous, intent(out) :: values(:)
         integer(int64) :: index
         integer :: axis
         real(wp) :: value(1)

         axis = findloc(plan%targets%column, column, 1)
         is_shared(gap) = axis == 0
         value = merge(plan%numbers%first(1), plan%numbers%second(1), gap == 1)
         low(gap) = -huge(low)/4
         high(gap) = huge(high)/4
         if (axis > 0) then
            index = mod((first + done)/product(plan%dimensions(plan%dimension_of(axis) + 1:)%count), &
               plan%axes(axis)%count)
            is_shared(gap) = plan%dimension_of(axis) < size(plan%dimensions)
            if (allocated(worker%axes(axis)%values)) then
               value = worker%axes(axis)%values(index + 1)
               values => worker%axes(axis)%values(index + 1:index + n)
               low(gap) = worker%axes(axis)%least
               high(gap) = worker%axes(axis)%greatest
            else if (is_shared(gap)) then
               call axis_values(plan%axes(axis), index, value)
            else
               call axis_values(plan%axes(axis), index, worker%coordinates(:n, axis))
               values => worker%coordinates(:n, axis)
            end if
         end if
         if (.not. is_shared(gap)) return
         low(gap) = value(1)
         high(gap) = value(1)
         if (abs(worker%shared_gap(gap) - value(1)) > 0) worker%gaps(:, gap) = value(1)
         worker%shared_gap(gap) = value(1)
         values => worker%gaps(:n, gap)
      end subroutine find_gaps

      subroutine find_range(values, lowest, highest)
         real(wp), intent(in), contiguous :: values(:)
         real(wp), intent(out) :: lowest, highest
         integer :: whole

         whole = n/group_points
         call reduce_groups(values, least, greatest, total)
         lowest = min(minval(least(:whole)), minval(values(whole*group_points + 1:)))
         highest = max(maxval(greatest(:whole)), maxval(values(whole*group_points + 1:)))
      end subroutine find_range
   end subroutine reduce_periods

   !> T by the set-up where the kernel may accept what that refuses, or the other way round: plane orbits, and conical
   !> ones to the last bits. NaN where `eval orbit` refuses.
   subroutine set_edges(plan, upper_gap, lower_rise, period)
      type(plan_type), intent(in) :: plan
      real(wp), intent(in), dimension(:) :: upper_gap, lower_rise
      real(wp), intent(inout) :: period(:)
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      real(wp) :: rest
      integer :: i

      associate (length => plan%numbers%length, effects => plan%scene%settings%effects)
         rest = effective_gravity_rest(plan%numbers%gravity, effects%density_ratio, effects%added_mass)
         do i = 1, size(period)
            if (abs(lower_rise(i)) > 0 .and. &
               abs((upper_gap(i) - length) + (lower_rise(i) - length)) > 2*length*edge) cycle
            period(i) = quiet_nan_real64
            call new_orbit(orbit, start_gaps, length, gravity_of(plan), upper_gap(i:i), lower_rise(i:i), error, &
               [0.0_wp, rest])
            if (allocated(error)) cycle
            if (.not. any(constants_of_orbit(orbit) /= constants_of_orbit(orbit))) period(i) = orbit%period()
         end do
      end associate
   end subroutine set_edges

   !> T of a block, by the vector kernel; where the set-up may decide otherwise than it does, by the set-up.
   subroutine compute_periods(plan, worker, count)
      type(plan_type), intent(in) :: plan
      type(worker_type), intent(inout) :: worker
      integer, intent(in) :: count
      real(wp), dimension(count) :: upper_gap, lower_rise, period
      integer :: i

      upper_gap = plan%numbers%first(1)
      lower_rise = plan%numbers%second(1)
      do i = 1, size(plan%axes)
         if (plan%targets(i)%column == column_first) upper_gap = worker%coordinates(:count, i)
         if (plan%targets(i)%column == column_second) lower_rise = worker%coordinates(:count, i)
      end do
      call orbits_period_from_gaps(plan%numbers%length, gravity_of(plan), upper_gap, lower_rise, period)
      call set_edges(plan, upper_gap, lower_rise, period)
      worker%status(:count) = int(merge(status_computed, status_inadmissible, period == period), int8)
      do i = 1, size(plan%measures)
         worker%values(:count, i) = period
      end do
   end subroutine compute_periods

   pure real(wp) function gravity_of(plan)
      type(plan_type), intent(in) :: plan

      associate (effects => plan%scene%settings%effects)
         gravity_of = effective_gravity(plan%numbers%gravity, effects%density_ratio, effects%added_mass)
      end associate
   end function gravity_of

end module kyvadlo_sweep_periods
