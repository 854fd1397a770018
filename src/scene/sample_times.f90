!> The times of the samples of a scene.
module kyvadlo_sample_times
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_kinds, only: wp => real64
   implicit none
   private
   public :: set_times, last_before

contains

   !> Equidistant times from 0 to a duration: i times the duration over the number of intervals, rounded once, so that 0.3 s is
   !> written as that (up to 1e8 samples; but for what comes within 1e-7 ulp of a tie, and intervals below 1e-300 s). The interval is
   !> split into a head, which i multiplies exactly, and the rest: no division for each sample. (Vectorised: every operation is
   !> rounded correctly, in whatever order.)
   pure subroutine set_times(samples, duration, first, times)
      integer(int64), intent(in) :: samples           !! Of the scene, both ends included
      real(wp), intent(in) :: duration                !! [s]
      integer(int64), intent(in) :: first             !! Number of the first of these samples, counted from 0
      real(wp), intent(out), contiguous :: times(:)   !! [s]
      real(wp) :: before, intervals, interval, head, rest
      integer :: bits, i

      before = real(first, wp)
      intervals = real(samples - 1, wp)
      interval = duration/intervals
      bits = digits(head) - exponent(intervals)
      head = scale(aint(scale(fraction(interval), bits)), exponent(interval) - bits)
      rest = (duration - head*intervals)/intervals
      do i = 1, size(times)
         times(i) = (before + (i - 1))*head + (before + (i - 1))*rest
      end do
      if (first + size(times) == samples) times(size(times)) = duration
   end subroutine set_times

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
