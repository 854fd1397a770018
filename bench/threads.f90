!> `kyvadlo-bench --threads`: what a second thread gains and loses, on a machine with nothing else to do and beside two
!> busy loops.
module kyvadlo_bench_threads
   use, intrinsic :: iso_fortran_env, only: int64, output_unit, real64
   use kyvadlo, only: error_type => kyvadlo_error_type, new_orbit_from_gaps, orbit_type
   use kyvadlo_stopwatch, only: median, nanoseconds_since
   implicit none
   private
   public :: bench_threads

   integer, parameter :: points = 18000
   !> Two shells that count for nothing as long as this program, their shell's parent, runs.
   character(len=*), parameter :: busy_loops = 'p=$PPID; for i in 1 2; do (while kill -0 $p; do :; done) '// &
      '> /dev/null 2>&1 < /dev/null & done'

contains

   !> Measures and prints medians, one thread and two in turn. The last table: the busy loops end with the program.
   subroutine bench_threads(unit, quick)
      integer, intent(in) :: unit    !! Where to print
      logical, intent(in) :: quick   !! Few passes: to see that it runs, not to measure
      integer :: status, command_status

      write (unit, '(/,a,i0,a,/)') 'One call for positions and velocities at ', points, ' times, in milliseconds.'
      write (unit, '(a)') '                       threads=1: median    fastest  threads=2: median    fastest'
      call measure(unit, 'nothing else to do', merge(0.2_real64, 5.0_real64, quick))
      flush (output_unit)
      call execute_command_line(busy_loops, exitstat=status, cmdstat=command_status)
      if (status /= 0 .or. command_status /= 0) then
         write (unit, '(a)') 'no shell here to run busy loops in'
      else
         call measure(unit, 'beside two busy loops', merge(0.2_real64, 5.0_real64, quick))
      end if
   end subroutine bench_threads

   subroutine measure(unit, name, seconds)
      integer, intent(in) :: unit
      character(len=*), intent(in) :: name
      real(real64), intent(in) :: seconds   !! At most so long; the system takes time to share the cores out
      integer, parameter :: passes = 20000
      real(real64), allocatable :: time(:), position(:, :), velocity(:, :), taken(:, :)
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      integer(int64) :: begun, start
      integer :: i, pass, threads

      allocate (time(points), position(3, points), velocity(3, points), taken(passes, 2))
      time = [(1e-3_real64*i, i=1, points)]
      call new_orbit_from_gaps(orbit, 1.0_real64, 9.81_real64, 0.8_real64, 0.1_real64, error)
      call system_clock(begun)
      do pass = 1, passes
         do threads = 1, 2
            call system_clock(start)
            call orbit%locate(time, position, velocity, threads=threads)
            taken(pass, threads) = nanoseconds_since(start)/1e6_real64
         end do
         if (nanoseconds_since(begun) > seconds*1e9_real64) exit
      end do
      pass = min(pass, passes)
      write (unit, '(a,t23,2(f19.3,f11.3))') name, &
         (median(taken(:pass, threads)), minval(taken(:pass, threads)), threads=1, 2)
   end subroutine measure

end module kyvadlo_bench_threads
