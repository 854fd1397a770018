! The names, argument order and error numbers of SLATEC's DRC, DRF, DRD and DRJ (category C14), over kyvadlo's integrals: a
! program that calls SLATEC is linked again, not edited. A library of its own (kyvadlo_slatec), so that nobody else meets these
! names. Described in doc/legacy_fortran.md.
!
! IER as SLATEC documents it, tested in its order: 1 a negative argument, 3 an argument above UPLIM, 2 one below LOLIM; 0 fine.
! Where SLATEC prints a message (and stops, unless XSETF told it not to) and returns 0, these return a quiet NaN and neither
! print nor stop. NaN in gives IER 1.

!> R_C(x, y), x >= 0, y > 0: `carlson_rc`. Errors of all four: doc/accuracy.md.
double precision function drc(x, y, ier)
   use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
   use kyvadlo_carlson, only: carlson_rc
   implicit none
   double precision, intent(in) :: x, y
   integer, intent(out) :: ier
   double precision, parameter :: least = 5*tiny(1d0), greatest = huge(1d0)/5

   drc = ieee_value(drc, ieee_quiet_nan)
   if (.not. (x >= 0 .and. y > 0)) then
      ier = 1
   else if (max(x, y) > greatest) then
      ier = 3
   else if (x + y < least) then
      ier = 2
   else
      ier = 0
      drc = carlson_rc(x, y)
   end if
end function drc

!> R_F(x, y, z), no argument negative: `carlson_rf`.
double precision function drf(x, y, z, ier)
   use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
   use kyvadlo_carlson, only: carlson_rf
   implicit none
   double precision, intent(in) :: x, y, z
   integer, intent(out) :: ier
   double precision, parameter :: least = 5*tiny(1d0), greatest = huge(1d0)/5

   drf = ieee_value(drf, ieee_quiet_nan)
   if (.not. (x >= 0 .and. y >= 0 .and. z >= 0)) then
      ier = 1
   else if (max(x, y, z) > greatest) then
      ier = 3
   else if (min(x + y, x + z, y + z) < least) then
      ier = 2
   else
      ier = 0
      drf = carlson_rf(x, y, z)
   end if
end function drf

!> R_D(x, y, z), x and y not negative, z > 0: `carlson_rd`.
double precision function drd(x, y, z, ier)
   use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
   use kyvadlo_carlson, only: carlson_rd
   implicit none
   double precision, intent(in) :: x, y, z
   integer, intent(out) :: ier
   !> SLATEC's tolerance of the duplication, from D1MACH(3) = 2**(-53): here it only sets UPLIM.
   double precision, parameter :: tolerance = (epsilon(1d0)/2/3)**(1d0/6)
   double precision, parameter :: least = 2/huge(1d0)**(2d0/3), greatest = ((0.1d0*tolerance)**(1d0/3)/tiny(1d0)**(1d0/3))**2

   drd = ieee_value(drd, ieee_quiet_nan)
   if (.not. (x >= 0 .and. y >= 0 .and. z == z)) then
      ier = 1
   else if (max(x, y, z) > greatest) then
      ier = 3
   else if (min(x + y, z) < least) then
      ier = 2
   else
      ier = 0
      drd = carlson_rd(x, y, z)
   end if
end function drd

!> R_J(x, y, z, p), x, y and z not negative, p > 0: `carlson_rj`. (A principal value is carlson_rj's, not SLATEC's: p < 0 gives
!> IER 2.)
double precision function drj(x, y, z, p, ier)
   use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
   use kyvadlo_carlson, only: carlson_rj
   implicit none
   double precision, intent(in) :: x, y, z, p
   integer, intent(out) :: ier
   double precision, parameter :: least = (5*tiny(1d0))**(1d0/3), greatest = 0.3d0*(huge(1d0)/5)**(1d0/3)

   drj = ieee_value(drj, ieee_quiet_nan)
   if (.not. (x >= 0 .and. y >= 0 .and. z >= 0 .and. p == p)) then
      ier = 1
   else if (max(x, y, z, p) > greatest) then
      ier = 3
   else if (min(x + y, x + z, y + z, p) < least) then
      ier = 2
   else
      ier = 0
      drj = carlson_rj(x, y, z, p)
   end if
end function drj
