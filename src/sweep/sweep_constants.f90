!> The constants of orbits that start between two heights, gaps or rises, by the vector kernels.
module kyvadlo_sweep_constants
   use, intrinsic :: iso_fortran_env, only: int8
   use kyvadlo_batch_constants
   use kyvadlo_batch_dispatch, only: vector_level
   use kyvadlo_buoyancy, only: effective_gravity
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_many_orbits, only: constants_of_block
   use kyvadlo_scene_groups, only: start_gaps, start_heights, start_rises
   use kyvadlo_sweep_measures
   use kyvadlo_sweep_plan
   use kyvadlo_sweep_reductions, only: status_computed
   use kyvadlo_sweep_worker, only: worker_type
   implicit none
   private
   public :: has_kernel, compute_constants

contains

   !> Whether everything a plan measures is a constant that the kernels compute.
   pure logical function has_kernel(plan)
      type(plan_type), intent(in) :: plan

      has_kernel = plan%is_exact .and. .not. plan%is_sampled .and. all(plan%measures%slope == 0) &
         .and. any(plan%scene%pendulum%start == [start_heights, start_gaps, start_rises]) &
         .and. all(plan%targets%column < column_density_ratio)
   end function has_kernel

   !> The points of a block that the kernels take; the status of the others stays as it is.
   subroutine compute_constants(plan, worker, count)
      type(plan_type), intent(in) :: plan
      type(worker_type), intent(inout) :: worker
      integer, intent(in) :: count
      real(wp) :: numbers(block_size, column_second), gaps(block_size, gap_columns)
      real(wp) :: constants(block_size, constant_columns)
      integer :: done, n, i

      do done = 0, count - 1, block_size
         n = min(block_size, count - done)
         numbers(:n, column_length) = plan%numbers%length
         numbers(:n, column_gravity) = plan%numbers%gravity
         numbers(:n, column_first) = plan%numbers%first(1)
         numbers(:n, column_second) = plan%numbers%second(1)
         do i = 1, size(plan%axes)
            if (plan%targets(i)%column == 0) cycle
            numbers(:n, plan%targets(i)%column) = worker%coordinates(done + 1:done + n, i)
         end do
         associate (effects => plan%scene%settings%effects)
            if (effects%density_ratio > 0) numbers(:n, column_gravity) = &
               effective_gravity(numbers(:n, column_gravity), effects%density_ratio, effects%added_mass)
         end associate
         call constants_of_block(vector_level(), plan%scene%pendulum%start, numbers(:n, column_length), &
            numbers(:n, column_gravity), numbers(:n, column_first), numbers(:n, column_second), .false., gaps, &
            constants)
         where (constants(:n, constant_period) > 0) worker%status(done + 1:done + n) = int(status_computed, int8)
         call give_measures(plan, numbers, gaps, constants, worker%values(done + 1:done + n, :))
      end do
   end subroutine compute_constants

   !> The columns of the measures.
   pure subroutine give_measures(plan, numbers, gaps, constants, values)
      type(plan_type), intent(in) :: plan
      real(wp), intent(in) :: numbers(:, :), gaps(:, :), constants(:, :)
      real(wp), intent(inout) :: values(:, :)
      integer :: i, at, n

      n = size(values, 1)
      at = 0
      do i = 1, size(plan%measures)
         associate (measure => plan%measures(i), period => constants(:n, constant_period), &
            length => numbers(:n, column_length))
            select case (measure%kind)
            case (exact_period:exact_advance)
               values(:, at + 1) = constants(:n, measure%kind)
            case (exact_turning)
               values(:, at + 1) = lower_height()
               values(:, at + 2) = upper_height()
               values(:, at + 3) = length + constants(:n, constant_outer_excess)
               values(:, at + 4) = gaps(:n, gap_lower_rise)
               values(:, at + 5) = gaps(:n, gap_upper)
               values(:, at + 6) = gaps(:n, gap_swing)
               values(:, at + 7) = constants(:n, constant_outer_gap)
               values(:, at + 8) = constants(:n, constant_outer_excess)
            case (exact_heights)
               values(:, at + 1) = upper_height()
               values(:, at + 2) = lower_height()
            case (exact_rates)
               values(:, at + 1) = 2*constants(:n, constant_quarter_period)/period
               values(:, at + 2) = constants(:n, constant_azimuth_rate)
               values(:, at + 3) = constants(:n, constant_advance)/period
            end select
            at = at + measure%components
         end associate
      end do

   contains

      !> Each from what was given, by one rounding at most.
      pure function lower_height() result(z)
         real(wp) :: z(n)

         z = numbers(:n, column_second)
         if (plan%scene%pendulum%start /= start_heights) z = z - numbers(:n, column_length)
      end function lower_height

      pure function upper_height() result(z)
         real(wp) :: z(n)

         z = numbers(:n, column_first)
         if (plan%scene%pendulum%start == start_gaps) z = numbers(:n, column_length) - z
         if (plan%scene%pendulum%start == start_rises) z = z - numbers(:n, column_length)
      end function upper_height
   end subroutine give_measures

end module kyvadlo_sweep_constants
