!> What one thread of a sweep computes with.
module kyvadlo_sweep_worker
   use, intrinsic :: iso_fortran_env, only: int8, int64
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: group_type
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_sweep_axes, only: axis_values
   use kyvadlo_sweep_plan, only: plan_type
   use kyvadlo_sweep_reductions, only: bins_type, block_points, chunk_type, new_bins
   implicit none
   private
   public :: worker_type, new_worker, compute_interface

   type :: column_type
      real(wp), allocatable :: values(:)
      real(wp) :: least = 0, greatest = 0            !! Of all of them, where they are kept
   end type column_type

   type :: worker_type
      type(bins_type), allocatable :: bins(:)
      type(group_type), allocatable :: groups(:)        !! Of the scene, with the values of a point
      type(simulation_type) :: scene                    !! The same, read
      type(column_type), allocatable :: axes(:)         !! All values of the axes that are not too long
      real(wp), allocatable :: coordinates(:, :)        !! (point, axis)
      real(wp), allocatable :: values(:, :)             !! (point, component)
      integer(int8), allocatable :: status(:)
      real(wp) :: gaps(block_points, 2) = 0             !! l - z1, l + z2 that many points share
      real(wp) :: shared_gap(2) = 0                     !! Their value
   end type worker_type

   !> Values of an axis that are kept.
   integer(int64), parameter :: most_kept = 65536

   abstract interface
      !> Everything of one chunk: `compute_chunk` of kyvadlo_sweep_points.
      subroutine compute_interface(plan, worker, chunk, found)
         import :: plan_type, worker_type, chunk_type, int64
         type(plan_type), intent(in) :: plan
         type(worker_type), intent(inout) :: worker
         integer(int64), intent(in) :: chunk
         type(chunk_type), intent(inout) :: found
      end subroutine compute_interface
   end interface

contains

   subroutine new_worker(plan, worker)
      type(plan_type), intent(in) :: plan
      type(worker_type), intent(out) :: worker
      integer :: i

      worker%groups = plan%groups
      worker%scene = plan%scene
      allocate (worker%bins(size(plan%histograms)))
      do i = 1, size(plan%histograms)
         associate (histogram => plan%histograms(i))
            worker%bins(i) = new_bins(histogram%from, histogram%to, histogram%bins, histogram%is_log)
         end associate
      end do
      allocate (worker%axes(size(plan%axes)))
      do i = 1, size(plan%axes)
         if (plan%axes(i)%count > most_kept) cycle
         allocate (worker%axes(i)%values(plan%axes(i)%count))
         call axis_values(plan%axes(i), 0_int64, worker%axes(i)%values)
         worker%axes(i)%least = minval(worker%axes(i)%values)
         worker%axes(i)%greatest = maxval(worker%axes(i)%values)
      end do
      allocate (worker%coordinates(block_points, size(plan%axes)))
      allocate (worker%values(block_points, sum(plan%measures%components)))
      allocate (worker%status(block_points))
   end subroutine new_worker

end module kyvadlo_sweep_worker
