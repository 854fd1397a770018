!> The nome of elliptic functions in three kinds.
module kyvadlo_nome_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use kyvadlo_numbers_real32, only: quiet_nan
#include "nome.inc"
end module kyvadlo_nome_real32

module kyvadlo_nome_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_numbers_real64, only: quiet_nan
#include "nome.inc"
end module kyvadlo_nome_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_nome_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_numbers_real128, only: quiet_nan
#include "nome.inc"
end module kyvadlo_nome_real128
#endif

module kyvadlo_nome
   use kyvadlo_nome_real32, only: elliptic_nome, elliptic_nomec
   use kyvadlo_nome_real64, only: elliptic_nome, elliptic_nomec
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_nome_real128, only: elliptic_nome, elliptic_nomec
#endif
   implicit none
   private
   public :: elliptic_nome, elliptic_nomec
end module kyvadlo_nome
