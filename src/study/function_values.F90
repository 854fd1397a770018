module kyvadlo_function_values_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use kyvadlo, only: carlson_rc, carlson_rf, carlson_rd, carlson_rj, carlson_rg, elliptic_k, elliptic_kc, elliptic_e, &
      elliptic_d, elliptic_b, elliptic_pi, elliptic_f, elliptic_einc, elliptic_dinc, elliptic_piinc, elliptic_nome, &
      jacobi_zeta, heuman_lambda, jacobi_functions, jacobi_functionsc, jacobi_type => jacobi_type_real32, new_jacobi, &
      jacobi_evaluate, theta_function
   use kyvadlo_function_ids
#include "function_values.inc"
end module kyvadlo_function_values_real32

module kyvadlo_function_values_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo, only: carlson_rc, carlson_rf, carlson_rd, carlson_rj, carlson_rg, elliptic_k, elliptic_kc, elliptic_e, &
      elliptic_d, elliptic_b, elliptic_pi, elliptic_f, elliptic_einc, elliptic_dinc, elliptic_piinc, elliptic_nome, &
      jacobi_zeta, heuman_lambda, jacobi_functions, jacobi_functionsc, jacobi_type, new_jacobi, &
      jacobi_evaluate, theta_function
   use kyvadlo_function_ids
#include "function_values.inc"
end module kyvadlo_function_values_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_function_values_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo, only: carlson_rc, carlson_rf, carlson_rd, carlson_rj, carlson_rg, elliptic_k, elliptic_kc, elliptic_e, &
      elliptic_d, elliptic_b, elliptic_pi, elliptic_f, elliptic_einc, elliptic_dinc, elliptic_piinc, elliptic_nome, &
      jacobi_zeta, heuman_lambda, jacobi_functions, jacobi_functionsc, jacobi_type => jacobi_type_real128, new_jacobi, &
      jacobi_evaluate, theta_function
   use kyvadlo_function_ids
#include "function_values.inc"
end module kyvadlo_function_values_real128
#endif

!> The elliptic functions by their numbers, for `kyvadlo bench` and `kyvadlo study`, in three kinds.
module kyvadlo_function_values
   use kyvadlo_function_values_real32
   use kyvadlo_function_values_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_function_values_real128
#endif
   implicit none
   public
end module kyvadlo_function_values
