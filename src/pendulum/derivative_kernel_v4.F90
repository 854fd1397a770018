!> The kernels of the derivatives compiled for x86-64-v4.
#define kernel_grade 0
#define without_periods
module kyvadlo_derivative_kernel_v4
   use kyvadlo_batch_constants, only: batch_type, start_type
   use kyvadlo_derivative_constants
#include "derivative_kernel.inc"
end module kyvadlo_derivative_kernel_v4
#undef kernel_grade
#undef without_periods
