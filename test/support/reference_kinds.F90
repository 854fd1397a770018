!> The kind of references and of what is measured, and that of what is integrated in more digits: quadruple precision, or the
!> widest kind where there is none.
module reference_kinds
#ifdef KYVADLO_NO_REAL128
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   private
   public :: real128, integrated
   integer, parameter :: real128 = merge(selected_real_kind(18), real64, selected_real_kind(18) > 0)
#ifdef __flang__
   ! flang 19 mislays arrays of x87's kind in derived types.
   integer, parameter :: integrated = real64
#else
   integer, parameter :: integrated = real128
#endif
#else
   use, intrinsic :: iso_fortran_env, only: real128
   implicit none
   private
   public :: real128, integrated
   integer, parameter :: integrated = real128
#endif
end module reference_kinds
