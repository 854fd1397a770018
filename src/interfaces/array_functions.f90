!> The elliptic functions of arrays, for C and for Python's ufuncs: as c_functions.f90, one value for each index.
!> Documented in kyvadlo.h.
module kyvadlo_array_functions
   use, intrinsic :: iso_c_binding, only: c_double, c_double_complex, c_int, c_size_t
   use kyvadlo
   implicit none
   public

contains

   pure subroutine kyvadlo_elliptic_k_many(count, m, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: m(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_k(m)
   end subroutine kyvadlo_elliptic_k_many

   pure subroutine kyvadlo_elliptic_kc_many(count, mc, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: mc(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_kc(mc)
   end subroutine kyvadlo_elliptic_kc_many

   pure subroutine kyvadlo_elliptic_e_many(count, m, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: m(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_e(m)
   end subroutine kyvadlo_elliptic_e_many

   pure subroutine kyvadlo_elliptic_ec_many(count, mc, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: mc(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_ec(mc)
   end subroutine kyvadlo_elliptic_ec_many

   pure subroutine kyvadlo_elliptic_d_many(count, m, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: m(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_d(m)
   end subroutine kyvadlo_elliptic_d_many

   pure subroutine kyvadlo_elliptic_dc_many(count, mc, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: mc(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_dc(mc)
   end subroutine kyvadlo_elliptic_dc_many

   pure subroutine kyvadlo_elliptic_b_many(count, m, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: m(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_b(m)
   end subroutine kyvadlo_elliptic_b_many

   pure subroutine kyvadlo_elliptic_bc_many(count, mc, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: mc(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_bc(mc)
   end subroutine kyvadlo_elliptic_bc_many

   pure subroutine kyvadlo_elliptic_nome_many(count, m, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: m(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_nome(m)
   end subroutine kyvadlo_elliptic_nome_many

   pure subroutine kyvadlo_elliptic_nomec_many(count, mc, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: mc(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_nomec(mc)
   end subroutine kyvadlo_elliptic_nomec_many

   pure subroutine kyvadlo_carlson_rc_many(count, x, y, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: x(count), y(count)
      real(c_double), intent(out) :: f(count)

      f = carlson_rc(x, y)
   end subroutine kyvadlo_carlson_rc_many

   pure subroutine kyvadlo_elliptic_pi_many(count, n, m, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: n(count), m(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_pi(n, m)
   end subroutine kyvadlo_elliptic_pi_many

   pure subroutine kyvadlo_elliptic_pic_many(count, n, mc, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: n(count), mc(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_pic(n, mc)
   end subroutine kyvadlo_elliptic_pic_many

   pure subroutine kyvadlo_elliptic_f_many(count, phi, m, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: phi(count), m(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_f(phi, m)
   end subroutine kyvadlo_elliptic_f_many

   pure subroutine kyvadlo_elliptic_fc_many(count, phi, mc, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: phi(count), mc(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_fc(phi, mc)
   end subroutine kyvadlo_elliptic_fc_many

   pure subroutine kyvadlo_elliptic_einc_many(count, phi, m, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: phi(count), m(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_einc(phi, m)
   end subroutine kyvadlo_elliptic_einc_many

   pure subroutine kyvadlo_elliptic_eincc_many(count, phi, mc, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: phi(count), mc(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_eincc(phi, mc)
   end subroutine kyvadlo_elliptic_eincc_many

   pure subroutine kyvadlo_elliptic_dinc_many(count, phi, m, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: phi(count), m(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_dinc(phi, m)
   end subroutine kyvadlo_elliptic_dinc_many

   pure subroutine kyvadlo_elliptic_dincc_many(count, phi, mc, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: phi(count), mc(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_dincc(phi, mc)
   end subroutine kyvadlo_elliptic_dincc_many

   pure subroutine kyvadlo_elliptic_binc_many(count, phi, m, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: phi(count), m(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_binc(phi, m)
   end subroutine kyvadlo_elliptic_binc_many

   pure subroutine kyvadlo_elliptic_bincc_many(count, phi, mc, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: phi(count), mc(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_bincc(phi, mc)
   end subroutine kyvadlo_elliptic_bincc_many

   pure subroutine kyvadlo_jacobi_zeta_many(count, u, m, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: u(count), m(count)
      real(c_double), intent(out) :: f(count)

      f = jacobi_zeta(u, m)
   end subroutine kyvadlo_jacobi_zeta_many

   pure subroutine kyvadlo_jacobi_zetac_many(count, u, mc, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: u(count), mc(count)
      real(c_double), intent(out) :: f(count)

      f = jacobi_zetac(u, mc)
   end subroutine kyvadlo_jacobi_zetac_many

   pure subroutine kyvadlo_heuman_lambda_many(count, phi, m, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: phi(count), m(count)
      real(c_double), intent(out) :: f(count)

      f = heuman_lambda(phi, m)
   end subroutine kyvadlo_heuman_lambda_many

   pure subroutine kyvadlo_heuman_lambdac_many(count, phi, mc, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: phi(count), mc(count)
      real(c_double), intent(out) :: f(count)

      f = heuman_lambdac(phi, mc)
   end subroutine kyvadlo_heuman_lambdac_many

   pure subroutine kyvadlo_carlson_rf_many(count, x, y, z, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: x(count), y(count), z(count)
      real(c_double), intent(out) :: f(count)

      f = carlson_rf(x, y, z)
   end subroutine kyvadlo_carlson_rf_many

   pure subroutine kyvadlo_carlson_rd_many(count, x, y, z, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: x(count), y(count), z(count)
      real(c_double), intent(out) :: f(count)

      f = carlson_rd(x, y, z)
   end subroutine kyvadlo_carlson_rd_many

   pure subroutine kyvadlo_carlson_rg_many(count, x, y, z, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: x(count), y(count), z(count)
      real(c_double), intent(out) :: f(count)

      f = carlson_rg(x, y, z)
   end subroutine kyvadlo_carlson_rg_many

   pure subroutine kyvadlo_elliptic_piinc_many(count, n, phi, m, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: n(count), phi(count), m(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_piinc(n, phi, m)
   end subroutine kyvadlo_elliptic_piinc_many

   pure subroutine kyvadlo_elliptic_piincc_many(count, n, phi, mc, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: n(count), phi(count), mc(count)
      real(c_double), intent(out) :: f(count)

      f = elliptic_piincc(n, phi, mc)
   end subroutine kyvadlo_elliptic_piincc_many

   pure subroutine kyvadlo_carlson_rj_many(count, x, y, z, p, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: x(count), y(count), z(count), p(count)
      real(c_double), intent(out) :: f(count)

      f = carlson_rj(x, y, z, p)
   end subroutine kyvadlo_carlson_rj_many

   pure subroutine kyvadlo_bulirsch_cel_many(count, kc, p, a, b, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: kc(count), p(count), a(count), b(count)
      real(c_double), intent(out) :: f(count)

      f = bulirsch_cel(kc, p, a, b)
   end subroutine kyvadlo_bulirsch_cel_many

   pure subroutine kyvadlo_bulirsch_el1_many(count, x, kc, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: x(count), kc(count)
      real(c_double), intent(out) :: f(count)

      f = bulirsch_el1(x, kc)
   end subroutine kyvadlo_bulirsch_el1_many

   pure subroutine kyvadlo_bulirsch_el2_many(count, x, kc, a, b, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: x(count), kc(count), a(count), b(count)
      real(c_double), intent(out) :: f(count)

      f = bulirsch_el2(x, kc, a, b)
   end subroutine kyvadlo_bulirsch_el2_many

   pure subroutine kyvadlo_bulirsch_el3_many(count, x, kc, p, f) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: x(count), kc(count), p(count)
      real(c_double), intent(out) :: f(count)

      f = bulirsch_el3(x, kc, p)
   end subroutine kyvadlo_bulirsch_el3_many

   pure subroutine kyvadlo_sncndn_many(count, u, m, sn, cn, dn, am) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: u(count), m(count)
      real(c_double), intent(out) :: sn(count), cn(count), dn(count), am(count)

      call jacobi_functions(u, m, sn, cn, dn, am)
   end subroutine kyvadlo_sncndn_many

   pure subroutine kyvadlo_sncndnc_many(count, u, mc, sn, cn, dn, am) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: u(count), mc(count)
      real(c_double), intent(out) :: sn(count), cn(count), dn(count), am(count)

      call jacobi_functionsc(u, mc, sn, cn, dn, am)
   end subroutine kyvadlo_sncndnc_many

   pure subroutine kyvadlo_theta_many(count, i, v, q, f) bind(c)
      integer(c_size_t), value :: count
      integer(c_int), intent(in) :: i(count)
      real(c_double), intent(in) :: v(count), q(count)
      real(c_double), intent(out) :: f(count)

      f = theta_function(i, v, q)
   end subroutine kyvadlo_theta_many

   !> Of a complex v: real and imaginary parts in arrays of their own.
   pure subroutine kyvadlo_complex_theta_many(count, i, v_re, v_im, q, f_re, f_im) bind(c)
      integer(c_size_t), value :: count
      integer(c_int), intent(in) :: i(count)
      real(c_double), intent(in) :: v_re(count), v_im(count), q(count)
      real(c_double), intent(out) :: f_re(count), f_im(count)
      complex(c_double_complex) :: f
      integer(c_size_t) :: j

      do j = 1, count
         f = theta_function(i(j), cmplx(v_re(j), v_im(j), c_double), q(j))
         f_re(j) = f%re
         f_im(j) = f%im
      end do
   end subroutine kyvadlo_complex_theta_many

   pure subroutine kyvadlo_theta_derivative_many(count, i, v, q, f) bind(c)
      integer(c_size_t), value :: count
      integer(c_int), intent(in) :: i(count)
      real(c_double), intent(in) :: v(count), q(count)
      real(c_double), intent(out) :: f(count)

      f = theta_derivative(i, v, q)
   end subroutine kyvadlo_theta_derivative_many

   !> Of a complex v: real and imaginary parts in arrays of their own.
   pure subroutine kyvadlo_complex_theta_derivative_many(count, i, v_re, v_im, q, f_re, f_im) bind(c)
      integer(c_size_t), value :: count
      integer(c_int), intent(in) :: i(count)
      real(c_double), intent(in) :: v_re(count), v_im(count), q(count)
      real(c_double), intent(out) :: f_re(count), f_im(count)
      complex(c_double_complex) :: f
      integer(c_size_t) :: j

      do j = 1, count
         f = theta_derivative(i(j), cmplx(v_re(j), v_im(j), c_double), q(j))
         f_re(j) = f%re
         f_im(j) = f%im
      end do
   end subroutine kyvadlo_complex_theta_derivative_many

   !> The distinct real roots, ascending, roots(:, j) of the j-th cubic; NaN behind them.
   pure subroutine kyvadlo_cubic_roots_many(count, a, b, c, d, roots, found) bind(c)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: a(count), b(count), c(count), d(count)
      real(c_double), intent(out) :: roots(3, count)
      integer(c_int), intent(out) :: found(count)
      integer :: number
      integer(c_size_t) :: j

      do j = 1, count
         call cubic_roots(a(j), b(j), c(j), d(j), roots(:, j), number)
         found(j) = int(number, c_int)
      end do
   end subroutine kyvadlo_cubic_roots_many

end module kyvadlo_array_functions
