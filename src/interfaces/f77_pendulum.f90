!> The pendulum for Fortran 77 (doc/legacy_fortran.md): CALL KYVSET(EL, G, Z1, Z2, WORK, LWORK, IER) and its like, an
!> orbit in the caller's WORK array, IER last.
!>
!> The names in bind are those that gfortran, flang and their like give to an external procedure, so that a program
!> calls them without a module.
module kyvadlo_f77_pendulum
   use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_f_pointer, c_loc
   use kyvadlo, error_type => kyvadlo_error_type
   use kyvadlo_numbers, only: nan => quiet_nan_real64
   implicit none
   private
   public :: kyvper, kyvroo, kyvset, kyvgap, kyvene, kyvsta, kyvpos, kyvmny, kyvmnv, kyvazi
   public :: work_length, ier_short, ier_foreign, ier_count

   !> Elements of WORK that a set-up needs. An orbit takes 216 and its mark 1 (test/unit/test_interface_room.pf); the
   !> rest is room for later versions, so that no caller need be changed.
   integer, parameter :: work_length = 300
   integer, parameter :: ier_short = 11    !! LWORK is less than that
   integer, parameter :: ier_foreign = 12  !! WORK was not filled by a set-up of this library, or by one that failed
   integer, parameter :: ier_count = 13    !! A number of times below 0
   !> First element of a WORK that holds an orbit; changes with the layout of `orbit_type`.
   real(c_double), parameter :: signature = 20261130.0_c_double

contains

   !> CALL KYVPER(EL, G, Z1, Z2, T, IER): the period T of the height, (16).
   subroutine kyvper(length, gravity, upper, lower, period, ier) bind(c, name='kyvper_')
      real(c_double), intent(in) :: length, gravity, upper, lower
      real(c_double), intent(out) :: period
      integer(c_int), intent(out) :: ier
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error

      call new_orbit_from_heights(orbit, length, gravity, upper, lower, error)
      ier = code_of(error)
      period = orbit%period()
   end subroutine kyvper

   !> CALL KYVROO(EL, G, C1, C2, Z, GAP, IER): the turning heights z1, z2 and the outer root z3 of the cubic (5), and
   !> l-z1, l+z1, l-z2, l+z2, z3-l, z1-z2, z3-z1, each to its last digits, from energy and angular momentum per mass.
   subroutine kyvroo(length, gravity, energy, momentum, roots, gaps, ier) bind(c, name='kyvroo_')
      real(c_double), intent(in) :: length, gravity, energy, momentum
      real(c_double), intent(out) :: roots(3), gaps(7)
      integer(c_int), intent(out) :: ier
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error

      call new_orbit_from_energy(orbit, length, gravity, energy, momentum, error)
      ier = code_of(error)
      associate (t => orbit%turning)
         roots = [t%upper, t%lower, t%outer]
         gaps = [t%upper_gap, t%upper_rise, t%lower_gap, t%lower_rise, t%outer_excess, t%swing, t%outer_gap]
      end associate
   end subroutine kyvroo

   !> CALL KYVSET(EL, G, Z1, Z2, WORK, LWORK, IER): the orbit between the turning heights into WORK.
   subroutine kyvset(length, gravity, upper, lower, work, work_size, ier) bind(c, name='kyvset_')
      real(c_double), intent(in) :: length, gravity, upper, lower
      real(c_double), intent(inout) :: work(*)
      integer(c_int), intent(in) :: work_size
      integer(c_int), intent(out) :: ier
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error

      call new_orbit_from_heights(orbit, length, gravity, upper, lower, error)
      call pack_orbit(orbit, error, work, work_size, ier)
   end subroutine kyvset

   !> CALL KYVGAP(EL, G, H1, D2, WORK, LWORK, IER): the orbit with the gaps l-z1 and l+z2 into WORK.
   subroutine kyvgap(length, gravity, upper_gap, lower_rise, work, work_size, ier) bind(c, name='kyvgap_')
      real(c_double), intent(in) :: length, gravity, upper_gap, lower_rise
      real(c_double), intent(inout) :: work(*)
      integer(c_int), intent(in) :: work_size
      integer(c_int), intent(out) :: ier
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error

      call new_orbit_from_gaps(orbit, length, gravity, upper_gap, lower_rise, error)
      call pack_orbit(orbit, error, work, work_size, ier)
   end subroutine kyvgap

   !> CALL KYVENE(EL, G, C1, C2, WORK, LWORK, IER): the orbit of energy c1 and angular momentum c2 per mass into WORK.
   subroutine kyvene(length, gravity, energy, momentum, work, work_size, ier) bind(c, name='kyvene_')
      real(c_double), intent(in) :: length, gravity, energy, momentum
      real(c_double), intent(inout) :: work(*)
      integer(c_int), intent(in) :: work_size
      integer(c_int), intent(out) :: ier
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error

      call new_orbit_from_energy(orbit, length, gravity, energy, momentum, error)
      call pack_orbit(orbit, error, work, work_size, ier)
   end subroutine kyvene

   !> CALL KYVSTA(EL, G, X, V, WORK, LWORK, IER): the orbit through position X(3) with velocity V(3) at t = 0 into WORK.
   subroutine kyvsta(length, gravity, position, velocity, work, work_size, ier) bind(c, name='kyvsta_')
      real(c_double), intent(in) :: length, gravity, position(3), velocity(3)
      real(c_double), intent(inout) :: work(*)
      integer(c_int), intent(in) :: work_size
      integer(c_int), intent(out) :: ier
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error

      call new_orbit_from_state(orbit, length, gravity, position, velocity, error)
      call pack_orbit(orbit, error, work, work_size, ier)
   end subroutine kyvsta

   !> CALL KYVPOS(WORK, T, X, V, IER): position X(3) and velocity V(3) at the time T.
   subroutine kyvpos(work, time, position, velocity, ier) bind(c, name='kyvpos_')
      real(c_double), intent(in) :: work(*), time
      real(c_double), intent(out) :: position(3), velocity(3)
      integer(c_int), intent(out) :: ier
      type(orbit_type), pointer :: orbit

      call find_orbit(work, orbit, ier)
      if (ier == 0) then
         call orbit%locate(time, position, velocity)
      else
         position = nan
         velocity = nan
      end if
   end subroutine kyvpos

   !> CALL KYVMNY(WORK, N, T, X, Y, Z, IER): positions at the N times T, by the vector kernels.
   subroutine kyvmny(work, n, time, x, y, z, ier) bind(c, name='kyvmny_')
      integer(c_int), intent(in) :: n
      real(c_double), intent(in) :: work(*), time(*)
      real(c_double), intent(inout) :: x(*), y(*), z(*)
      integer(c_int), intent(out) :: ier
      type(orbit_type), pointer :: orbit

      call find_orbit(work, orbit, ier)
      if (n < 0) then
         ier = ier_count
      else if (ier == 0) then
         call orbit%locate(time(:n), x(:n), y(:n), z(:n))
      else
         x(:n) = nan
         y(:n) = nan
         z(:n) = nan
      end if
   end subroutine kyvmny

   !> CALL KYVMNV(WORK, N, T, X, Y, Z, VX, VY, VZ, IER): positions and velocities at the N times T.
   subroutine kyvmnv(work, n, time, x, y, z, vx, vy, vz, ier) bind(c, name='kyvmnv_')
      integer(c_int), intent(in) :: n
      real(c_double), intent(in) :: work(*), time(*)
      real(c_double), intent(inout) :: x(*), y(*), z(*), vx(*), vy(*), vz(*)
      integer(c_int), intent(out) :: ier
      type(orbit_type), pointer :: orbit

      call find_orbit(work, orbit, ier)
      if (n < 0) then
         ier = ier_count
      else if (ier == 0) then
         call orbit%locate(time(:n), x(:n), y(:n), z(:n), vx(:n), vy(:n), vz(:n))
      else
         x(:n) = nan
         y(:n) = nan
         z(:n) = nan
         vx(:n) = nan
         vy(:n) = nan
         vz(:n) = nan
      end if
   end subroutine kyvmnv

   !> CALL KYVAZI(WORK, T, PHI, IER): the azimuth at the time T, counted on through full turns.
   subroutine kyvazi(work, time, phi, ier) bind(c, name='kyvazi_')
      real(c_double), intent(in) :: work(*), time
      real(c_double), intent(out) :: phi
      integer(c_int), intent(out) :: ier
      type(orbit_type), pointer :: orbit

      call find_orbit(work, orbit, ier)
      phi = nan
      if (ier == 0) phi = orbit%azimuth(time)
   end subroutine kyvazi

   !> Puts an orbit into WORK, if the set-up found one and WORK is long enough.
   subroutine pack_orbit(orbit, error, work, length, ier)
      type(orbit_type), intent(in) :: orbit
      type(error_type), allocatable, intent(in) :: error
      integer(c_int), intent(in) :: length
      real(c_double), intent(inout) :: work(*)
      integer(c_int), intent(out) :: ier
      integer, parameter :: element = storage_size(signature)
      integer :: words

      ier = code_of(error)
      if (length < work_length) ier = ier_short
      if (length >= 1) work(1) = 0
      if (ier /= 0) return
      words = storage_size(orbit)/element
      work(2:1 + words) = transfer(orbit, work(1:1), words)
      work(1) = signature
   end subroutine pack_orbit

   !> The orbit whose bytes WORK holds, in place: 1.7 kB are not copied for one position. IER is `ier_foreign` where it
   !> holds none; bits are compared, since WORK may hold a NaN, which would trap.
   subroutine find_orbit(work, orbit, ier)
      real(c_double), intent(in), target :: work(*)
      type(orbit_type), pointer, intent(out) :: orbit
      integer(c_int), intent(out) :: ier

      ier = merge(0, ier_foreign, transfer(work(1), 0_c_int64_t) == transfer(signature, 0_c_int64_t))
      call c_f_pointer(c_loc(work(2)), orbit)
   end subroutine find_orbit

   !> The code of a set-up, 0 for success.
   pure integer function code_of(error)
      type(error_type), allocatable, intent(in) :: error

      code_of = 0
      if (allocated(error)) code_of = error%code
   end function code_of

end module kyvadlo_f77_pendulum

!> CALL KYVVER(TEXT): the version of the library, as in '0.2.0'; TEXT is any CHARACTER variable, as in KYVMSG.
subroutine kyvver(text)
   use kyvadlo, only: kyvadlo_version_number
   implicit none
   character(len=*), intent(out) :: text

   text = kyvadlo_version_number
end subroutine kyvver

!> CALL KYVMSG(IER, TEXT): what a code means; TEXT is any CHARACTER variable. An external procedure, since bind(c) would
!> take the length of TEXT out of the call.
subroutine kyvmsg(ier, text)
   use kyvadlo_f77_pendulum, only: ier_short, ier_foreign, ier_count
   implicit none
   integer, intent(in) :: ier
   character(len=*), intent(out) :: text

   select case (ier)
   case (0)
      text = 'no error'
   case (1)
      text = 'the values determine no orbit, or an argument is out of range'
   case (2)
      text = 'the result is infinite'
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
