!> The closed form of the place for one time, the same source as the batch kernels.
module kyvadlo_batch_kernel_single
#define single_point
#include "batch_kernel.inc"
end module kyvadlo_batch_kernel_single
