!> The times of the samples of a scene.
module kyvadlo_sample_times
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_decimal_grid, only: grid_point, grid_type, new_grid, read_whole
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_number_text, only: read_number
   implicit none
   private
   public :: set_times, samples_at_rate, last_before, rounded_off

contains

   !> Equidistant times from 0 to a duration: i times the duration over the number of intervals, rounded once, so that
   !> 0.3 s is written as that. The duration is the decimal that was typed, if one was, of which `rest` is what its
   !> rounding took off. Or i over a rate.
   !>
   !> The interval is split into a head, which i multiplies exactly, and the rest: no division for each sample.
   !> (Vectorised: every operation is rounded correctly, in whatever order.) Where that leaves open to which side a time
   !> is rounded, some of 1e8 samples in 1e8, whole numbers decide.
   subroutine set_times(samples, duration, duration_rest, typed, rate, first, times)
      integer(int64), intent(in) :: samples           !! Of the scene, both ends included
      real(wp), intent(in) :: duration, duration_rest !! Their sum [s]
      character(len=*), intent(in) :: typed           !! The duration as it was typed; blank: it was not
      character(len=*), intent(in) :: rate            !! Samples a second, as typed, in place of the duration; or blank
      integer(int64), intent(in) :: first             !! Number of the first of these samples, counted from 0
      real(wp), intent(out), contiguous :: times(:)   !! [s]
      real(wp) :: span, before, intervals, interval, head, rest, part, doubt(size(times))
      character(len=:), allocatable :: ignored, span_typed
      integer(int64) :: parts
      type(grid_type) :: grid
      integer :: bits, i

      call divide(samples, duration, typed, rate, span, span_typed, parts)
      before = real(first, wp)
      intervals = real(parts, wp)
      interval = span/intervals
      bits = digits(head) - exponent(max(intervals, real(samples, wp)))
      head = scale(aint(scale(fraction(interval), bits)), exponent(interval) - bits)
      rest = ((span - head*intervals) + merge(duration_rest, 0.0_wp, rate == ''))/intervals
      do i = 1, size(times)
         part = (before + (i - 1))*rest
         times(i) = (before + (i - 1))*head + part
         doubt(i) = ((before + (i - 1))*head + part*(1 + 8*epsilon(part))) &
            - ((before + (i - 1))*head + part*(1 - 8*epsilon(part)))
      end do
      if (first + size(times) == samples .and. rate == '') times(size(times)) = duration
      if (span_typed == '' .or. all(abs(doubt) <= 0)) return
      call new_grid(grid, '0', span_typed, parts)
      do i = 1, size(times)
         if (abs(doubt(i)) > 0) call read_number(trim(grid_point(grid, first + i - 1)), times(i), ignored)
      end do
   end subroutine set_times

   !> What the times divide into how many parts: the duration, or as many seconds as make the rate a whole number.
   pure subroutine divide(samples, duration, typed, rate, span, span_typed, parts)
      integer(int64), intent(in) :: samples
      real(wp), intent(in) :: duration
      character(len=*), intent(in) :: typed, rate   !! As in `set_times`
      real(wp), intent(out) :: span                 !! [s]
      character(len=:), allocatable, intent(out) :: span_typed
      integer(int64), intent(out) :: parts
      integer :: places

      if (rate == '') then
         span = duration
         span_typed = typed
         parts = samples - 1
      else
         call read_whole(rate, parts, places)
         span = 10.0_wp**places
         span_typed = '1'//repeat('0', places)
      end if
   end subroutine divide

   !> How many samples at a rate lie within a duration, that at 0 included: the times after rounding count.
   pure integer(int64) function samples_at_rate(rate, duration) result(samples)
      character(len=*), intent(in) :: rate          !! As typed, one that `read_whole` takes
      real(wp), intent(in) :: duration              !! [s], times the rate at most 4e15
      character(len=:), allocatable :: ignored
      integer(int64) :: parts
      integer :: places
      type(grid_type) :: grid
      real(wp) :: time

      call read_whole(rate, parts, places)
      call new_grid(grid, '0', '1'//repeat('0', places), parts)
      samples = max(0_int64, int(duration*(real(parts, wp)/10.0_wp**places), int64) - 1)
      do
         call read_number(trim(grid_point(grid, samples)), time, ignored)
         if (time > duration) exit
         samples = samples + 1
      end do
   end function samples_at_rate

   !> What rounding took off a number as it was typed: half of it is the middle between that and the value's opposite,
   !> all of whose figures fit into 767.
   pure real(wp) function rounded_off(typed, value) result(rest)
      character(len=*), intent(in) :: typed     !! Blank: nothing
      real(wp), intent(in) :: value
      character(len=:), allocatable :: ignored
      character(len=780) :: exact
      type(grid_type) :: grid

      rest = 0
      if (typed == '') return
      write (exact, '(es780.766e3)') -value
      call new_grid(grid, typed, trim(adjustl(exact)), 2_int64)
      call read_number(trim(grid_point(grid, 1_int64)), rest, ignored)
      rest = 2*rest
   end function rounded_off

   !> The last of ascending times, from a place on, that is earlier than a limit; one less than that place if none is.
   pure integer function last_before(times, first, limit) result(last)
      real(wp), intent(in) :: times(:), limit         !! [s]
      integer, intent(in) :: first

      last = first - 1
      do while (last < size(times))
         if (.not. times(last + 1) < limit) exit
         last = last + 1
      end do
   end function last_before

end module kyvadlo_sample_times
