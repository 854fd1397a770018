!> The batch kernel compiled for every processor of the architecture.
module kyvadlo_batch_kernel_baseline
   use kyvadlo_batch_constants, only:  ! for fpm, which does not look into what is included
#include "batch_kernel.inc"
end module kyvadlo_batch_kernel_baseline
