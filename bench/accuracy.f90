!> `kyvadlo-bench --accuracy`: what an accuracy costs in time, and whether it is kept.
module kyvadlo_bench_accuracy
   use, intrinsic :: iso_fortran_env, only: int64, real64, real128
   use kyvadlo, error_type => kyvadlo_error_type
   use kyvadlo_batch_dispatch, only: vector_level
   use kyvadlo_stopwatch, only: median, nanoseconds_since
   implicit none
   private
   public :: bench_accuracy

   !> What is asked for; the row before them is an orbit without an accuracy.
   real(real64), parameter :: accuracies(7) = [1e-3_real64, 1e-6_real64, 1e-9_real64, 1e-12_real64, 1e-15_real64, &
      1e-29_real64, 1e-31_real64]
   !> Points of a pass, and of one in real128 or where errors are measured: every so many.
   integer, parameter :: points = 10240, wide_points = 128, checked_every = 80
   real(real64), parameter :: periods = 100

   type :: case_type
      type(orbit_type) :: orbit
      type(orbit_type_real128) :: exact
      type(accurate_orbit_type) :: plans(size(accuracies))
      real(real64) :: time(points), out(points, 3)
      real(real64) :: checksum = 0
   end type case_type

contains

   !> Measures and prints. One thread; medians over passes in which all rows are measured in turn.
   subroutine bench_accuracy(unit, quick)
      integer, intent(in) :: unit    !! Where to print
      logical, intent(in) :: quick   !! Few passes: to see that it runs, not to measure
      type(case_type), allocatable :: work
      integer :: passes

      passes = merge(3, 41, quick)
      allocate (work)
      write (unit, '(a,/,a,/)') &
         'Positions at 10240 times over 100 periods, one thread: nanoseconds a point, and how many times faster than', &
         'an orbit without an accuracy. Errors are the worst of 128 distances from our real128, in l.'
      call prepare(work, 1.3_real64, 0.1_real64)
      call print_places(unit, work, 'k**2 < 1/2', passes)
      call prepare(work, 0.8_real64, 0.1_real64)
      call print_places(unit, work, 'k**2 > 1/2', passes)
      call print_set_ups(unit, work, passes)
      write (unit, '(a,es22.15)') 'Sum of all values computed: ', work%checksum
   end subroutine bench_accuracy

   subroutine prepare(work, top, bottom)
      type(case_type), intent(inout) :: work
      real(real64), intent(in) :: top, bottom  !! l - z1, l + z2 [m]
      type(error_type), allocatable :: error
      integer :: i

      call new_orbit_from_gaps(work%orbit, 1.0_real64, 9.81_real64, top, bottom, error)
      call new_orbit_from_gaps(work%exact, 1.0_real128, real(9.81_real64, real128), real(top, real128), &
         real(bottom, real128), error)
      do i = 1, points
         work%time(i) = periods*work%orbit%period()*modulo(0.6180339887498949_real64*i, 1.0_real64)
      end do
      do i = 1, size(accuracies)
         call new_orbit_to_accuracy(work%plans(i), start_gaps, 1.0_real64, 9.81_real64, [top], [bottom], &
            accuracies(i), periods*work%orbit%period(), error)
      end do
   end subroutine prepare

   subroutine print_places(unit, work, name, passes)
      integer, intent(in) :: unit, passes
      type(case_type), intent(inout) :: work
      character(len=*), intent(in) :: name
      character(len=9), parameter :: levels(0:2) = [character(len=9) :: 'x86-64', 'x86-64-v3', 'x86-64-v4']
      real(real64) :: times(passes, 0:2, 0:size(accuracies)), found(0:2), full(0:2)
      integer :: level, row, pass, last

      last = vector_level()
      do pass = 0, passes  ! The first warms the caches and is not counted.
         do row = 0, size(accuracies)
            do level = 0, last
               call measure(work, row, level, times(max(pass, 1), level, row))
            end do
         end do
      end do
      write (unit, '(a10,2x,a33,a9,3(a11,a9))') 'accuracy', name//'                               ', 'error', &
         (levels(level), 'times', level=0, last)
      do row = 0, size(accuracies)
         do level = 0, last
            found(level) = median(times(:, level, row))
            if (row == 0) full(level) = found(level)
         end do
         write (unit, '(a,es9.1,3(f11.2,f9.4))') row_name(work, row), worst_error(work, row), &
            (found(level), full(level)/found(level), level=0, last)
      end do
      write (unit, '(a)') ''
   end subroutine print_places

   !> Accuracy and choice.
   function row_name(work, row) result(name)
      type(case_type), intent(in) :: work
      integer, intent(in) :: row
      character(len=45) :: name

      name = '      none  real64 vectors, all terms'
      if (row == 0) return
      write (name, '(es10.0,2x,a)') accuracies(row), trim(work%plans(row)%choice_text())
   end function row_name

   !> Nanoseconds a point. Real128 has no vectors and takes fewer points.
   subroutine measure(work, row, level, time)
      type(case_type), intent(inout) :: work
      integer, intent(in) :: row, level
      real(real64), intent(out) :: time
      integer(int64) :: start
      integer :: n

      n = points
      if (row > 0) n = merge(wide_points, n, allocated(work%plans(row)%wide))
      ! The vector units, asleep while real128 is computed, take half a millisecond to be as fast as they become.
      call system_clock(start)
      do while (nanoseconds_since(start) < 1e6_real64)
         call evaluate(min(n, 2048))
      end do
      call system_clock(start)
      call evaluate(n)
      time = nanoseconds_since(start)/n
      work%checksum = work%checksum + work%out(1 + modulo(row*level, n), 1)

   contains

      subroutine evaluate(n)
         integer, intent(in) :: n

         if (row == 0) then
            call work%orbit%locate(work%time(:n), work%out(:n, 1), work%out(:n, 2), work%out(:n, 3), &
               highest_level=level)
         else
            call work%plans(row)%locate(work%time(:n), work%out(:n, 1), work%out(:n, 2), work%out(:n, 3), &
               highest_level=level)
         end if
      end subroutine evaluate
   end subroutine measure

   !> Worst distance from the real128 motion, in l, of what comes out in real128 where the accuracy needs it.
   real(real64) function worst_error(work, row) result(worst)
      type(case_type), intent(in) :: work
      integer, intent(in) :: row
      real(real64) :: time(wide_points), rounded(wide_points, 3)
      real(real128) :: placed(wide_points, 3), place(3)
      integer :: i

      time = work%time(checked_every:points:checked_every)
      if (row == 0) then
         call work%orbit%locate(time, rounded(:, 1), rounded(:, 2), rounded(:, 3))
         placed = rounded
      else
         call work%plans(row)%locate(time, placed(:, 1), placed(:, 2), placed(:, 3))
      end if
      worst = 0
      do i = 1, wide_points
         call work%exact%locate(real(time(i), real128), place)
         worst = max(worst, real(norm2(place - placed(i, :)), real64))
      end do
   end function worst_error

   !> What the choice costs beside the set-up it is made for.
   subroutine print_set_ups(unit, work, passes)
      integer, intent(in) :: unit, passes
      type(case_type), intent(inout) :: work
      real(real64) :: times(passes, 0:size(accuracies)), full
      integer :: pass, row

      do pass = 0, passes
         do row = 0, size(accuracies)
            call measure_set_up(work, row, times(max(pass, 1), row))
         end do
      end do
      full = median(times(:, 0))
      write (unit, '(a10,2x,a33,2a11)') 'accuracy', 'set-up, k**2 > 1/2               ', 'ns', 'times'
      do row = 0, size(accuracies)
         write (unit, '(a,f11.1,f11.3)') row_name(work, row), median(times(:, row)), full/median(times(:, row))
      end do
      write (unit, '(a)') ''
   end subroutine print_set_ups

   !> Nanoseconds a set-up.
   subroutine measure_set_up(work, row, time)
      type(case_type), intent(inout) :: work
      integer, intent(in) :: row
      real(real64), intent(out) :: time
      type(orbit_type) :: orbit
      type(accurate_orbit_type) :: plan
      type(error_type), allocatable :: error
      integer(int64) :: start
      integer :: i, n

      n = 100
      if (row > 0) n = merge(4, n, allocated(work%plans(row)%wide))
      call system_clock(start)
      do i = 1, n
         if (row == 0) then
            call new_orbit_from_gaps(orbit, 1.0_real64, 9.81_real64, 0.8_real64 + 1e-6_real64*i, 0.1_real64, error)
            work%checksum = work%checksum + orbit%period()
         else
            call new_orbit_to_accuracy(plan, start_gaps, 1.0_real64, 9.81_real64, [0.8_real64 + 1e-6_real64*i], &
               [0.1_real64], accuracies(row), 1e3_real64, error)
            work%checksum = work%checksum + plan%period()
         end if
      end do
      time = nanoseconds_since(start)/n
   end subroutine measure_set_up
end module kyvadlo_bench_accuracy
