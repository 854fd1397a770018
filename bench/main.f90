!> `kyvadlo-bench`: what our functions cost beside those of other libraries, and their errors.
program kyvadlo_bench
   use, intrinsic :: iso_fortran_env, only: error_unit, output_unit
   use kyvadlo_bench_accuracy, only: bench_accuracy
   use kyvadlo_bench_fits, only: bench_fits
   use kyvadlo_bench_functions, only: bench_functions
   use kyvadlo_bench_integrated, only: bench_integrated
   use kyvadlo_bench_interfaces, only: bench_interfaces
   use kyvadlo_bench_motion, only: bench_motion
   use kyvadlo_bench_scenes, only: bench_scenes
   use kyvadlo_bench_threads, only: bench_threads
   implicit none

   character(len=*), parameter :: tables(8) = [character(len=12) :: &
      '--functions', '--interfaces', '--motion', '--accuracy', '--scenes', '--threads', '--fits', &
      '--integrated']
   character(len=*), parameter :: help(*) = [character(len=88) :: &
      'Usage: kyvadlo-bench [--functions] [--interfaces] [--motion] [--accuracy] [--scenes]', &
      '                     [--threads] [--fits] [--integrated] [--quick]', &
      '', &
      '  --functions   the elliptic functions', &
      '  --interfaces  a call from Fortran, from C and from Fortran 77', &
      '  --motion      positions, velocities, periods and set-up', &
      '  --accuracy    positions to a stated accuracy', &
      '  --scenes      samples of simulated scenes', &
      '  --threads     many positions on one thread and two, idle and beside two busy loops', &
      '  --fits        fits of long tables', &
      '  --integrated  scenes without a closed form, beside GSL''s driver', &
      '  --quick       a tenth of the passes: to see that it runs, not to measure', &
      '', &
      'Without a table named, all. Medians of several passes, all columns of a row measured in', &
      'turn, in units of a scalar sine measured beside. GSL and Boost run beside ours where', &
      'this build found them.']
   logical :: wanted(size(tables)), quick
   character(len=80) :: word
   integer :: i, line

   wanted = .false.
   quick = .false.
   do i = 1, command_argument_count()
      call get_command_argument(i, word)
      select case (word)
      case ('--help', '-h')
         write (output_unit, '(a)') (trim(help(line)), line=1, size(help))
         stop
      case ('--quick')
         quick = .true.
      case default
         if (.not. any(tables == word)) then
            write (error_unit, '(3a)') "kyvadlo-bench: unknown option '", trim(word), &
               "'; kyvadlo-bench --help lists them"
            stop 2, quiet=.true.
         end if
         wanted = wanted .or. tables == word
      end select
   end do
   if (.not. any(wanted)) wanted = .true.
   if (wanted(1)) call bench_functions(output_unit, quick)
   if (wanted(2)) call bench_interfaces(output_unit, quick)
   if (wanted(3)) call bench_motion(output_unit, quick)
   if (wanted(4)) call bench_accuracy(output_unit, quick)
   if (wanted(5)) call bench_scenes(output_unit, quick)
   if (wanted(6)) call bench_threads(output_unit, quick)
   if (wanted(7)) call bench_fits(output_unit, quick)
   if (wanted(8)) call bench_integrated(output_unit, quick)
end program kyvadlo_bench
