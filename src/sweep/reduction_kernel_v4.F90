!> The reductions of many values compiled for x86-64-v4.
module kyvadlo_reduction_kernel_v4
   use, intrinsic :: iso_fortran_env, only: real64
#include "reduction_kernel.inc"
end module kyvadlo_reduction_kernel_v4
