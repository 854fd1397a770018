! Elliptic functions for Fortran 77: external procedures with implicit interfaces, double precision, IER last
! (doc/legacy_fortran.md). IER is 0, ier_outside with NaN outside the domain, ier_pole with an infinity at a pole.

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
subroutine kyvelk(parameter, value, ier)
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo, only: elliptic_k
   use kyvadlo_f77_codes, only: function_code
   implicit none
   real(real64), intent(in) :: parameter
   real(real64), intent(out) :: value
   integer, intent(out) :: ier

   value = elliptic_k(parameter)
   ier = function_code(value)
end subroutine kyvelk

!> CALL KYVELE(EM, Y, IER): E(m), the complete integral of the second kind.
subroutine kyvele(parameter, value, ier)
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo, only: elliptic_e
   use kyvadlo_f77_codes, only: function_code
   implicit none
   real(real64), intent(in) :: parameter
   real(real64), intent(out) :: value
   integer, intent(out) :: ier

   value = elliptic_e(parameter)
   ier = function_code(value)
end subroutine kyvele

!> CALL KYVELP(EN, EM, Y, IER): Pi(n, m), complete, n in 1 - n sin**2.
subroutine kyvelp(characteristic, parameter, value, ier)
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo, only: elliptic_pi
   use kyvadlo_f77_codes, only: function_code
   implicit none
   real(real64), intent(in) :: characteristic, parameter
   real(real64), intent(out) :: value
   integer, intent(out) :: ier

   value = elliptic_pi(characteristic, parameter)
   ier = function_code(value)
end subroutine kyvelp

!> CALL KYVELF(PHI, EM, Y, IER): F(phi, m), the incomplete integral of the first kind.
subroutine kyvelf(amplitude, parameter, value, ier)
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo, only: elliptic_f
   use kyvadlo_f77_codes, only: function_code
   implicit none
   real(real64), intent(in) :: amplitude, parameter
   real(real64), intent(out) :: value
   integer, intent(out) :: ier

   value = elliptic_f(amplitude, parameter)
   ier = function_code(value)
end subroutine kyvelf

!> CALL KYVRC(X, Y, RC, IER): R_C(x, y).
subroutine kyvrc(x, y, value, ier)
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo, only: carlson_rc
   use kyvadlo_f77_codes, only: function_code
   implicit none
   real(real64), intent(in) :: x, y
   real(real64), intent(out) :: value
   integer, intent(out) :: ier

   value = carlson_rc(x, y)
   ier = function_code(value)
end subroutine kyvrc

!> CALL KYVRF(X, Y, Z, RF, IER): R_F(x, y, z).
subroutine kyvrf(x, y, z, value, ier)
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo, only: carlson_rf
   use kyvadlo_f77_codes, only: function_code
   implicit none
   real(real64), intent(in) :: x, y, z
   real(real64), intent(out) :: value
   integer, intent(out) :: ier

   value = carlson_rf(x, y, z)
   ier = function_code(value)
end subroutine kyvrf

!> CALL KYVRD(X, Y, Z, RD, IER): R_D(x, y, z).
subroutine kyvrd(x, y, z, value, ier)
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo, only: carlson_rd
   use kyvadlo_f77_codes, only: function_code
   implicit none
   real(real64), intent(in) :: x, y, z
   real(real64), intent(out) :: value
   integer, intent(out) :: ier

   value = carlson_rd(x, y, z)
   ier = function_code(value)
end subroutine kyvrd

!> CALL KYVRJ(X, Y, Z, P, RJ, IER): R_J(x, y, z, p).
subroutine kyvrj(x, y, z, p, value, ier)
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo, only: carlson_rj
   use kyvadlo_f77_codes, only: function_code
   implicit none
   real(real64), intent(in) :: x, y, z, p
   real(real64), intent(out) :: value
   integer, intent(out) :: ier

   value = carlson_rj(x, y, z, p)
   ier = function_code(value)
end subroutine kyvrj

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
