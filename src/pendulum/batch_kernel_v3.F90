!> The batch kernel compiled for x86-64-v3.
module kyvadlo_batch_kernel_v3
#include "batch_kernel.inc"
end module kyvadlo_batch_kernel_v3
