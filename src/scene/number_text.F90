!> Numbers to text and back, in the three kinds: strict reading, the shortest form that reads back exactly, and a form
!> of given significant digits for tables.
module kyvadlo_number_text_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use kyvadlo_numbers_real32, only: is_finite
#include "number_text.inc"
end module kyvadlo_number_text_real32

module kyvadlo_number_text_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_numbers_real64, only: is_finite
   use kyvadlo_decimal, only: longest_decimal, put_shortest
#define has_fast_form
#include "number_text.inc"
#undef has_fast_form
end module kyvadlo_number_text_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_number_text_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_numbers_real128, only: is_finite
#include "number_text.inc"
end module kyvadlo_number_text_real128
#endif

module kyvadlo_number_text
   use kyvadlo_number_text_real32
   use kyvadlo_number_text_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_number_text_real128
#endif
   implicit none
   public
end module kyvadlo_number_text
