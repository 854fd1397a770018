!> Positions and velocities at many times of one orbit.
!>
!> `batch.inc` holds the public procedures, `batch_block.inc` what happens to a block, `batch_loop.inc` the kernels.
module kyvadlo_batch_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, real64, int64
   use kyvadlo_orbit_real32
   use kyvadlo_motion_real32
   use kyvadlo_numbers_real32, only: quiet_nan
   use kyvadlo_batch_constants
   use kyvadlo_batch_dispatch
   use kyvadlo_threads, only: thread_count
   use kyvadlo_motion_kinds
   use kyvadlo_pairs_real64
#include "batch.inc"
#include "batch_block.inc"
end module kyvadlo_batch_real32

module kyvadlo_batch_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, real64, int64
   use kyvadlo_orbit_real64
   use kyvadlo_motion_real64
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_batch_constants
   use kyvadlo_batch_dispatch
   use kyvadlo_threads, only: thread_count
   use kyvadlo_motion_kinds
   use kyvadlo_pairs_real64
#define kernel_takes_arguments
#include "batch.inc"
#include "batch_block.inc"
#undef kernel_takes_arguments
end module kyvadlo_batch_real64

#ifndef KYVADLO_NO_REAL128
!> The kernels are real64: in real128 the scalar form serves, in the same blocks and threads.
module kyvadlo_batch_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, real64, int64
   use kyvadlo_orbit_real128
   use kyvadlo_motion_real128
   use kyvadlo_numbers_real128, only: quiet_nan
   use kyvadlo_batch_constants
   use kyvadlo_batch_dispatch
   use kyvadlo_threads, only: thread_count
   use kyvadlo_motion_kinds
   use kyvadlo_pairs_real128
#include "batch.inc"
#include "batch_block_scalar.inc"
end module kyvadlo_batch_real128
#endif

module kyvadlo_batch
   use kyvadlo_batch_real32
   use kyvadlo_batch_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_batch_real128
#endif
   implicit none
   public
end module kyvadlo_batch
