!> The batch kernels compiled for x86-64-v3.
#define kernel_grade 0
module kyvadlo_batch_kernel_v3
   use kyvadlo_batch_constants
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_start_kinds, only: start_heights, start_rises
#include "batch_kernel.inc"
end module kyvadlo_batch_kernel_v3
#undef kernel_grade

#define kernel_grade 1
module kyvadlo_batch_kernel_v3_single
   use kyvadlo_batch_constants
#include "batch_kernel.inc"
end module kyvadlo_batch_kernel_v3_single
#undef kernel_grade

#define kernel_grade 2
module kyvadlo_batch_kernel_v3_short
   use kyvadlo_batch_constants
#include "batch_kernel.inc"
end module kyvadlo_batch_kernel_v3_short
#undef kernel_grade
