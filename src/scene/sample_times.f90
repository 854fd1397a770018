!> The times of the samples of a scene.
module kyvadlo_sample_times
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_decimal_grid, only: grid_point, grid_type, new_grid
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_number_text, only: read_number
   implicit none
   private
   public :: set_times, last_before, rounded_off

contains

   !> Equidistant times from 0 to a duration: i times the duration over the number of intervals, rounded once, so that
   !> 0.3 s is written as that. The duration is the decimal that was typed, if one was, of which `rest` is what its
   !> rounding took off.
   !>
   !> The interval is split into a head, which i multiplies exactly, and the rest: no division for each sample.
   !> (Vectorised: every operation is rounded correctly, in whatever order.) Where that leaves open to which side a time
   !> is rounded, some of 1e8 samples in 1e8, whole numbers decide.
   subroutine set_times(samples, duration, duration_rest, typed, first, times)
      integer(int64), intent(in) :: samples           !! Of the scene, both ends included
      real(wp), intent(in) :: duration, duration_rest !! Their sum [s]
      character(len=*), intent(in) :: typed           !! The duration as it was typed; blank: it was not
      integer(int64), intent(in) :: first             !! Number of the first of these samples, counted from 0
      real(wp), intent(out), contiguous :: times(:)   !! [s]
      real(wp) :: before, intervals, interval, head, rest, part, doubt(size(times))
      character(len=:), allocatable :: ignored
      type(grid_type) :: grid
      integer :: bits, i

      before = real(first, wp)
      intervals = real(samples - 1, wp)
      interval = duration/intervals
      bits = digits(head) - exponent(intervals)
      head = scale(aint(scale(fraction(interval), bits)), exponent(interval) - bits)
      rest = ((duration - head*intervals) + duration_rest)/intervals
      do i = 1, size(times)
         part = (before + (i - 1))*rest
         times(i) = (before + (i - 1))*head + part
         doubt(i) = ((before + (i - 1))*head + part*(1 + 8*epsilon(part))) &
            - ((before + (i - 1))*head + part*(1 - 8*epsilon(part)))
      end do
      if (first + size(times) == samples) times(size(times)) = duration
      if (typed == '' .or. all(abs(doubt) <= 0)) return
      call new_grid(grid, '0', typed, samples - 1)
      do i = 1, size(times)
         if (abs(doubt(i)) > 0) call read_number(trim(grid_point(grid, first + i - 1)), times(i), ignored)
      end do
   end subroutine set_times

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
