!> The batch kernel compiled for every processor of the architecture.
module kyvadlo_batch_kernel_baseline
#include "batch_kernel.inc"
end module kyvadlo_batch_kernel_baseline
