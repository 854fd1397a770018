!> Wall-clock time in nanoseconds, and what is said about several measurements of it.
module kyvadlo_stopwatch
   use, intrinsic :: iso_fortran_env, only: int64, real64
   use kyvadlo_quantiles, only: median, quantile
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

end module kyvadlo_stopwatch
