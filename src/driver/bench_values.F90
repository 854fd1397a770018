module kyvadlo_bench_values_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo, only: carlson_rc, carlson_rf, carlson_rd, carlson_rj, carlson_rg, elliptic_k, elliptic_kc, elliptic_e, &
      elliptic_d, elliptic_b, elliptic_pi, elliptic_f, elliptic_einc, elliptic_dinc, elliptic_piinc, elliptic_nome, &
      jacobi_zeta, heuman_lambda, jacobi_functions, jacobi_functionsc, jacobi_type, new_jacobi, &
      evaluate_jacobi, theta_function
   use kyvadlo_bench_rows
#include "bench_values.inc"
end module kyvadlo_bench_values_real64

module kyvadlo_bench_values_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo, only: carlson_rc, carlson_rf, carlson_rd, carlson_rj, carlson_rg, elliptic_k, elliptic_kc, elliptic_e, &
      elliptic_d, elliptic_b, elliptic_pi, elliptic_f, elliptic_einc, elliptic_dinc, elliptic_piinc, elliptic_nome, &
      jacobi_zeta, heuman_lambda, jacobi_functions, jacobi_functionsc, jacobi_type => jacobi_type_real128, new_jacobi, &
      evaluate_jacobi, theta_function
   use kyvadlo_bench_rows
#include "bench_values.inc"
end module kyvadlo_bench_values_real128

!> Our side of `kyvadlo bench --functions`: every row of its table, in double precision and, for the errors, in quad.
module kyvadlo_bench_values
   use kyvadlo_bench_values_real64
   use kyvadlo_bench_values_real128
   implicit none
   public
end module kyvadlo_bench_values
