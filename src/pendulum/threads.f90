!> How many threads share a long array. A library call stays on its caller's thread unless it is asked for more.
module kyvadlo_threads
!$ use omp_lib, only: omp_get_max_threads
   use kyvadlo_batch_constants, only: block_size
   implicit none
   private
   public :: thread_count

   !> So many points keep two threads busy for longer than it takes to wake the second: they gain 1.8, fewer gain less.
   integer, parameter :: parallel_size = 16*block_size
   !> More threads are not made: a machine that cannot make as many as wanted ends the program.
   integer, parameter :: most_threads = 64

contains

   !> The threads for so many points in so many parts: 1 unless more are asked for, and without OpenMP.
   integer function thread_count(wanted, points, parts) result(threads)
      integer, intent(in), optional :: wanted  !! 0: as many as OpenMP offers
      integer, intent(in) :: points, parts

      threads = 1
      if (.not. present(wanted)) return
      if (points < parallel_size) return
!$    threads = wanted
!$    if (wanted == 0) threads = omp_get_max_threads()
      threads = max(1, min(threads, parts, most_threads))
   end function thread_count
end module kyvadlo_threads
