!> The reductions of many values compiled for x86-64-v3.
module kyvadlo_reduction_kernel_v3
   use, intrinsic :: iso_fortran_env, only: real64
#include "reduction_kernel.inc"
end module kyvadlo_reduction_kernel_v3
