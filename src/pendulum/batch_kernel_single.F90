!> The closed form of the place for one time, the same source as the batch kernels.
module kyvadlo_batch_kernel_single
   use kyvadlo_batch_constants
   use kyvadlo_numbers_real64, only: quiet_nan
#define single_point
#define kernel_grade 0
#include "batch_kernel.inc"
end module kyvadlo_batch_kernel_single
