!> `kyvadlo bench --accuracy`: what an accuracy costs in time, and whether it is kept.
module kyvadlo_bench_accuracy
   use, intrinsic :: iso_fortran_env, only: int64, real64, real128
!$ use omp_lib, only: omp_get_max_threads, omp_set_num_threads
   use kyvadlo
   use kyvadlo_batch_dispatch, only: vector_level
   use kyvadlo_bench_rows, only: median, nanoseconds_since
   implicit none
   private
   public :: bench_accuracy

   !> The last is a place of an orbit without an accuracy, what the others are measured by.
   real(real64), parameter :: accuracies(6) = [1e-3_real64, 1e-6_real64, 1e-9_real64, 1e-12_real64, 1e-15_real64, 1e-20_real64]
   integer, parameter :: rows = size(accuracies) + 1
   integer, parameter :: points = 10240

contains

   !> Measures and prints; one thread, medians over passes in which all rows are measured in turn.
   subroutine bench_accuracy(unit, quick)
      integer, intent(in) :: unit    !! Where to print
      logical, intent(in) :: quick   !! Few passes: to see that it runs, not to measure
      integer :: threads, passes
      real(real64) :: checksum

      threads = 1
!$    threads = omp_get_max_threads()
!$    call omp_set_num_threads(1)
      passes = merge(3, 41, quick)
      checksum = 0
      write (unit, '(a,/,a,/,a)') &
         'Places at 10240 times over 1000 periods, one thread: nanoseconds a point, their part of what full double precision', &
         'takes, and the worst distance from the real128 motion (1e-20: from the same with 64 times less span; in l).', ''
      call print_places(unit, 'k**2 < 1/2', 1.3_real64, 0.1_real64, passes, quick, checksum)
      call print_places(unit, 'k**2 > 1/2', 0.8_real64, 0.1_real64, passes, quick, checksum)
!$    call omp_set_num_threads(threads)
      write (unit, '(a,es22.15)') 'Sum of all values computed: ', checksum
   end subroutine bench_accuracy
end module kyvadlo_bench_accuracy
