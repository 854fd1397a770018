!> The batch kernel compiled for x86-64-v4.
module kyvadlo_batch_kernel_v4
#include "batch_kernel.inc"
end module kyvadlo_batch_kernel_v4
