!> Wall-clock time in nanoseconds, and what is said about several measurements of it.
module kyvadlo_stopwatch
   use, intrinsic :: iso_fortran_env, only: int64, real64
   implicit none
   private
   public :: nanoseconds_since, median, quantile

contains

   !> Nanoseconds since `system_clock` gave `start`.
   real(real64) function nanoseconds_since(start)
      integer(int64), intent(in) :: start  !! Count of system_clock with an int64 argument
      integer(int64) :: now, rate

      call system_clock(now, rate)
      nanoseconds_since = 1e9_real64*real(now - start, real64)/real(rate, real64)
   end function nanoseconds_since

   !> The middle value, of two middle ones the smaller. `huge` for no value.
   pure real(real64) function median(values)
      real(real64), intent(in) :: values(:)

      median = quantile(values, 0.5_real64)
   end function median

   !> The smallest value that is at least as great as this share of all. `huge` for no value.
   pure real(real64) function quantile(values, share)
      real(real64), intent(in) :: values(:)
      real(real64), intent(in) :: share      !! 0: the least, 1: the greatest
      real(real64) :: sorted(size(values)), moved
      integer :: i, j

      quantile = huge(quantile)
      if (size(values) == 0) return
      sorted = values
      do i = 2, size(sorted)
         moved = sorted(i)
         do j = i - 1, 1, -1
            if (sorted(j) <= moved) exit
            sorted(j + 1) = sorted(j)
         end do
         sorted(j + 1) = moved
      end do
      quantile = sorted(min(max(ceiling(share*size(sorted)), 1), size(sorted)))
   end function quantile

end module kyvadlo_stopwatch
