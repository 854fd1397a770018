! The library for Fortran 77: external procedures with implicit interfaces, double precision, IER last (doc/legacy_fortran.md).
! They are no module procedures, so that a fixed-form program may call them by name; what they share is in this module.

!> The orbit in a caller's WORK array, and the codes of IER.
module kyvadlo_f77_work
   use, intrinsic :: iso_fortran_env, only: real64
   use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
   use kyvadlo
   implicit none
   private
   public :: work_length, ier_short, ier_foreign, ier_count, pack_orbit, unpack_orbit, code_of, nan

   !> Elements of WORK that a set-up needs. An orbit takes 216 and its mark 1 (test/unit/test_interface_room.pf); the rest is
   !> room for later versions, so that no caller need be changed.
   integer, parameter :: work_length = 300
   integer, parameter :: ier_short = 11    !! LWORK is less than that
   integer, parameter :: ier_foreign = 12  !! WORK was not filled by a set-up of this library, or by one that failed
   integer, parameter :: ier_count = 13    !! A number of times below 0
   !> First element of a WORK that holds an orbit; changes with the layout of `orbit_type`.
   real(real64), parameter :: signature = 19530101.0_real64

contains

   !> Puts an orbit into WORK, if the set-up found one and WORK is long enough.
   subroutine pack_orbit(orbit, error, work, length, ier)
      type(orbit_type), intent(in) :: orbit
      type(error_type), allocatable, intent(in) :: error
      integer, intent(in) :: length
      real(real64), intent(inout) :: work(*)
      integer, intent(out) :: ier
      integer :: words

      ier = code_of(error)
      if (length < work_length) ier = ier_short
      if (length >= 1) work(1) = 0
      if (ier /= 0) return
      words = size(transfer(orbit, work(1:1)))
      work(2:1 + words) = transfer(orbit, work(1:1), words)
      work(1) = signature
   end subroutine pack_orbit

   !> The orbit in WORK.
   subroutine unpack_orbit(work, orbit, ier)
      real(real64), intent(in) :: work(*)
      type(orbit_type), intent(out) :: orbit
      integer, intent(out) :: ier
      integer :: words

      ier = 0
      if (.not. abs(work(1) - signature) <= 0) then
         ier = ier_foreign
         return
      end if
      words = size(transfer(orbit, work(1:1)))
      orbit = transfer(work(2:1 + words), orbit)
   end subroutine unpack_orbit

   !> The code of a set-up, 0 for success.
   integer function code_of(error)
      type(error_type), allocatable, intent(in) :: error

      code_of = 0
      if (allocated(error)) code_of = error%code
   end function code_of

   real(real64) function nan()
      nan = ieee_value(nan, ieee_quiet_nan)
   end function nan
end module kyvadlo_f77_work

!> CALL KYVPER(EL, G, Z1, Z2, T, IER): the period T of the height, (16).
subroutine kyvper(length, gravity, upper, lower, period, ier)
   use kyvadlo
   use kyvadlo_f77_work
   implicit none
   double precision, intent(in) :: length, gravity, upper, lower
   double precision, intent(out) :: period
   integer, intent(out) :: ier
   type(orbit_type) :: orbit
   type(error_type), allocatable :: error

   call new_orbit_from_heights(orbit, length, gravity, upper, lower, error)
   ier = code_of(error)
   period = height_period(orbit)
end subroutine kyvper

!> CALL KYVROO(EL, G, C1, C2, Z, GAP, IER): the turning heights z1, z2 and the outer root z3 of the cubic (5), and l-z1, l+z1,
!> l-z2, l+z2, z3-l, z1-z2, z3-z1, each to its last digits, from energy and angular momentum per mass.
subroutine kyvroo(length, gravity, energy, momentum, roots, gaps, ier)
   use kyvadlo
   use kyvadlo_f77_work
   implicit none
   double precision, intent(in) :: length, gravity, energy, momentum
   double precision, intent(out) :: roots(3), gaps(7)
   integer, intent(out) :: ier
   type(orbit_type) :: orbit
   type(error_type), allocatable :: error

   call new_orbit_from_energy(orbit, length, gravity, energy, momentum, error)
   ier = code_of(error)
   associate (t => orbit%turning)
      roots = [t%upper, t%lower, t%outer]
      gaps = [t%top_gap, t%upper_rise, t%lower_gap, t%lower_rise, t%outer_excess, t%swing, t%outer_gap]
   end associate
end subroutine kyvroo

!> CALL KYVSET(EL, G, Z1, Z2, WORK, LWORK, IER): the orbit between the turning heights into WORK.
#define f77_name kyvset
#define f_name new_orbit_from_heights
#include "f77_set_up.inc"

!> CALL KYVGAP(EL, G, H1, D2, WORK, LWORK, IER): the orbit with the gaps l-z1 and l+z2 into WORK.
#define f77_name kyvgap
#define f_name new_orbit_from_gaps
#include "f77_set_up.inc"

!> CALL KYVENE(EL, G, C1, C2, WORK, LWORK, IER): the orbit of energy c1 and angular momentum c2 per mass into WORK.
#define f77_name kyvene
#define f_name new_orbit_from_energy
#include "f77_set_up.inc"

!> CALL KYVSTA(EL, G, X, V, WORK, LWORK, IER): the orbit through position X(3) with velocity V(3) at t = 0 into WORK.
subroutine kyvsta(length, gravity, position, velocity, work, work_size, ier)
   use kyvadlo
   use kyvadlo_f77_work
   implicit none
   integer, intent(in) :: work_size
   double precision, intent(in) :: length, gravity, position(3), velocity(3)
   double precision, intent(inout) :: work(*)
   integer, intent(out) :: ier
   type(orbit_type) :: orbit
   type(error_type), allocatable :: error

   call new_orbit_from_state(orbit, length, gravity, position, velocity, error)
   call pack_orbit(orbit, error, work, work_size, ier)
end subroutine kyvsta

!> CALL KYVPOS(WORK, T, X, V, IER): position X(3) and velocity V(3) at the time T.
subroutine kyvpos(work, time, position, velocity, ier)
   use kyvadlo
   use kyvadlo_f77_work
   implicit none
   double precision, intent(in) :: work(*), time
   double precision, intent(out) :: position(3), velocity(3)
   integer, intent(out) :: ier
   type(orbit_type) :: orbit

   call unpack_orbit(work, orbit, ier)
   if (ier /= 0) then
      position = nan()
      velocity = nan()
      return
   end if
   call locate(orbit, time, position, velocity)
end subroutine kyvpos

!> CALL KYVMNY(WORK, N, T, X, Y, Z, IER): positions at the N times T, by the vector kernels.
subroutine kyvmny(work, n, time, x, y, z, ier)
   use kyvadlo
   use kyvadlo_f77_work
   implicit none
   integer, intent(in) :: n
   double precision, intent(in) :: work(*), time(*)
   double precision, intent(inout) :: x(*), y(*), z(*)
   integer, intent(out) :: ier
   type(orbit_type) :: orbit

   call unpack_orbit(work, orbit, ier)
   if (n < 0) then
      ier = ier_count
   else if (ier /= 0) then
      x(:n) = nan()
      y(:n) = nan()
      z(:n) = nan()
   else
      call locate_batch(orbit, time(:n), x(:n), y(:n), z(:n))
   end if
end subroutine kyvmny

!> CALL KYVMNV(WORK, N, T, X, Y, Z, VX, VY, VZ, IER): positions and velocities at the N times T.
subroutine kyvmnv(work, n, time, x, y, z, vx, vy, vz, ier)
   use kyvadlo
   use kyvadlo_f77_work
   implicit none
   integer, intent(in) :: n
   double precision, intent(in) :: work(*), time(*)
   double precision, intent(inout) :: x(*), y(*), z(*), vx(*), vy(*), vz(*)
   integer, intent(out) :: ier
   type(orbit_type) :: orbit

   call unpack_orbit(work, orbit, ier)
   if (n < 0) then
      ier = ier_count
   else if (ier /= 0) then
      x(:n) = nan()
      y(:n) = nan()
      z(:n) = nan()
      vx(:n) = nan()
      vy(:n) = nan()
      vz(:n) = nan()
   else
      call locate_batch(orbit, time(:n), x(:n), y(:n), z(:n), vx(:n), vy(:n), vz(:n))
   end if
end subroutine kyvmnv

!> CALL KYVAZI(WORK, T, PHI, IER): the azimuth at the time T, counted on through full turns.
subroutine kyvazi(work, time, phi, ier)
   use kyvadlo
   use kyvadlo_f77_work
   implicit none
   double precision, intent(in) :: work(*), time
   double precision, intent(out) :: phi
   integer, intent(out) :: ier
   type(orbit_type) :: orbit

   call unpack_orbit(work, orbit, ier)
   phi = nan()
   if (ier == 0) phi = azimuth(orbit, time)
end subroutine kyvazi

!> CALL KYVMSG(IER, TEXT): what a code means; TEXT is any CHARACTER variable.
subroutine kyvmsg(ier, text)
   use kyvadlo
   use kyvadlo_f77_work
   implicit none
   integer, intent(in) :: ier
   character(len=*), intent(out) :: text

   select case (ier)
   case (0)
      text = 'no error'
   case (code_domain)
      text = 'the values determine no orbit'
   case (ier_short)
      text = 'WORK is too short: LWORK must be 300 or more'
   case (ier_foreign)
      text = 'WORK holds no orbit: call KYVSET, KYVGAP, KYVENE or KYVSTA first'
   case (ier_count)
      text = 'the number of times is negative'
   case default
      text = 'unknown code'
   end select
end subroutine kyvmsg
