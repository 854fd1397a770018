!> Places and velocities at many times of one orbit.
!>
!> `batch.inc` holds the public procedures, `batch_set_up.inc` the constants of the kernels, `batch_loop.inc` the kernels.
module kyvadlo_batch_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, real64, int64
   use kyvadlo_orbit_real32
   use kyvadlo_motion_real32
#define orbit_type orbit_type_real32
#include "batch.inc"
#include "batch_set_up.inc"
#undef orbit_type
end module kyvadlo_batch_real32

module kyvadlo_batch_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, real64, int64
   use kyvadlo_orbit_real64
   use kyvadlo_motion_real64
#define kernel_takes_arguments
#include "batch.inc"
#include "batch_set_up.inc"
#undef kernel_takes_arguments
end module kyvadlo_batch_real64

!> The kernels are real64: in real128 the scalar form serves, in the same blocks and threads.
module kyvadlo_batch_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, real64, int64
   use kyvadlo_orbit_real128
   use kyvadlo_motion_real128
#define orbit_type orbit_type_real128
#include "batch.inc"

   pure subroutine set_up_batch(orbit, b)
      type(orbit_type), intent(in) :: orbit
      type(batch_type), intent(out) :: b

      if (orbit%motion /= motion_none) b%form = form_scalar
   end subroutine set_up_batch
#undef orbit_type
end module kyvadlo_batch_real128

module kyvadlo_batch
   use kyvadlo_batch_real32
   use kyvadlo_batch_real64
   use kyvadlo_batch_real128
   implicit none
   public
end module kyvadlo_batch
