!> Orbits for C: a plain struct that the caller owns, set up once and read by any thread; nothing to free. Documented in kyvadlo.h.
!>
!> The struct is the bytes of the Fortran type in room to spare; only functions of the same version of the library may read it.
module kyvadlo_c_orbits
   use, intrinsic :: iso_c_binding, only: c_double, c_int, c_size_t, c_char, c_null_char, c_f_pointer, c_loc
   use kyvadlo
   implicit none
   private
   public :: kyvadlo_orbit_from_heights
   public :: kyvadlo_orbit_from_gaps
   public :: kyvadlo_orbit_from_rises
   public :: kyvadlo_orbit_from_energy
   public :: kyvadlo_orbit_from_energy_above_top
   public :: kyvadlo_orbit_from_energy_above_bottom
   public :: kyvadlo_orbit_from_release
   public :: kyvadlo_orbit_from_state, kyvadlo_orbit_bytes, kyvadlo_locate, kyvadlo_turning
   public :: kyvadlo_locate_many, kyvadlo_locate_many_threads
   public :: kyvadlo_orbit_to_accuracy
   public :: kyvadlo_height_period
   public :: kyvadlo_modulus
   public :: kyvadlo_complementary_modulus
   public :: kyvadlo_quarter_period
   public :: kyvadlo_nome
   public :: kyvadlo_phase_rate
   public :: kyvadlo_azimuth_rate
   public :: kyvadlo_azimuth_per_period
   public :: kyvadlo_apsidal_advance
   public :: kyvadlo_apsidal_angle
   public :: kyvadlo_orbit_energy
   public :: kyvadlo_orbit_momentum
   public :: kyvadlo_height
   public :: kyvadlo_rise
   public :: kyvadlo_top_clearance
   public :: kyvadlo_azimuth
   public :: kyvadlo_vertical_speed
   public :: kyvadlo_azimuthal_speed
   public :: kyvadlo_speed
   public :: kyvadlo_rod_force
   public :: kyvadlo_time_to_height
   public :: kyvadlo_time_to_rise
   public :: kyvadlo_time_to_azimuth
   public :: kyvadlo_next_turning_time

   !> Doubles in the struct; KYVADLO_ORBIT_SIZE in kyvadlo.h. An orbit takes 216; test/unit/test_interface_room.pf finds one that
   !> outgrows it.
   integer, parameter :: orbit_size = 288

   type, bind(c), public :: c_orbit_type
      real(c_double) :: hidden(orbit_size)
   end type c_orbit_type

contains

#define c_name kyvadlo_orbit_from_heights
#define f_name new_orbit_from_heights
#include "c_set_up.inc"

#define c_name kyvadlo_orbit_from_gaps
#define f_name new_orbit_from_gaps
#include "c_set_up.inc"

#define c_name kyvadlo_orbit_from_rises
#define f_name new_orbit_from_rises
#include "c_set_up.inc"

#define c_name kyvadlo_orbit_from_energy
#define f_name new_orbit_from_energy
#include "c_set_up.inc"

#define c_name kyvadlo_orbit_from_energy_above_top
#define f_name new_orbit_from_energy_above_top
#include "c_set_up.inc"

#define c_name kyvadlo_orbit_from_energy_above_bottom
#define f_name new_orbit_from_energy_above_bottom
#include "c_set_up.inc"

#define c_name kyvadlo_orbit_from_release
#define f_name new_orbit_from_release
#include "c_set_up.inc"

#define c_name kyvadlo_height_period
#define f_name height_period
#include "c_orbit_0.inc"

#define c_name kyvadlo_modulus
#define f_name modulus
#include "c_orbit_0.inc"

#define c_name kyvadlo_complementary_modulus
#define f_name complementary_modulus
#include "c_orbit_0.inc"

#define c_name kyvadlo_quarter_period
#define f_name quarter_period
#include "c_orbit_0.inc"

#define c_name kyvadlo_nome
#define f_name nome
#include "c_orbit_0.inc"

#define c_name kyvadlo_phase_rate
#define f_name phase_rate
#include "c_orbit_0.inc"

#define c_name kyvadlo_azimuth_rate
#define f_name azimuth_rate
#include "c_orbit_0.inc"

#define c_name kyvadlo_azimuth_per_period
#define f_name azimuth_per_period
#include "c_orbit_0.inc"

#define c_name kyvadlo_apsidal_advance
#define f_name apsidal_advance
#include "c_orbit_0.inc"

#define c_name kyvadlo_apsidal_angle
#define f_name apsidal_angle
#include "c_orbit_0.inc"

#define c_name kyvadlo_orbit_energy
#define f_name orbit_energy
#include "c_orbit_0.inc"

#define c_name kyvadlo_orbit_momentum
#define f_name orbit_momentum
#include "c_orbit_0.inc"

#define c_name kyvadlo_height
#define f_name height
#include "c_orbit_1.inc"

#define c_name kyvadlo_rise
#define f_name rise
#include "c_orbit_1.inc"

#define c_name kyvadlo_top_clearance
#define f_name top_clearance
#include "c_orbit_1.inc"

#define c_name kyvadlo_azimuth
#define f_name azimuth
#include "c_orbit_1.inc"

#define c_name kyvadlo_vertical_speed
#define f_name vertical_speed
#include "c_orbit_1.inc"

#define c_name kyvadlo_azimuthal_speed
#define f_name azimuthal_speed
#include "c_orbit_1.inc"

#define c_name kyvadlo_speed
#define f_name speed
#include "c_orbit_1.inc"

#define c_name kyvadlo_rod_force
#define f_name rod_force
#include "c_orbit_1.inc"

#define c_name kyvadlo_time_to_height
#define f_name time_to_height
#include "c_orbit_1.inc"

#define c_name kyvadlo_time_to_rise
#define f_name time_to_rise
#include "c_orbit_1.inc"

#define c_name kyvadlo_time_to_azimuth
#define f_name time_to_azimuth
#include "c_orbit_1.inc"

#define c_name kyvadlo_next_turning_time
#define f_name next_turning_time
#include "c_orbit_1.inc"

   function kyvadlo_orbit_from_state(length, gravity, position, velocity, orbit, message, capacity) &
      result(code) bind(c)
      real(c_double), value :: length, gravity
      real(c_double), intent(in) :: position(3), velocity(3)
      type(c_orbit_type), intent(out) :: orbit
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: capacity
      integer(c_int) :: code
      type(orbit_type) :: made
      type(error_type), allocatable :: error

      call new_orbit_from_state(made, length, gravity, position, velocity, error)
      call deliver(made, error, orbit, message, capacity, code)
   end function kyvadlo_orbit_from_state

   !> Lets the places of an orbit cost less; where that fails the orbit stays as it is.
   function kyvadlo_orbit_to_accuracy(orbit, accuracy, span, message, capacity) result(code) bind(c)
      type(c_orbit_type), intent(inout), target :: orbit
      real(c_double), value :: accuracy, span
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: capacity
      integer(c_int) :: code
      type(accurate_orbit_type) :: chosen
      type(c_orbit_type) :: packed
      type(error_type), allocatable :: error

      call new_orbit_to_accuracy(chosen, seen(orbit), accuracy, span, error)
      call deliver(chosen%orbit, error, packed, message, capacity, code)
      if (code == 0) orbit = packed
   end function kyvadlo_orbit_to_accuracy

   !> z2, z1, z3, l+z2, l-z1, z1-z2, z3-z1, z3-l.
   subroutine kyvadlo_turning(orbit, values) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), intent(out) :: values(8)
      type(orbit_type), pointer :: own

      own => seen(orbit)
      associate (t => own%turning)
         values = [t%lower, t%upper, t%outer, t%lower_rise, t%top_gap, t%swing, t%outer_gap, t%outer_excess]
      end associate
   end subroutine kyvadlo_turning

   subroutine kyvadlo_locate(orbit, time, position, velocity) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), value :: time
      real(c_double), intent(out) :: position(3), velocity(3)

      call locate(seen(orbit), time, position, velocity)
   end subroutine kyvadlo_locate

   !> By the vector kernels, on the caller's thread: `locate_many`.
   subroutine kyvadlo_locate_many(orbit, count, times, positions, velocities) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: times(count)
      real(c_double), intent(out) :: positions(3, count), velocities(3, count)

      call kyvadlo_locate_many_threads(orbit, count, times, positions, velocities, 1_c_int)
   end subroutine kyvadlo_locate_many

   !> The same by `threads` threads, 0: as many as OpenMP offers.
   subroutine kyvadlo_locate_many_threads(orbit, count, times, positions, velocities, threads) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: times(count)
      real(c_double), intent(out) :: positions(3, count), velocities(3, count)
      integer(c_int), value :: threads
      !> `locate_many` counts in default integers: longer arrays go in pieces.
      integer(c_size_t), parameter :: longest = 2**28
      integer(c_size_t) :: start, last

      do start = 1, count, longest
         last = min(count, start + longest - 1)
         call locate_many(seen(orbit), times(start:last), positions(:, start:last), velocities(:, start:last), threads=int(threads))
      end do
   end subroutine kyvadlo_locate_many_threads

   !> For languages that cannot read the size of the struct from kyvadlo.h.
   pure integer(c_size_t) function kyvadlo_orbit_bytes() result(bytes) bind(c)
      type(c_orbit_type) :: orbit

      bytes = storage_size(orbit, c_size_t)/8
   end function kyvadlo_orbit_bytes

   !> The orbit whose bytes the struct holds, in place: 1.7 kB are not copied for one value.
   function seen(orbit) result(own)
      type(c_orbit_type), intent(in), target :: orbit
      type(orbit_type), pointer :: own

      call c_f_pointer(c_loc(orbit), own)
   end function seen

   !> Packs an orbit, or a code and a message that ends within the caller's buffer. Code 0: no error; the others as `code_*` of
   !> kyvadlo_status.
   subroutine deliver(made, error, orbit, message, capacity, code)
      type(orbit_type), intent(in) :: made
      type(error_type), allocatable, intent(in) :: error
      type(c_orbit_type), intent(out) :: orbit
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), intent(in) :: capacity
      integer(c_int), intent(out) :: code
      integer(c_size_t) :: i, length
      integer :: words

      orbit%hidden = 0
      words = storage_size(made)/storage_size(orbit%hidden)
      orbit%hidden(:words) = transfer(made, orbit%hidden, words)
      code = 0
      length = 0
      if (allocated(error)) then
         code = int(error%code, c_int)
         length = min(capacity - 1, len(error%message, c_size_t))
         do i = 1, length
            message(i) = error%message(i:i)
         end do
      end if
      if (capacity > 0) message(length + 1) = c_null_char
   end subroutine deliver

end module kyvadlo_c_orbits
