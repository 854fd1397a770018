!> The reductions of many values compiled for every processor.
module kyvadlo_reduction_kernel_baseline
   use, intrinsic :: iso_fortran_env, only: real64
#include "reduction_kernel.inc"
end module kyvadlo_reduction_kernel_baseline
