!> Positions and velocities at many times of one orbit.
!>
!> `batch.inc` holds the public procedures, `batch_block.inc` what happens to a block, `batch_loop.inc` the kernels.
submodule (kyvadlo_orbit_real32) kyvadlo_batch_real32
   use kyvadlo_batch_dispatch
   use kyvadlo_threads, only: thread_count
#include "batch.inc"
#include "batch_block.inc"
end submodule kyvadlo_batch_real32

submodule (kyvadlo_orbit_real64) kyvadlo_batch_real64
   use kyvadlo_batch_dispatch
   use kyvadlo_threads, only: thread_count
#define kernel_takes_arguments
#include "batch.inc"
#include "batch_block.inc"
#undef kernel_takes_arguments
end submodule kyvadlo_batch_real64

#ifndef KYVADLO_NO_REAL128
!> The kernels are real64: in real128 the scalar form serves, in the same blocks and threads.
submodule (kyvadlo_orbit_real128) kyvadlo_batch_real128
   use kyvadlo_batch_dispatch
   use kyvadlo_threads, only: thread_count
#include "batch.inc"
#include "batch_block_scalar.inc"
end submodule kyvadlo_batch_real128
#endif
