!> Elliptic functions for Fortran 77 (doc/legacy_fortran.md): CALL KYVELK(EM, Y, IER), arguments first, IER last.
!>
!> The names in bind are those that gfortran, flang and their like give to an external procedure, so that a program
!> calls them without a module.
module kyvadlo_f77_functions
   use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
   use kyvadlo
   implicit none
   private
   public :: kyvcel, kyvel1, kyvel2, kyvel3
   public :: kyvelk, kyvele, kyveld, kyvelb, kyvelp, kyveck, kyvece, kyvecd, kyvecb, kyvecp, kyvelf, kyvine
   public :: kyvind, kyvinb, kyvinp, kyvicf, kyvice, kyvicd, kyvicb, kyvicp, kyvrc, kyvrf, kyvrd, kyvrg
   public :: kyvrj, kyvzet, kyvzec, kyvheu, kyvhec, kyvnom, kyvnoc, kyvthe, kyvthd, kyvscd, kyvscc, kyvam
   public :: kyvamc

   integer, parameter :: ier_outside = 1  !! An argument is outside the domain: the result is NaN
   integer, parameter :: ier_pole = 2     !! The result is infinite

contains

   !> What a result says about its arguments; by its bits, since comparing a NaN may trap.
   pure integer(c_int) function code_of(y)
      real(c_double), intent(in) :: y
      integer(c_int64_t), parameter :: infinity = ishft(2047_c_int64_t, 52)
      integer(c_int64_t) :: bits

      bits = ibclr(transfer(y, bits), 63)
      code_of = 0
      if (bits >= infinity) code_of = merge(ier_pole, ier_outside, bits == infinity)
   end function code_of

   !> CALL KYVELK(EM, Y, IER): K(m), complete, first kind.
   pure subroutine kyvelk(m, y, ier) bind(c, name='kyvelk_')
      real(c_double), intent(in) :: m
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_k(m)
      ier = code_of(y)
   end subroutine kyvelk

   !> CALL KYVELE(EM, Y, IER): E(m), complete, second kind.
   pure subroutine kyvele(m, y, ier) bind(c, name='kyvele_')
      real(c_double), intent(in) :: m
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_e(m)
      ier = code_of(y)
   end subroutine kyvele

   !> CALL KYVELD(EM, Y, IER): D(m) = (K - E)/m.
   pure subroutine kyveld(m, y, ier) bind(c, name='kyveld_')
      real(c_double), intent(in) :: m
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_d(m)
      ier = code_of(y)
   end subroutine kyveld

   !> CALL KYVELB(EM, Y, IER): B(m) = K - D.
   pure subroutine kyvelb(m, y, ier) bind(c, name='kyvelb_')
      real(c_double), intent(in) :: m
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_b(m)
      ier = code_of(y)
   end subroutine kyvelb

   !> CALL KYVELP(EN, EM, Y, IER): Pi(n, m), complete, n in 1 - n sin**2.
   pure subroutine kyvelp(n, m, y, ier) bind(c, name='kyvelp_')
      real(c_double), intent(in) :: n, m
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_pi(n, m)
      ier = code_of(y)
   end subroutine kyvelp

   !> CALL KYVECK(EMC, Y, IER): K from 1 - m.
   pure subroutine kyveck(mc, y, ier) bind(c, name='kyveck_')
      real(c_double), intent(in) :: mc
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_kc(mc)
      ier = code_of(y)
   end subroutine kyveck

   !> CALL KYVECE(EMC, Y, IER): E from 1 - m.
   pure subroutine kyvece(mc, y, ier) bind(c, name='kyvece_')
      real(c_double), intent(in) :: mc
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_ec(mc)
      ier = code_of(y)
   end subroutine kyvece

   !> CALL KYVECD(EMC, Y, IER): D from 1 - m.
   pure subroutine kyvecd(mc, y, ier) bind(c, name='kyvecd_')
      real(c_double), intent(in) :: mc
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_dc(mc)
      ier = code_of(y)
   end subroutine kyvecd

   !> CALL KYVECB(EMC, Y, IER): B from 1 - m.
   pure subroutine kyvecb(mc, y, ier) bind(c, name='kyvecb_')
      real(c_double), intent(in) :: mc
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_bc(mc)
      ier = code_of(y)
   end subroutine kyvecb

   !> CALL KYVECP(EN, EMC, Y, IER): Pi from 1 - m.
   pure subroutine kyvecp(n, mc, y, ier) bind(c, name='kyvecp_')
      real(c_double), intent(in) :: n, mc
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_pic(n, mc)
      ier = code_of(y)
   end subroutine kyvecp

   !> CALL KYVELF(PHI, EM, Y, IER): F(phi, m), incomplete, first kind.
   pure subroutine kyvelf(phi, m, y, ier) bind(c, name='kyvelf_')
      real(c_double), intent(in) :: phi, m
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_f(phi, m)
      ier = code_of(y)
   end subroutine kyvelf

   !> CALL KYVINE(PHI, EM, Y, IER): E(phi, m), incomplete, second kind.
   pure subroutine kyvine(phi, m, y, ier) bind(c, name='kyvine_')
      real(c_double), intent(in) :: phi, m
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_einc(phi, m)
      ier = code_of(y)
   end subroutine kyvine

   !> CALL KYVIND(PHI, EM, Y, IER): D(phi, m) = (F - E)/m.
   pure subroutine kyvind(phi, m, y, ier) bind(c, name='kyvind_')
      real(c_double), intent(in) :: phi, m
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_dinc(phi, m)
      ier = code_of(y)
   end subroutine kyvind

   !> CALL KYVINB(PHI, EM, Y, IER): B(phi, m) = F - D.
   pure subroutine kyvinb(phi, m, y, ier) bind(c, name='kyvinb_')
      real(c_double), intent(in) :: phi, m
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_binc(phi, m)
      ier = code_of(y)
   end subroutine kyvinb

   !> CALL KYVINP(EN, PHI, EM, Y, IER): Pi(n, phi, m), incomplete.
   pure subroutine kyvinp(n, phi, m, y, ier) bind(c, name='kyvinp_')
      real(c_double), intent(in) :: n, phi, m
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_piinc(n, phi, m)
      ier = code_of(y)
   end subroutine kyvinp

   !> CALL KYVICF(PHI, EMC, Y, IER): F from 1 - m.
   pure subroutine kyvicf(phi, mc, y, ier) bind(c, name='kyvicf_')
      real(c_double), intent(in) :: phi, mc
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_fc(phi, mc)
      ier = code_of(y)
   end subroutine kyvicf

   !> CALL KYVICE(PHI, EMC, Y, IER): incomplete E from 1 - m.
   pure subroutine kyvice(phi, mc, y, ier) bind(c, name='kyvice_')
      real(c_double), intent(in) :: phi, mc
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_eincc(phi, mc)
      ier = code_of(y)
   end subroutine kyvice

   !> CALL KYVICD(PHI, EMC, Y, IER): incomplete D from 1 - m.
   pure subroutine kyvicd(phi, mc, y, ier) bind(c, name='kyvicd_')
      real(c_double), intent(in) :: phi, mc
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_dincc(phi, mc)
      ier = code_of(y)
   end subroutine kyvicd

   !> CALL KYVICB(PHI, EMC, Y, IER): incomplete B from 1 - m.
   pure subroutine kyvicb(phi, mc, y, ier) bind(c, name='kyvicb_')
      real(c_double), intent(in) :: phi, mc
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_bincc(phi, mc)
      ier = code_of(y)
   end subroutine kyvicb

   !> CALL KYVICP(EN, PHI, EMC, Y, IER): incomplete Pi from 1 - m.
   pure subroutine kyvicp(n, phi, mc, y, ier) bind(c, name='kyvicp_')
      real(c_double), intent(in) :: n, phi, mc
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_piincc(n, phi, mc)
      ier = code_of(y)
   end subroutine kyvicp

   !> CALL KYVRC(X, Y, RC, IER): R_C(x, y).
   pure subroutine kyvrc(x, y, rc, ier) bind(c, name='kyvrc_')
      real(c_double), intent(in) :: x, y
      real(c_double), intent(out) :: rc
      integer(c_int), intent(out) :: ier

      rc = carlson_rc(x, y)
      ier = code_of(rc)
   end subroutine kyvrc

   !> CALL KYVRF(X, Y, Z, RF, IER): R_F(x, y, z).
   pure subroutine kyvrf(x, y, z, rf, ier) bind(c, name='kyvrf_')
      real(c_double), intent(in) :: x, y, z
      real(c_double), intent(out) :: rf
      integer(c_int), intent(out) :: ier

      rf = carlson_rf(x, y, z)
      ier = code_of(rf)
   end subroutine kyvrf

   !> CALL KYVRD(X, Y, Z, RD, IER): R_D(x, y, z).
   pure subroutine kyvrd(x, y, z, rd, ier) bind(c, name='kyvrd_')
      real(c_double), intent(in) :: x, y, z
      real(c_double), intent(out) :: rd
      integer(c_int), intent(out) :: ier

      rd = carlson_rd(x, y, z)
      ier = code_of(rd)
   end subroutine kyvrd

   !> CALL KYVRG(X, Y, Z, RG, IER): R_G(x, y, z).
   pure subroutine kyvrg(x, y, z, rg, ier) bind(c, name='kyvrg_')
      real(c_double), intent(in) :: x, y, z
      real(c_double), intent(out) :: rg
      integer(c_int), intent(out) :: ier

      rg = carlson_rg(x, y, z)
      ier = code_of(rg)
   end subroutine kyvrg

   !> CALL KYVRJ(X, Y, Z, P, RJ, IER): R_J(x, y, z, p).
   pure subroutine kyvrj(x, y, z, p, rj, ier) bind(c, name='kyvrj_')
      real(c_double), intent(in) :: x, y, z, p
      real(c_double), intent(out) :: rj
      integer(c_int), intent(out) :: ier

      rj = carlson_rj(x, y, z, p)
      ier = code_of(rj)
   end subroutine kyvrj

   !> CALL KYVZET(U, EM, Y, IER): Jacobi's Z(u, m) = E(am u, m) - u E/K.
   pure subroutine kyvzet(u, m, y, ier) bind(c, name='kyvzet_')
      real(c_double), intent(in) :: u, m
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = jacobi_zeta(u, m)
      ier = code_of(y)
   end subroutine kyvzet

   !> CALL KYVZEC(U, EMC, Y, IER): Z from 1 - m.
   pure subroutine kyvzec(u, mc, y, ier) bind(c, name='kyvzec_')
      real(c_double), intent(in) :: u, mc
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = jacobi_zetac(u, mc)
      ier = code_of(y)
   end subroutine kyvzec

   !> CALL KYVHEU(PHI, EM, Y, IER): Heuman's Lambda_0(phi, m).
   pure subroutine kyvheu(phi, m, y, ier) bind(c, name='kyvheu_')
      real(c_double), intent(in) :: phi, m
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = heuman_lambda(phi, m)
      ier = code_of(y)
   end subroutine kyvheu

   !> CALL KYVHEC(PHI, EMC, Y, IER): Lambda_0 from 1 - m.
   pure subroutine kyvhec(phi, mc, y, ier) bind(c, name='kyvhec_')
      real(c_double), intent(in) :: phi, mc
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = heuman_lambdac(phi, mc)
      ier = code_of(y)
   end subroutine kyvhec

   !> CALL KYVNOM(EM, Y, IER): the nome q(m).
   pure subroutine kyvnom(m, y, ier) bind(c, name='kyvnom_')
      real(c_double), intent(in) :: m
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_nome(m)
      ier = code_of(y)
   end subroutine kyvnom

   !> CALL KYVNOC(EMC, Y, IER): q from 1 - m.
   pure subroutine kyvnoc(mc, y, ier) bind(c, name='kyvnoc_')
      real(c_double), intent(in) :: mc
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = elliptic_nomec(mc)
      ier = code_of(y)
   end subroutine kyvnoc

   !> CALL KYVCEL(CK, P, A, B, Y, IER): Bulirsch's cel(kc, p, a, b), kc the complementary modulus.
   pure subroutine kyvcel(kc, p, a, b, y, ier) bind(c, name='kyvcel_')
      real(c_double), intent(in) :: kc, p, a, b
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = bulirsch_cel(kc, p, a, b)
      ier = code_of(y)
   end subroutine kyvcel

   !> CALL KYVEL1(X, CK, Y, IER): Bulirsch's el1(x, kc), x the tangent of the amplitude.
   pure subroutine kyvel1(x, kc, y, ier) bind(c, name='kyvel1_')
      real(c_double), intent(in) :: x, kc
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = bulirsch_el1(x, kc)
      ier = code_of(y)
   end subroutine kyvel1

   !> CALL KYVEL2(X, CK, A, B, Y, IER): Bulirsch's el2(x, kc, a, b).
   pure subroutine kyvel2(x, kc, a, b, y, ier) bind(c, name='kyvel2_')
      real(c_double), intent(in) :: x, kc, a, b
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = bulirsch_el2(x, kc, a, b)
      ier = code_of(y)
   end subroutine kyvel2

   !> CALL KYVEL3(X, CK, P, Y, IER): Bulirsch's el3(x, kc, p).
   pure subroutine kyvel3(x, kc, p, y, ier) bind(c, name='kyvel3_')
      real(c_double), intent(in) :: x, kc, p
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = bulirsch_el3(x, kc, p)
      ier = code_of(y)
   end subroutine kyvel3

   !> CALL KYVTHE(I, V, Q, Y, IER): theta_i(v, q), i = 1 ... 4.
   pure subroutine kyvthe(i, v, q, y, ier) bind(c, name='kyvthe_')
      integer(c_int), intent(in) :: i
      real(c_double), intent(in) :: v, q
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = theta_function(i, v, q)
      ier = code_of(y)
   end subroutine kyvthe

   !> CALL KYVTHD(I, V, Q, Y, IER): the derivative of theta_i(v, q) along v.
   pure subroutine kyvthd(i, v, q, y, ier) bind(c, name='kyvthd_')
      integer(c_int), intent(in) :: i
      real(c_double), intent(in) :: v, q
      real(c_double), intent(out) :: y
      integer(c_int), intent(out) :: ier

      y = theta_derivative(i, v, q)
      ier = code_of(y)
   end subroutine kyvthd

   !> CALL KYVSCD(U, EM, SN, CN, DN, IER): sn(u, m), cn, dn.
   pure subroutine kyvscd(u, m, sn, cn, dn, ier) bind(c, name='kyvscd_')
      real(c_double), intent(in) :: u, m
      real(c_double), intent(out) :: sn, cn, dn
      integer(c_int), intent(out) :: ier

      call jacobi_functions(u, m, sn, cn, dn)
      ier = max(code_of(sn), code_of(cn), code_of(dn))
   end subroutine kyvscd

   !> CALL KYVSCC(U, EMC, SN, CN, DN, IER): sn, cn, dn from 1 - m.
   pure subroutine kyvscc(u, mc, sn, cn, dn, ier) bind(c, name='kyvscc_')
      real(c_double), intent(in) :: u, mc
      real(c_double), intent(out) :: sn, cn, dn
      integer(c_int), intent(out) :: ier

      call jacobi_functionsc(u, mc, sn, cn, dn)
      ier = max(code_of(sn), code_of(cn), code_of(dn))
   end subroutine kyvscc

   !> CALL KYVAM(U, EM, PHI, IER): Jacobi's amplitude am(u, m).
   pure subroutine kyvam(u, m, phi, ier) bind(c, name='kyvam_')
      real(c_double), intent(in) :: u, m
      real(c_double), intent(out) :: phi
      integer(c_int), intent(out) :: ier
      real(c_double) :: sn, cn, dn

      call jacobi_functions(u, m, sn, cn, dn, phi)
      ier = code_of(phi)
   end subroutine kyvam

   !> CALL KYVAMC(U, EMC, PHI, IER): am from 1 - m.
   pure subroutine kyvamc(u, mc, phi, ier) bind(c, name='kyvamc_')
      real(c_double), intent(in) :: u, mc
      real(c_double), intent(out) :: phi
      integer(c_int), intent(out) :: ier
      real(c_double) :: sn, cn, dn

      call jacobi_functionsc(u, mc, sn, cn, dn, phi)
      ier = code_of(phi)
   end subroutine kyvamc

end module kyvadlo_f77_functions
