! Elliptic functions for Fortran 77: external procedures with implicit interfaces, double precision, IER last
! (doc/legacy_fortran.md), made from f77_function.inc. IER is 0, ier_outside with NaN outside the domain, ier_pole with an infinity
! at a pole.

!> The codes of IER of the functions.
module kyvadlo_f77_codes
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   private
   public :: function_code

   integer, parameter :: ier_outside = 1  !! An argument is outside the domain: the result is NaN
   integer, parameter :: ier_pole = 2     !! The result is infinite

contains

   !> What a result says about its arguments.
   elemental integer function function_code(y)
      real(real64), intent(in) :: y

      function_code = 0
      if (.not. abs(y) >= 0) function_code = ier_outside
      if (abs(y) > huge(y)) function_code = ier_pole
   end function function_code
end module kyvadlo_f77_codes

!> CALL KYVELK(EM, Y, IER): K(m), the complete integral of the first kind.
#define f77_name kyvelk
#define f_name elliptic_k
#define f_arguments parameter
#include "f77_function.inc"

!> CALL KYVELE(EM, Y, IER): E(m), the complete integral of the second kind.
#define f77_name kyvele
#define f_name elliptic_e
#define f_arguments parameter
#include "f77_function.inc"

!> CALL KYVELP(EN, EM, Y, IER): Pi(n, m), complete, n in 1 - n sin**2.
#define f77_name kyvelp
#define f_name elliptic_pi
#define f_arguments characteristic, parameter
#include "f77_function.inc"

!> CALL KYVELF(PHI, EM, Y, IER): F(phi, m), the incomplete integral of the first kind.
#define f77_name kyvelf
#define f_name elliptic_f
#define f_arguments amplitude, parameter
#include "f77_function.inc"

!> CALL KYVRC(X, Y, RC, IER): R_C(x, y).
#define f77_name kyvrc
#define f_name carlson_rc
#define f_arguments x, y
#include "f77_function.inc"

!> CALL KYVRF(X, Y, Z, RF, IER): R_F(x, y, z).
#define f77_name kyvrf
#define f_name carlson_rf
#define f_arguments x, y, z
#include "f77_function.inc"

!> CALL KYVRD(X, Y, Z, RD, IER): R_D(x, y, z).
#define f77_name kyvrd
#define f_name carlson_rd
#define f_arguments x, y, z
#include "f77_function.inc"

!> CALL KYVRJ(X, Y, Z, P, RJ, IER): R_J(x, y, z, p).
#define f77_name kyvrj
#define f_name carlson_rj
#define f_arguments x, y, z, p
#include "f77_function.inc"

!> CALL KYVSCD(U, EM, SN, CN, DN, IER): the Jacobian functions of argument u and parameter m.
subroutine kyvscd(argument, parameter, sn, cn, dn, ier)
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo, only: jacobi_functions
   use kyvadlo_f77_codes, only: function_code
   implicit none
   real(real64), intent(in) :: argument, parameter
   real(real64), intent(out) :: sn, cn, dn
   integer, intent(out) :: ier

   call jacobi_functions(argument, parameter, sn, cn, dn)
   ier = max(function_code(sn), function_code(cn), function_code(dn))
end subroutine kyvscd
