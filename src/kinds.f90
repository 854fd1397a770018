!> The three real kinds of kyvadlo.
!>
!> Every algorithm is written once, in a template `<name>.inc` whose reals are `real(wp)`; `<name>.F90` includes it in
!> three modules, each with its own `wp`, and merges their generic names in one module without suffix.
module kyvadlo_kinds
   use, intrinsic :: iso_fortran_env, only: real32, real64, real128
   implicit none
   private
   public :: real32, real64, real128
end module kyvadlo_kinds
