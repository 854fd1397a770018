!> GSL's special functions for the facade kyvadlo_gsl, straight onto libgsl: elliptic integrals and functions.
!>
!> Moduli k, not parameters, and n in 1 + n sin**2: GSL's conventions, which differ from this library's. Outside their
!> domain they return NaN, provided GSL's error handler is off.
module kyvadlo_gsl_special
   use, intrinsic :: iso_c_binding, only: c_double, c_int
   implicit none
   private
   public :: fgsl_mode_t, fgsl_prec_double, fgsl_prec_single, fgsl_prec_approx, fgsl_sf_result
   public :: fgsl_sf_elljac_e, fgsl_sf_ellint_kcomp_e
   public :: fgsl_sf_ellint_kcomp, fgsl_sf_ellint_ecomp, fgsl_sf_ellint_pcomp, fgsl_sf_ellint_f
   public :: fgsl_sf_ellint_e, fgsl_sf_ellint_p, fgsl_sf_ellint_d, fgsl_sf_ellint_rc
   public :: fgsl_sf_ellint_rd, fgsl_sf_ellint_rf, fgsl_sf_ellint_rj

   !> How exact GSL shall be: relative errors of about 2e-16, 1e-7, 5e-4, as its manual says.
   type :: fgsl_mode_t
      private
      integer(c_int) :: mode = 0
   end type fgsl_mode_t
   type(fgsl_mode_t), parameter :: fgsl_prec_double = fgsl_mode_t(0)
   type(fgsl_mode_t), parameter :: fgsl_prec_single = fgsl_mode_t(1)
   type(fgsl_mode_t), parameter :: fgsl_prec_approx = fgsl_mode_t(2)

   !> A value with GSL's own estimate of its error.
   type, bind(c) :: fgsl_sf_result
      real(c_double) :: val = 0, err = 0
   end type fgsl_sf_result

   interface
      !> Jacobi's sn, cn and dn of argument u and parameter m.
      function fgsl_sf_elljac_e(u, m, sn, cn, dn) bind(c, name='gsl_sf_elljac_e') result(status)
         import :: c_double, c_int
         real(c_double), value :: u, m
         real(c_double), intent(out) :: sn, cn, dn
         integer(c_int) :: status
      end function fgsl_sf_elljac_e
      function gsl_kcomp_e(k, mode, r) bind(c, name='gsl_sf_ellint_Kcomp_e') result(status)
         import :: c_double, c_int, fgsl_sf_result
         real(c_double), value :: k
         integer(c_int), value :: mode
         type(fgsl_sf_result), intent(out) :: r
         integer(c_int) :: status
      end function gsl_kcomp_e
      function gsl_kcomp(k, mode) bind(c, name='gsl_sf_ellint_Kcomp') result(value)
         import :: c_double, c_int
         real(c_double), value :: k
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_kcomp
      function gsl_ecomp(k, mode) bind(c, name='gsl_sf_ellint_Ecomp') result(value)
         import :: c_double, c_int
         real(c_double), value :: k
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_ecomp
      function gsl_pcomp(k, n, mode) bind(c, name='gsl_sf_ellint_Pcomp') result(value)
         import :: c_double, c_int
         real(c_double), value :: k, n
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_pcomp
      function gsl_f(phi, k, mode) bind(c, name='gsl_sf_ellint_F') result(value)
         import :: c_double, c_int
         real(c_double), value :: phi, k
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_f
      function gsl_e(phi, k, mode) bind(c, name='gsl_sf_ellint_E') result(value)
         import :: c_double, c_int
         real(c_double), value :: phi, k
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_e
      function gsl_p(phi, k, n, mode) bind(c, name='gsl_sf_ellint_P') result(value)
         import :: c_double, c_int
         real(c_double), value :: phi, k, n
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_p
      function gsl_d(phi, k, mode) bind(c, name='gsl_sf_ellint_D') result(value)
         import :: c_double, c_int
         real(c_double), value :: phi, k
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_d
      function gsl_rc(x, y, mode) bind(c, name='gsl_sf_ellint_RC') result(value)
         import :: c_double, c_int
         real(c_double), value :: x, y
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_rc
      function gsl_rd(x, y, z, mode) bind(c, name='gsl_sf_ellint_RD') result(value)
         import :: c_double, c_int
         real(c_double), value :: x, y, z
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_rd
      function gsl_rf(x, y, z, mode) bind(c, name='gsl_sf_ellint_RF') result(value)
         import :: c_double, c_int
         real(c_double), value :: x, y, z
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_rf
      function gsl_rj(x, y, z, p, mode) bind(c, name='gsl_sf_ellint_RJ') result(value)
         import :: c_double, c_int
         real(c_double), value :: x, y, z, p
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_rj
   end interface

contains

   !> K(k) with a status: GSL_EDOM for k >= 1.
   function fgsl_sf_ellint_kcomp_e(k, mode, result) result(status)
      real(c_double), intent(in) :: k
      type(fgsl_mode_t), intent(in) :: mode
      type(fgsl_sf_result), intent(out) :: result
      integer(c_int) :: status
      status = gsl_kcomp_e(k, mode%mode, result)
   end function fgsl_sf_ellint_kcomp_e

   !> K(k).
   function fgsl_sf_ellint_kcomp(k, mode) result(value)
      real(c_double), intent(in) :: k
      type(fgsl_mode_t), intent(in) :: mode
      real(c_double) :: value
      value = gsl_kcomp(k, mode%mode)
   end function fgsl_sf_ellint_kcomp

   !> E(k).
   function fgsl_sf_ellint_ecomp(k, mode) result(value)
      real(c_double), intent(in) :: k
      type(fgsl_mode_t), intent(in) :: mode
      real(c_double) :: value
      value = gsl_ecomp(k, mode%mode)
   end function fgsl_sf_ellint_ecomp

   !> Complete Pi(k, n), n in 1 + n sin**2.
   function fgsl_sf_ellint_pcomp(k, n, mode) result(value)
      real(c_double), intent(in) :: k, n
      type(fgsl_mode_t), intent(in) :: mode
      real(c_double) :: value
      value = gsl_pcomp(k, n, mode%mode)
   end function fgsl_sf_ellint_pcomp

   !> F(phi, k).
   function fgsl_sf_ellint_f(phi, k, mode) result(value)
      real(c_double), intent(in) :: phi, k
      type(fgsl_mode_t), intent(in) :: mode
      real(c_double) :: value
      value = gsl_f(phi, k, mode%mode)
   end function fgsl_sf_ellint_f

   !> E(phi, k).
   function fgsl_sf_ellint_e(phi, k, mode) result(value)
      real(c_double), intent(in) :: phi, k
      type(fgsl_mode_t), intent(in) :: mode
      real(c_double) :: value
      value = gsl_e(phi, k, mode%mode)
   end function fgsl_sf_ellint_e

   !> Pi(phi, k, n), n in 1 + n sin**2.
   function fgsl_sf_ellint_p(phi, k, n, mode) result(value)
      real(c_double), intent(in) :: phi, k, n
      type(fgsl_mode_t), intent(in) :: mode
      real(c_double) :: value
      value = gsl_p(phi, k, n, mode%mode)
   end function fgsl_sf_ellint_p

   !> D(phi, k) = (F - E)/k**2.
   function fgsl_sf_ellint_d(phi, k, mode) result(value)
      real(c_double), intent(in) :: phi, k
      type(fgsl_mode_t), intent(in) :: mode
      real(c_double) :: value
      value = gsl_d(phi, k, mode%mode)
   end function fgsl_sf_ellint_d

   !> Carlson's RC.
   function fgsl_sf_ellint_rc(x, y, mode) result(value)
      real(c_double), intent(in) :: x, y
      type(fgsl_mode_t), intent(in) :: mode
      real(c_double) :: value
      value = gsl_rc(x, y, mode%mode)
   end function fgsl_sf_ellint_rc

   !> Carlson's RD.
   function fgsl_sf_ellint_rd(x, y, z, mode) result(value)
      real(c_double), intent(in) :: x, y, z
      type(fgsl_mode_t), intent(in) :: mode
      real(c_double) :: value
      value = gsl_rd(x, y, z, mode%mode)
   end function fgsl_sf_ellint_rd

   !> Carlson's RF.
   function fgsl_sf_ellint_rf(x, y, z, mode) result(value)
      real(c_double), intent(in) :: x, y, z
      type(fgsl_mode_t), intent(in) :: mode
      real(c_double) :: value
      value = gsl_rf(x, y, z, mode%mode)
   end function fgsl_sf_ellint_rf

   !> Carlson's RJ.
   function fgsl_sf_ellint_rj(x, y, z, p, mode) result(value)
      real(c_double), intent(in) :: x, y, z, p
      type(fgsl_mode_t), intent(in) :: mode
      real(c_double) :: value
      value = gsl_rj(x, y, z, p, mode%mode)
   end function fgsl_sf_ellint_rj

end module kyvadlo_gsl_special
