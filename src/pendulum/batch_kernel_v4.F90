!> The batch kernel compiled for x86-64-v4.
module kyvadlo_batch_kernel_v4
   use kyvadlo_batch_constants, only:  ! for fpm, which does not look into what is included
#include "batch_kernel.inc"
end module kyvadlo_batch_kernel_v4
