!> The numbers of a group of a namelist file, in three kinds: every number is read in its kind.
module kyvadlo_group_numbers_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
#include "group_numbers.inc"
end module kyvadlo_group_numbers_real32

module kyvadlo_group_numbers_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
#include "group_numbers.inc"
end module kyvadlo_group_numbers_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_group_numbers_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
#include "group_numbers.inc"
end module kyvadlo_group_numbers_real128
#endif

module kyvadlo_group_numbers
   use kyvadlo_group_numbers_real32
   use kyvadlo_group_numbers_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_group_numbers_real128
#endif
   implicit none
   public
end module kyvadlo_group_numbers
