!> Numbers for the elliptic functions that are measured beside those of other libraries.
module kyvadlo_function_ids
   implicit none
   public

   integer, parameter :: id_rc = 1, id_rf = 2, id_rd = 3, id_rj = 4, id_rg = 5, id_k = 6, id_kc = 7, &
      id_e = 8, id_d = 9, id_b = 10, id_nome = 11, id_pi = 12, id_f = 13, id_einc = 14, id_dinc = 15, id_piinc = 16, &
      id_zeta = 17, id_lambda = 18, id_jacobi = 19, id_jacobi_am = 20, id_jacobic = 21, id_set_up = 22, id_theta = 23

   !> Arguments in a row of `id_set_up`, and parameters among them, each used for as many arguments as the others.
   integer, parameter :: points = 2000, set_ups = 20
end module kyvadlo_function_ids
