!> Reproducible random numbers, the same on every compiler: L'Ecuyer's combination of two congruential generators (Comm. ACM 31
!> (1988) 742), period 2e18.
module random_numbers
   use, intrinsic :: iso_fortran_env, only: int64, real64
   implicit none
   private
   public :: stream_type, new_stream, uniform, decades

   type :: stream_type
      private
      integer(int64) :: first = 12345, second = 67890
   end type stream_type

contains

   pure type(stream_type) function new_stream(seed) result(stream)
      integer, intent(in) :: seed  !! From 1 on; every seed another stream

      stream%first = 12345 + 7919_int64*seed
      stream%second = 67890 + 104729_int64*seed
   end function new_stream

   !> Between a and b.
   real(real64) function uniform(stream, a, b)
      type(stream_type), intent(inout) :: stream
      real(real64), intent(in) :: a, b
      integer(int64) :: difference
      integer, parameter :: draws = 2  ! 2**31 values each: two fill the 53 digits
      integer :: i

      uniform = 0
      do i = 1, draws
         stream%first = mod(40014*stream%first, 2147483563_int64)
         stream%second = mod(40692*stream%second, 2147483399_int64)
         difference = modulo(stream%first - stream%second, 2147483562_int64)
         uniform = (uniform + real(difference, real64))/2147483562
      end do
      uniform = a + (b - a)*uniform
   end function uniform

   !> 10**x with x between a and b.
   real(real64) function decades(stream, a, b)
      type(stream_type), intent(inout) :: stream
      real(real64), intent(in) :: a, b

      decades = 10**uniform(stream, a, b)
   end function decades

end module random_numbers
