!> The elliptic functions for C, in double precision: kyvadlo_ before the Fortran name, arguments by value. Documented
!> in kyvadlo.h.
module kyvadlo_c_functions
   use, intrinsic :: iso_c_binding, only: c_double
   use kyvadlo
   implicit none
   public

contains

   pure real(c_double) function kyvadlo_elliptic_k(m) result(f) bind(c)
      real(c_double), value :: m

      f = elliptic_k(m)
   end function kyvadlo_elliptic_k

   pure real(c_double) function kyvadlo_elliptic_kc(mc) result(f) bind(c)
      real(c_double), value :: mc

      f = elliptic_kc(mc)
   end function kyvadlo_elliptic_kc

   pure real(c_double) function kyvadlo_elliptic_e(m) result(f) bind(c)
      real(c_double), value :: m

      f = elliptic_e(m)
   end function kyvadlo_elliptic_e

   pure real(c_double) function kyvadlo_elliptic_ec(mc) result(f) bind(c)
      real(c_double), value :: mc

      f = elliptic_ec(mc)
   end function kyvadlo_elliptic_ec

   pure real(c_double) function kyvadlo_elliptic_d(m) result(f) bind(c)
      real(c_double), value :: m

      f = elliptic_d(m)
   end function kyvadlo_elliptic_d

   pure real(c_double) function kyvadlo_elliptic_dc(mc) result(f) bind(c)
      real(c_double), value :: mc

      f = elliptic_dc(mc)
   end function kyvadlo_elliptic_dc

   pure real(c_double) function kyvadlo_elliptic_b(m) result(f) bind(c)
      real(c_double), value :: m

      f = elliptic_b(m)
   end function kyvadlo_elliptic_b

   pure real(c_double) function kyvadlo_elliptic_bc(mc) result(f) bind(c)
      real(c_double), value :: mc

      f = elliptic_bc(mc)
   end function kyvadlo_elliptic_bc

   pure real(c_double) function kyvadlo_elliptic_nome(m) result(f) bind(c)
      real(c_double), value :: m

      f = elliptic_nome(m)
   end function kyvadlo_elliptic_nome

   pure real(c_double) function kyvadlo_elliptic_nomec(mc) result(f) bind(c)
      real(c_double), value :: mc

      f = elliptic_nomec(mc)
   end function kyvadlo_elliptic_nomec

   pure real(c_double) function kyvadlo_carlson_rc(x, y) result(f) bind(c)
      real(c_double), value :: x, y

      f = carlson_rc(x, y)
   end function kyvadlo_carlson_rc

   pure real(c_double) function kyvadlo_elliptic_pi(n, m) result(f) bind(c)
      real(c_double), value :: n, m

      f = elliptic_pi(n, m)
   end function kyvadlo_elliptic_pi

   pure real(c_double) function kyvadlo_elliptic_pic(n, mc) result(f) bind(c)
      real(c_double), value :: n, mc

      f = elliptic_pic(n, mc)
   end function kyvadlo_elliptic_pic

   pure real(c_double) function kyvadlo_elliptic_f(phi, m) result(f) bind(c)
      real(c_double), value :: phi, m

      f = elliptic_f(phi, m)
   end function kyvadlo_elliptic_f

   pure real(c_double) function kyvadlo_elliptic_fc(phi, mc) result(f) bind(c)
      real(c_double), value :: phi, mc

      f = elliptic_fc(phi, mc)
   end function kyvadlo_elliptic_fc

   pure real(c_double) function kyvadlo_elliptic_einc(phi, m) result(f) bind(c)
      real(c_double), value :: phi, m

      f = elliptic_einc(phi, m)
   end function kyvadlo_elliptic_einc

   pure real(c_double) function kyvadlo_elliptic_eincc(phi, mc) result(f) bind(c)
      real(c_double), value :: phi, mc

      f = elliptic_eincc(phi, mc)
   end function kyvadlo_elliptic_eincc

   pure real(c_double) function kyvadlo_elliptic_dinc(phi, m) result(f) bind(c)
      real(c_double), value :: phi, m

      f = elliptic_dinc(phi, m)
   end function kyvadlo_elliptic_dinc

   pure real(c_double) function kyvadlo_elliptic_dincc(phi, mc) result(f) bind(c)
      real(c_double), value :: phi, mc

      f = elliptic_dincc(phi, mc)
   end function kyvadlo_elliptic_dincc

   pure real(c_double) function kyvadlo_elliptic_binc(phi, m) result(f) bind(c)
      real(c_double), value :: phi, m

      f = elliptic_binc(phi, m)
   end function kyvadlo_elliptic_binc

   pure real(c_double) function kyvadlo_elliptic_bincc(phi, mc) result(f) bind(c)
      real(c_double), value :: phi, mc

      f = elliptic_bincc(phi, mc)
   end function kyvadlo_elliptic_bincc

   pure real(c_double) function kyvadlo_jacobi_zeta(u, m) result(f) bind(c)
      real(c_double), value :: u, m

      f = jacobi_zeta(u, m)
   end function kyvadlo_jacobi_zeta

   pure real(c_double) function kyvadlo_jacobi_zetac(u, mc) result(f) bind(c)
      real(c_double), value :: u, mc

      f = jacobi_zetac(u, mc)
   end function kyvadlo_jacobi_zetac

   pure real(c_double) function kyvadlo_heuman_lambda(phi, m) result(f) bind(c)
      real(c_double), value :: phi, m

      f = heuman_lambda(phi, m)
   end function kyvadlo_heuman_lambda

   pure real(c_double) function kyvadlo_heuman_lambdac(phi, mc) result(f) bind(c)
      real(c_double), value :: phi, mc

      f = heuman_lambdac(phi, mc)
   end function kyvadlo_heuman_lambdac

   pure real(c_double) function kyvadlo_carlson_rf(x, y, z) result(f) bind(c)
      real(c_double), value :: x, y, z

      f = carlson_rf(x, y, z)
   end function kyvadlo_carlson_rf

   pure real(c_double) function kyvadlo_carlson_rd(x, y, z) result(f) bind(c)
      real(c_double), value :: x, y, z

      f = carlson_rd(x, y, z)
   end function kyvadlo_carlson_rd

   pure real(c_double) function kyvadlo_carlson_rg(x, y, z) result(f) bind(c)
      real(c_double), value :: x, y, z

      f = carlson_rg(x, y, z)
   end function kyvadlo_carlson_rg

   pure real(c_double) function kyvadlo_elliptic_piinc(n, phi, m) result(f) bind(c)
      real(c_double), value :: n, phi, m

      f = elliptic_piinc(n, phi, m)
   end function kyvadlo_elliptic_piinc

   pure real(c_double) function kyvadlo_elliptic_piincc(n, phi, mc) result(f) bind(c)
      real(c_double), value :: n, phi, mc

      f = elliptic_piincc(n, phi, mc)
   end function kyvadlo_elliptic_piincc

   pure real(c_double) function kyvadlo_carlson_rj(x, y, z, p) result(f) bind(c)
      real(c_double), value :: x, y, z, p

      f = carlson_rj(x, y, z, p)
   end function kyvadlo_carlson_rj

   pure real(c_double) function kyvadlo_bulirsch_cel(kc, p, a, b) result(f) bind(c)
      real(c_double), value :: kc, p, a, b

      f = bulirsch_cel(kc, p, a, b)
   end function kyvadlo_bulirsch_cel

   pure real(c_double) function kyvadlo_bulirsch_el1(x, kc) result(f) bind(c)
      real(c_double), value :: x, kc

      f = bulirsch_el1(x, kc)
   end function kyvadlo_bulirsch_el1

   pure real(c_double) function kyvadlo_bulirsch_el2(x, kc, a, b) result(f) bind(c)
      real(c_double), value :: x, kc, a, b

      f = bulirsch_el2(x, kc, a, b)
   end function kyvadlo_bulirsch_el2

   pure real(c_double) function kyvadlo_bulirsch_el3(x, kc, p) result(f) bind(c)
      real(c_double), value :: x, kc, p

      f = bulirsch_el3(x, kc, p)
   end function kyvadlo_bulirsch_el3

   pure subroutine kyvadlo_sncndn(argument, parameter, sn, cn, dn, am) bind(c)
      real(c_double), value :: argument, parameter
      real(c_double), intent(out) :: sn, cn, dn, am

      call jacobi_functions(argument, parameter, sn, cn, dn, am)
   end subroutine kyvadlo_sncndn

   pure subroutine kyvadlo_sncndnc(argument, complementary_parameter, sn, cn, dn, am) bind(c)
      real(c_double), value :: argument, complementary_parameter
      real(c_double), intent(out) :: sn, cn, dn, am

      call jacobi_functionsc(argument, complementary_parameter, sn, cn, dn, am)
   end subroutine kyvadlo_sncndnc

end module kyvadlo_c_functions
