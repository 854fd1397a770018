!> Places of one orbit at many times by the double-double kernels, as real64 or real128.
module kyvadlo_double_double_batch
   use, intrinsic :: iso_fortran_env, only: real64, int64
#ifndef KYVADLO_NO_REAL128
   use, intrinsic :: iso_fortran_env, only: real128
#endif
   use kyvadlo_batch_dispatch, only: vector_level
   use kyvadlo_double_double_constants
   use kyvadlo_double_double_dispatch
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_threads, only: thread_count
   implicit none
   private
   public :: locate_double_double, double_double_limit

   interface locate_double_double
      module procedure locate_real64
#ifndef KYVADLO_NO_REAL128
      module procedure locate_real128
#endif
   end interface locate_double_double

contains

   !> The largest |t| the kernels take.
   pure real(real64) function double_double_limit(b) result(limit)
      type(wide_batch_type), intent(in) :: b

      limit = (wide_most_halves - 1)*b%half(1) - abs(b%time%high)
   end function double_double_limit

#define number real(real64)
#define locate_name locate_real64
#define whole_number(high, low) high + low
#include "double_double_batch.inc"
#undef number
#undef locate_name
#undef whole_number
#ifndef KYVADLO_NO_REAL128
#define number real(real128)
#define locate_name locate_real128
#define whole_number(high, low) real(high, real128) + low
#include "double_double_batch.inc"
#endif

   !> |t| <= limit, of a NaN false: numbers without a sign are in the order of their bits, and the comparison of bits
   !> never raises.
   elemental logical function is_within(t, limit)
      real(real64), intent(in) :: t, limit

      is_within = transfer(abs(t), 0_int64) <= transfer(limit, 0_int64)
   end function is_within
end module kyvadlo_double_double_batch
