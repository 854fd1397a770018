!> How a grid is cut into chunks: each lies in one piece in every variable, and the plan alone fixes them.
module kyvadlo_sweep_chunks
   use, intrinsic :: iso_fortran_env, only: int64
   implicit none
   private
   public :: cut_type, new_cut, chunk_range, chunk_start

   !> A chunk is `block` steps along the dimension `along`, with all of the faster ones.
   type :: cut_type
      integer(int64), allocatable :: counts(:)       !! Of the dimensions, the slowest first
      integer(int64) :: chunks = 0
      integer :: along = 1
      integer(int64) :: inner = 1                    !! Points of a step
      integer(int64) :: block = 1, blocks = 1        !! Steps of a chunk, chunks along the dimension
   end type cut_type

contains

   !> Chunks of at most so many points.
   pure subroutine new_cut(cut, counts, most)
      type(cut_type), intent(out) :: cut
      integer(int64), intent(in) :: counts(:), most

      cut%counts = counts
      cut%along = size(counts)
      do while (cut%along > 1)
         if (cut%inner*counts(cut%along) > most) exit
         cut%inner = cut%inner*counts(cut%along)
         cut%along = cut%along - 1
      end do
      cut%block = max(1_int64, min(counts(cut%along), most/cut%inner))
      cut%blocks = (counts(cut%along) + cut%block - 1)/cut%block
      cut%chunks = product(counts(:cut%along - 1))*cut%blocks
   end subroutine new_cut

   !> The points of a chunk (both from 0).
   pure subroutine chunk_range(cut, chunk, first, count)
      type(cut_type), intent(in) :: cut
      integer(int64), intent(in) :: chunk
      integer(int64), intent(out) :: first, count
      integer(int64) :: step

      step = mod(chunk, cut%blocks)*cut%block
      associate (steps => cut%counts(cut%along))
         first = (chunk/cut%blocks*steps + step)*cut%inner
         count = min(cut%block, steps - step)*cut%inner
      end associate
   end subroutine chunk_range

   !> Where a chunk lies along the dimensions: from 1 on, the fastest first, as NetCDF wants it in Fortran.
   pure subroutine chunk_start(cut, chunk, start, count)
      type(cut_type), intent(in) :: cut
      integer(int64), intent(in) :: chunk
      integer(int64), intent(out) :: start(:), count(:)
      integer(int64) :: first, points
      integer :: d, n

      n = size(cut%counts)
      call chunk_range(cut, chunk, first, points)
      do d = n, 1, -1
         start(n + 1 - d) = mod(first, cut%counts(d)) + 1
         first = first/cut%counts(d)
         count(n + 1 - d) = 1
         if (d > cut%along) count(n + 1 - d) = cut%counts(d)
         if (d == cut%along) count(n + 1 - d) = points/cut%inner
      end do
   end subroutine chunk_start

end module kyvadlo_sweep_chunks
