!> The double-double kernels compiled for x86-64-v4.
module kyvadlo_double_double_kernel_v4
   use kyvadlo_batch_constants, only: form_direct_even, form_direct_odd
   use kyvadlo_double_double_constants
   use kyvadlo_double_doubles, only: pair_type
#include "double_double_kernel.inc"
end module kyvadlo_double_double_kernel_v4
