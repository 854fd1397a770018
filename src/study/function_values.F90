module kyvadlo_function_values_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use kyvadlo_carlson_rc_real32, only: carlson_rc
   use kyvadlo_carlson_rd_real32, only: carlson_rd, carlson_rg
   use kyvadlo_carlson_rf_real32, only: carlson_rf
   use kyvadlo_carlson_rj_real32, only: carlson_rj
   use kyvadlo_complete_real32, only: elliptic_k, elliptic_kc, elliptic_e, elliptic_d, elliptic_b
   use kyvadlo_complete_pi_real32, only: elliptic_pi
   use kyvadlo_heuman_real32, only: heuman_lambda
   use kyvadlo_incomplete_real32, only: elliptic_f, elliptic_einc, elliptic_dinc
   use kyvadlo_incomplete_pi_real32, only: elliptic_piinc
   use kyvadlo_jacobi_real32, only: jacobi_evaluate, jacobi_functions, jacobi_functionsc, jacobi_type, new_jacobi
   use kyvadlo_nome_real32, only: elliptic_nome
   use kyvadlo_theta_real32, only: theta_function
   use kyvadlo_zeta_real32, only: jacobi_zeta
   use kyvadlo_function_ids
#include "function_values.inc"
end module kyvadlo_function_values_real32

module kyvadlo_function_values_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_carlson_rc_real64, only: carlson_rc
   use kyvadlo_carlson_rd_real64, only: carlson_rd, carlson_rg
   use kyvadlo_carlson_rf_real64, only: carlson_rf
   use kyvadlo_carlson_rj_real64, only: carlson_rj
   use kyvadlo_complete_real64, only: elliptic_k, elliptic_kc, elliptic_e, elliptic_d, elliptic_b
   use kyvadlo_complete_pi_real64, only: elliptic_pi
   use kyvadlo_heuman_real64, only: heuman_lambda
   use kyvadlo_incomplete_real64, only: elliptic_f, elliptic_einc, elliptic_dinc
   use kyvadlo_incomplete_pi_real64, only: elliptic_piinc
   use kyvadlo_jacobi_real64, only: jacobi_evaluate, jacobi_functions, jacobi_functionsc, jacobi_type, new_jacobi
   use kyvadlo_nome_real64, only: elliptic_nome
   use kyvadlo_theta_real64, only: theta_function
   use kyvadlo_zeta_real64, only: jacobi_zeta
   use kyvadlo_function_ids
#include "function_values.inc"
end module kyvadlo_function_values_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_function_values_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_carlson_rc_real128, only: carlson_rc
   use kyvadlo_carlson_rd_real128, only: carlson_rd, carlson_rg
   use kyvadlo_carlson_rf_real128, only: carlson_rf
   use kyvadlo_carlson_rj_real128, only: carlson_rj
   use kyvadlo_complete_real128, only: elliptic_k, elliptic_kc, elliptic_e, elliptic_d, elliptic_b
   use kyvadlo_complete_pi_real128, only: elliptic_pi
   use kyvadlo_heuman_real128, only: heuman_lambda
   use kyvadlo_incomplete_real128, only: elliptic_f, elliptic_einc, elliptic_dinc
   use kyvadlo_incomplete_pi_real128, only: elliptic_piinc
   use kyvadlo_jacobi_real128, only: jacobi_evaluate, jacobi_functions, jacobi_functionsc, jacobi_type, new_jacobi
   use kyvadlo_nome_real128, only: elliptic_nome
   use kyvadlo_theta_real128, only: theta_function
   use kyvadlo_zeta_real128, only: jacobi_zeta
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
