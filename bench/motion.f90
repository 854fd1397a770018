!> `kyvadlo-bench --motion`: positions, velocities, periods and set-up timed in units of a scalar sine, beside the floor
!> and others.
module kyvadlo_bench_motion
   use, intrinsic :: iso_fortran_env, only: int64, real64, real128
!$ use omp_lib, only: omp_get_max_threads
   use kyvadlo, error_type => kyvadlo_error_type
   use kyvadlo_batch_dispatch, only: vector_level
   use kyvadlo_bench_derivatives, only: print_derivatives
   use kyvadlo_bench_floor_baseline, only: floor_baseline => floor_loop
   use kyvadlo_bench_floor_v3, only: floor_v3 => floor_loop
   use kyvadlo_bench_floor_v4, only: floor_v4 => floor_loop
   use kyvadlo_bench_peers, only: peer_type, peers, gsl_motion
   use kyvadlo_bench_rivals, only: quoted, quoted_sine, rival_type
   use kyvadlo_stopwatch, only: median, nanoseconds_since
   implicit none
   private
   public :: bench_motion

   !> Times in a batch (40 whole strips of the floor, 1e4 in round numbers) and single calls in a pass.
   integer, parameter :: points = 10240, calls = 400, many = 2**20

   integer, parameter :: sine_row = 1, floor_row = 2, direct_row = 3, dual_row = 4, direct_rates_row = 5, &
      dual_rates_row = 6, direct_azimuth_row = 7, dual_azimuth_row = 8, last_of_level = 8, one_direct = 9, &
      one_dual = 10, one_upright = 11, one_rates = 12, one_azimuth = 13, set_up_direct = 14, set_up_dual = 15, &
      set_up_upright = 16, set_up_state = 17, period_one = 18, period_upright = 19, period_many = 20, &
      period_many_upright = 21, both_many = 22, constants_many = 23, position_many = 24, last_row = 24

   type :: bench_type
      type(orbit_type) :: direct, dual, upright
      real(real64), dimension(points) :: time, a, b, top, bottom, top_upright, bottom_upright
      real(real64), dimension(points, 6) :: out
      real(real64), dimension(3, points) :: position
      real(real64), dimension(8, points) :: constants
      real(real64) :: checksum = 0
   end type bench_type

contains

   !> Measures and prints the tables. Every figure is a median over passes; all rows are measured in turn, pass by pass,
   !> on one thread but for the last table.
   subroutine bench_motion(unit, quick)
      integer, intent(in) :: unit    !! Where to print
      logical, intent(in) :: quick   !! Few passes: to see that it runs, not to measure
      type(bench_type), allocatable :: bench
      real(real64), allocatable :: times(:, :)
      real(real64) :: t(last_row)
      integer :: level, row, pass, passes, threads

      threads = 1
!$    threads = omp_get_max_threads()
      passes = merge(3, 41, quick)
      allocate (bench, times(passes, last_row))
      call prepare(bench)
      do level = 0, vector_level()
         do pass = 0, passes  ! The first warms the caches and is not counted.
            do row = 1, merge(last_row, last_of_level, level == vector_level())
               call measure(bench, row, level, times(max(pass, 1), row))
            end do
         end do
         do row = 1, merge(last_row, last_of_level, level == vector_level())
            t(row) = median(times(:, row))
         end do
         call print_places(unit, level, t)
      end do
      call print_single(unit, t)
      call compare_with_peers(unit, bench, passes)
      do level = 0, vector_level()
         call print_derivatives(unit, level, t(sine_row), passes)
      end do
      call print_threads(unit, threads, passes)
      write (unit, '(a,es22.15)') 'Sum of all values computed: ', bench%checksum
   end subroutine bench_motion

   subroutine prepare(bench)
      type(bench_type), intent(inout) :: bench
      type(error_type), allocatable :: error
      integer :: i

      call new_orbit_from_gaps(bench%direct, 1.0_real64, 9.81_real64, 1.3_real64, 0.1_real64, error)
      call new_orbit_from_gaps(bench%dual, 1.0_real64, 9.81_real64, 0.8_real64, 0.1_real64, error)
      call new_orbit_from_gaps(bench%upright, 1.0_real64, 9.81_real64, 1e-16_real64, 3e-17_real64, error)
      do i = 1, points
         ! Times over 100 periods in no order that a branch predictor could learn.
         bench%time(i) = 100*modulo(0.6180339887498949_real64*i, 1.0_real64)
         bench%a(i) = modulo(0.6180339887498949_real64*i, 1.0_real64)*6.28_real64
         bench%b(i) = 0.1_real64 + modulo(0.7548776662466927_real64*i, 1.0_real64)*6.28_real64
         bench%top(i) = 0.01_real64 + 1.9_real64*modulo(0.6180339887498949_real64*i, 1.0_real64)
         bench%bottom(i) = min(bench%top(i), 2 - bench%top(i))*modulo(0.7548776662466927_real64*i, 1.0_real64)
      end do
      bench%top_upright = 1e-20_real64*bench%top
      bench%bottom_upright = 1e-20_real64*bench%bottom
   end subroutine prepare

   !> Nanoseconds a call or a point.
   subroutine measure(bench, row, level, time)
      type(bench_type), intent(inout) :: bench
      integer, intent(in) :: row, level
      real(real64), intent(out) :: time
      real(real64) :: total
      integer(int64) :: start
      integer :: count

      total = 0
      count = points
      call system_clock(start)
      if (row <= last_of_level .or. row >= period_many) then
         call run_arrays(bench, row, level, total)
      else if (row < set_up_direct .or. row > set_up_state) then
         count = calls
         call run_calls(bench, row, total)
      else
         count = calls/10
         call run_set_ups(row, count, total)
      end if
      time = nanoseconds_since(start)/count
      bench%checksum = bench%checksum + total + bench%out(1 + modulo(row, 7), 1)
   end subroutine measure

   !> All points by one call.
   subroutine run_arrays(bench, row, level, total)
      type(bench_type), intent(inout) :: bench
      integer, intent(in) :: row, level
      real(real64), intent(inout) :: total
      integer :: i

      associate (a => bench%a, b => bench%b, out => bench%out)
         select case (row)
         case (sine_row)
            do i = 1, points
               total = total + sin(a(i))
            end do
         case (floor_row)
            select case (level)
            case (0)
               call floor_baseline(a, b, out(:, 1), out(:, 2), out(:, 3))
            case (1)
               call floor_v3(a, b, out(:, 1), out(:, 2), out(:, 3))
            case default
               call floor_v4(a, b, out(:, 1), out(:, 2), out(:, 3))
            end select
         case (direct_row)
            call bench%direct%locate(bench%time, out(:, 1), out(:, 2), out(:, 3), highest_level=level)
         case (dual_row)
            call bench%dual%locate(bench%time, out(:, 1), out(:, 2), out(:, 3), highest_level=level)
         case (direct_rates_row)
            call bench%direct%locate(bench%time, out(:, 1), out(:, 2), out(:, 3), out(:, 4), out(:, 5), out(:, 6), &
               highest_level=level)
         case (dual_rates_row)
            call bench%dual%locate(bench%time, out(:, 1), out(:, 2), out(:, 3), out(:, 4), out(:, 5), out(:, 6), &
               highest_level=level)
         case (direct_azimuth_row)
            call bench%direct%azimuths(bench%time, out(:, 1), highest_level=level)
         case (dual_azimuth_row)
            call bench%dual%azimuths(bench%time, out(:, 1), highest_level=level)
         case (period_many)
            call orbits_period_from_gaps(1.0_real64, 9.81_real64, bench%top, bench%bottom, out(:, 1), level)
         case (period_many_upright)
            call orbits_period_from_gaps(1.0_real64, 9.81_real64, bench%top_upright, bench%bottom_upright, out(:, 1), &
               level)
         case (both_many)
            call orbits_period_from_gaps(1.0_real64, 9.81_real64, bench%top, bench%bottom, out(:, 1), level)
            call orbits_advance_from_gaps(1.0_real64, bench%top, bench%bottom, out(:, 2), level)
         case (constants_many)
            call orbits_constants_from_gaps(1.0_real64, 9.81_real64, bench%top, bench%bottom, bench%constants, level)
         case default
            call orbits_locate_from_gaps(1.0_real64, 9.81_real64, bench%top, bench%bottom, 3.7_real64, bench%position, &
               highest_level=level)
         end select
      end associate
   end subroutine run_arrays

   !> A call for every time.
   subroutine run_calls(bench, row, total)
      type(bench_type), intent(in) :: bench
      integer, intent(in) :: row
      real(real64), intent(inout) :: total
      real(real64) :: place(3), velocity(3)
      integer :: i

      select case (row)
      case (one_direct)
         do i = 1, calls
            call bench%direct%locate(bench%time(i), place)
            total = total + place(1)
         end do
      case (one_dual)
         do i = 1, calls
            call bench%dual%locate(bench%time(i), place)
            total = total + place(1)
         end do
      case (one_upright)
         do i = 1, calls
            call bench%upright%locate(bench%time(i), place)
            total = total + place(1)
         end do
      case (one_rates)
         do i = 1, calls
            call bench%dual%locate(bench%time(i), place, velocity)
            total = total + velocity(1)
         end do
      case (one_azimuth)
         do i = 1, calls
            total = total + bench%dual%azimuth(bench%time(i))
         end do
      case (period_one)
         do i = 1, calls
            total = total + orbit_period_from_gaps(1.0_real64, 9.81_real64, bench%top(i), bench%bottom(i))
         end do
      case default
         do i = 1, calls
            total = total + orbit_period_from_gaps(1.0_real64, 9.81_real64, bench%top_upright(i), &
               bench%bottom_upright(i))
         end do
      end select
   end subroutine run_calls

   subroutine run_set_ups(row, count, total)
      integer, intent(in) :: row, count
      real(real64), intent(inout) :: total
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      real(real64) :: step
      integer :: i

      do i = 1, count
         step = 1e-6_real64*i
         select case (row)
         case (set_up_direct)
            call new_orbit_from_gaps(orbit, 1.0_real64, 9.81_real64, 1.3_real64, 0.1_real64 + step, error)
         case (set_up_dual)
            call new_orbit_from_gaps(orbit, 1.0_real64, 9.81_real64, 0.8_real64, 0.1_real64 + step, error)
         case (set_up_state)
            call new_orbit_from_state(orbit, 1.0_real64, 9.81_real64, [0.6_real64, 0.0_real64, -0.8_real64], &
               [0.4_real64, 0.9_real64 + step, 0.3_real64], error)
         case default
            call new_orbit_from_gaps(orbit, 1.0_real64, 9.81_real64, 1e-16_real64, 3e-17_real64 + 1e-16_real64*step, &
               error)
         end select
         total = total + orbit%period()
      end do
   end subroutine run_set_ups

   subroutine print_places(unit, level, t)
      integer, intent(in) :: unit, level
      real(real64), intent(in) :: t(:)
      character(len=9), parameter :: names(0:2) = [character(len=9) :: 'x86-64', 'x86-64-v3', 'x86-64-v4']

      if (level == 0) write (unit, '(a)') &
         'Positions at 10240 times of one orbit, double precision, one thread. S is a scalar sine, measured beside;', &
         'the floor is two sines, two cosines (vectorised, libmvec) and one division a point at the same vector '// &
         'width.', &
         '', 'kernel      k**2    what                             ns       S   floors'
      call print_row('        floor', floor_row)
      call print_row('< 1/2   position', direct_row)
      call print_row('> 1/2   position', dual_row)
      call print_row('< 1/2   position and velocity', direct_rates_row)
      call print_row('> 1/2   position and velocity', dual_rates_row)
      call print_row('< 1/2   azimuth, turns counted', direct_azimuth_row)
      call print_row('> 1/2   azimuth, turns counted', dual_azimuth_row)

   contains

      subroutine print_row(what, row)
         character(len=*), intent(in) :: what
         integer, intent(in) :: row
         character(len=35) :: padded

         padded = what
         write (unit, '(a10,2x,a,2f8.2,f9.2)') names(level), padded, t(row), t(row)/t(sine_row), t(row)/t(floor_row)
      end subroutine print_row
   end subroutine print_places

   subroutine print_single(unit, t)
      integer, intent(in) :: unit
      real(real64), intent(in) :: t(:)
      integer :: row
      character(len=44), parameter :: names(one_direct:last_row) = [character(len=44) :: &
         'one position, k**2 < 1/2', 'one position, k**2 > 1/2', 'one position, k''**2 = 1e-16', &
         'one position and velocity', 'one azimuth', &
         'set-up, two-part constants, k**2 < 1/2', 'set-up, two-part constants, k**2 > 1/2', 'set-up, k''**2 = 1e-16', &
         'set-up from a state', 'T alone', 'T alone, k''**2 = 1e-20', 'T of many orbits, each', &
         'T of many orbits, each, k''**2 = 1e-20', 'T and advance of many orbits, each', &
         'eight constants of many orbits, each', &
         'position of many orbits at one time, each']

      write (unit, '(/,a44,2a10)') 'single calls                                ', 'ns', 'S'
      write (unit, '(a44,f10.2,f10.2)') 'scalar sine                                 ', t(sine_row), 1.0
      do row = one_direct, last_row
         write (unit, '(a44,f10.2,f10.2)') names(row), t(row), t(row)/t(sine_row)
      end do
   end subroutine print_single

   !> Our whole cost, set-up included, beside what others need on the same orbits, and both errors.
   subroutine compare_with_peers(unit, bench, passes)
      integer, intent(in) :: unit, passes
      type(bench_type), intent(inout) :: bench
      integer, parameter :: scenario_points(2) = [10000, 1000]
      real(real64), dimension(10000) :: time, x, y, z
      real(real64) :: ours(passes), gsl(passes), sine(passes), error, gsl_error, period
      type(orbit_type) :: orbit
      type(rival_type) :: rival
      type(error_type), allocatable :: failure
      integer(int64) :: start
      integer :: k, n, pass, scenario
      logical :: has

      has = .false.
      write (unit, '(/,a,/,a,/,a,/)') &
         'Against others, set-up included; times of others over ours. GSL (sn, cn, dn and two integrals of the third', &
         'kind a point) runs here; dopri5 (Boost.Odeint, dense output) and the best closed form are quoted in S from', &
         'another machine. Errors are the worst distance from our real128 (GSL: of its own turning heights as printed).'
      write (unit, '(a10,2x,a24,2a8,2a10,2x,a22,a10)') 'orbit', 'motion                  ', 'ns', 'S', 'error', 'GSL', &
         '      quoted          ', 'its error'
      do k = 1, size(peers)
         do scenario = 1, 2
            n = scenario_points(scenario)
            call new_orbit_from_heights(orbit, 1.0_real64, 1.0_real64, peers(k)%upper, peers(k)%lower, failure)
            period = orbit%period()
            time(:n) = times_of(scenario, n)
            do pass = 1, passes
               call measure(bench, sine_row, 0, sine(pass))
               call system_clock(start)
               call new_orbit_from_heights(orbit, 1.0_real64, 1.0_real64, peers(k)%upper, peers(k)%lower, failure)
               call orbit%locate(time(:n), x(:n), y(:n), z(:n))
               ours(pass) = nanoseconds_since(start)/n
            end do
            error = worst_error(0.0_real64)
            gsl = 0
            do pass = 1, min(passes, 5)
               call system_clock(start)
               call gsl_motion(peers(k)%upper, peers(k)%lower, period, time(:n), x(:n), y(:n), z(:n), has)
               gsl(pass) = nanoseconds_since(start)/n
            end do
            gsl_error = -1
            if (has) gsl_error = worst_error(0.5_real64)
            rival = quoted(trim(peers(k)%name)//merge(', one period  ', ', 1000 periods', scenario == 1))
            if (rival%ns <= 0) rival = quoted(trim(peers(k)%name)//', 1000 periods', 'Fukushima')
            write (unit, '(a10,2x,a24,f8.2,f8.3,es10.1,a22,f7.1,1x,a11,es10.1)') peers(k)%name, &
               merge('one period, 10000 points', '1000 periods, 1000      ', scenario == 1), median(ours), &
               median(ours)/median(sine), error, gsl_text(median(gsl(:min(passes, 5)))/median(ours), gsl_error), &
               rival%ns/quoted_sine/(median(ours)/median(sine)), rival%library, rival%error
         end do
      end do

   contains

      !> Over one period, or one in each of many periods.
      function times_of(scenario, n) result(times)
         integer, intent(in) :: scenario, n
         real(real64) :: times(n)
         integer :: i

         if (scenario == 1) then
            times = [(period*i/n, i=1, n)]
         else
            times = [(period*(i - 1 + modulo(0.6180339887498949_real64*i, 1.0_real64)), i=1, n)]
         end if
      end function times_of

      !> Greatest distance of every 10th position from the real128 motion; GSL's start half a period later.
      real(real64) function worst_error(later)
         real(real64), intent(in) :: later
         type(orbit_type_real128) :: exact
         real(real128) :: place(3), turn(3), t
         integer :: j

         call new_orbit_from_heights(exact, 1.0_real128, 1.0_real128, real(peers(k)%upper, real128), &
            real(peers(k)%lower, real128), failure)
         worst_error = 0
         call exact%locate(later*exact%period(), turn)
         turn(:2) = turn(:2)/norm2(turn(:2))
         do j = 1, n, 10
            t = time(j) + later*exact%period()
            call exact%locate(t, place)
            if (later > 0) place(:2) = [place(1)*turn(1) + place(2)*turn(2), place(2)*turn(1) - place(1)*turn(2)]
            worst_error = max(worst_error, real(norm2(place - [x(j), y(j), z(j)]), real64))
         end do
      end function worst_error

      function gsl_text(ratio, distance) result(text)
         real(real64), intent(in) :: ratio, distance
         character(len=22) :: text

         text = '                     -'
         if (has) write (text, '(f10.1,a,es9.1,a)') ratio, ' (', distance, ')'
      end function gsl_text
   end subroutine compare_with_peers

   !> Long arrays on one thread and on all: the fastest passes, since other work on a core stops all threads.
   subroutine print_threads(unit, threads, passes)
      integer, intent(in) :: unit, threads, passes
      real(real64), allocatable :: time(:), x(:), y(:), z(:)
      real(real64) :: one(passes), all(passes)
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      integer(int64) :: start
      integer :: i, pass

      if (threads == 1) return
      allocate (time(many), x(many), y(many), z(many))
      do i = 1, many
         time(i) = 1e-3_real64*i
      end do
      call new_orbit_from_gaps(orbit, 1.0_real64, 9.81_real64, 0.8_real64, 0.1_real64, error)
      do pass = 1, passes
         call system_clock(start)
         call orbit%locate(time, x, y, z)
         one(pass) = nanoseconds_since(start)/many
         call system_clock(start)
         call orbit%locate(time, x, y, z, threads=0)
         all(pass) = nanoseconds_since(start)/many
      end do
      write (unit, '(/,a,i0,a,i0,a,f6.2,a,f6.2,a)') 'Positions at ', many, ' times on ', threads, &
         ' threads, fastest passes: ', minval(all), ' ns a point; on one: ', minval(one)/minval(all), ' times that'
   end subroutine print_threads

end module kyvadlo_bench_motion
