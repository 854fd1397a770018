!> Orbits for C, their set-up (what they answer is in c_motion.f90): a plain struct that the caller owns, set up once
!> and read by any thread; nothing to free. Documented in kyvadlo.h.
!>
!> The struct is the bytes of the Fortran type in room to spare, sealed by a checksum (seal.c): every function looks at
!> the seal first, and of a struct that was never set up, or changed, it answers NaN or a code.
module kyvadlo_c_orbits
   use, intrinsic :: iso_c_binding, only: c_double, c_int, c_size_t, c_char, c_null_char, c_f_pointer, c_loc
   use kyvadlo, error_type => kyvadlo_error_type
   use kyvadlo_status, only: fail
   use kyvadlo_numbers_real64, only: quiet_nan
   implicit none
   public

   !> Doubles in the struct; KYVADLO_ORBIT_SIZE in kyvadlo.h. An orbit takes 217 and the seal one;
   !> test/unit/test_interface_room.pf finds one that outgrows it.
   integer, parameter :: orbit_size = 225

   type, bind(c) :: c_orbit_type
      real(c_double) :: hidden(orbit_size) = 0
   end type c_orbit_type

   interface
      subroutine put_seal(orbit) bind(c, name='kyvadlo_put_seal')
         import :: c_orbit_type
         type(c_orbit_type), intent(inout) :: orbit
      end subroutine put_seal

      !> Not 0: the struct is as the set-up left it.
      integer(c_int) function has_seal(orbit) bind(c, name='kyvadlo_has_seal')
         import :: c_int, c_orbit_type
         type(c_orbit_type), intent(in) :: orbit
      end function has_seal
   end interface

contains

   function kyvadlo_orbit_from_heights(length, gravity, upper, lower, orbit, message, capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, upper, lower
      type(c_orbit_type), intent(inout) :: orbit
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: capacity
      integer(c_int) :: code
      type(orbit_type) :: made
      type(error_type), allocatable :: error

      call new_orbit_from_heights(made, length, gravity, upper, lower, error)
      call deliver(made, error, orbit, message, capacity, code)
   end function kyvadlo_orbit_from_heights

   function kyvadlo_orbit_from_gaps(length, gravity, upper_gap, lower_rise, orbit, message, capacity) &
      result(code) bind(c)
      real(c_double), value :: length, gravity, upper_gap, lower_rise
      type(c_orbit_type), intent(inout) :: orbit
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: capacity
      integer(c_int) :: code
      type(orbit_type) :: made
      type(error_type), allocatable :: error

      call new_orbit_from_gaps(made, length, gravity, upper_gap, lower_rise, error)
      call deliver(made, error, orbit, message, capacity, code)
   end function kyvadlo_orbit_from_gaps

   function kyvadlo_orbit_from_rises(length, gravity, upper_rise, lower_rise, orbit, message, &
      capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, upper_rise, lower_rise
      type(c_orbit_type), intent(inout) :: orbit
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: capacity
      integer(c_int) :: code
      type(orbit_type) :: made
      type(error_type), allocatable :: error

      call new_orbit_from_rises(made, length, gravity, upper_rise, lower_rise, error)
      call deliver(made, error, orbit, message, capacity, code)
   end function kyvadlo_orbit_from_rises

   function kyvadlo_orbit_from_energy(length, gravity, energy, momentum, orbit, message, capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, energy, momentum
      type(c_orbit_type), intent(inout) :: orbit
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: capacity
      integer(c_int) :: code
      type(orbit_type) :: made
      type(error_type), allocatable :: error

      call new_orbit_from_energy(made, length, gravity, energy, momentum, error)
      call deliver(made, error, orbit, message, capacity, code)
   end function kyvadlo_orbit_from_energy

   function kyvadlo_orbit_from_energy_above_top(length, gravity, energy, momentum, orbit, message, &
      capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, energy, momentum
      type(c_orbit_type), intent(inout) :: orbit
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: capacity
      integer(c_int) :: code
      type(orbit_type) :: made
      type(error_type), allocatable :: error

      call new_orbit_from_energy_above_top(made, length, gravity, energy, momentum, error)
      call deliver(made, error, orbit, message, capacity, code)
   end function kyvadlo_orbit_from_energy_above_top

   function kyvadlo_orbit_from_energy_above_bottom(length, gravity, energy, momentum, orbit, message, &
      capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, energy, momentum
      type(c_orbit_type), intent(inout) :: orbit
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: capacity
      integer(c_int) :: code
      type(orbit_type) :: made
      type(error_type), allocatable :: error

      call new_orbit_from_energy_above_bottom(made, length, gravity, energy, momentum, error)
      call deliver(made, error, orbit, message, capacity, code)
   end function kyvadlo_orbit_from_energy_above_bottom

   function kyvadlo_orbit_from_release(length, gravity, angle, speed, orbit, message, capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, angle, speed
      type(c_orbit_type), intent(inout) :: orbit
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: capacity
      integer(c_int) :: code
      type(orbit_type) :: made
      type(error_type), allocatable :: error

      call new_orbit_from_release(made, length, gravity, angle, speed, error)
      call deliver(made, error, orbit, message, capacity, code)
   end function kyvadlo_orbit_from_release

   function kyvadlo_orbit_from_state(length, gravity, position, velocity, orbit, message, capacity) result(code) bind(c)
      real(c_double), value :: length, gravity
      real(c_double), intent(in) :: position(3), velocity(3)
      type(c_orbit_type), intent(inout) :: orbit
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: capacity
      integer(c_int) :: code
      type(orbit_type) :: made
      type(error_type), allocatable :: error

      call new_orbit_from_state(made, length, gravity, position, velocity, error)
      call deliver(made, error, orbit, message, capacity, code)
   end function kyvadlo_orbit_from_state

   !> Whether the struct holds an orbit as a set-up of this library left it.
   integer(c_int) function kyvadlo_is_set_up(orbit) result(answer) bind(c)
      type(c_orbit_type), intent(in), optional :: orbit   !! A null pointer holds none

      answer = 0
      if (present(orbit)) answer = has_seal(orbit)
   end function kyvadlo_is_set_up

   !> Lets the positions of an orbit cost less; where that fails the orbit stays as it is.
   function kyvadlo_orbit_to_accuracy(orbit, accuracy, span, message, capacity) result(code) bind(c)
      type(c_orbit_type), intent(inout), target :: orbit
      real(c_double), value :: accuracy, span
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: capacity
      integer(c_int) :: code
      type(accurate_orbit_type) :: chosen
      type(c_orbit_type) :: packed
      type(error_type), allocatable :: error

      if (has_seal(orbit) /= 0) then
         call new_orbit_to_accuracy(chosen, seen(orbit), accuracy, span, error)
      else
         call fail(error, code_domain, 'kyvadlo_orbit_to_accuracy: orbit is not set up')
      end if
      call deliver(chosen%orbit, error, packed, message, capacity, code)
      if (code == 0) orbit = packed
   end function kyvadlo_orbit_to_accuracy

   !> z2, z1, z3, l+z2, l-z1, z1-z2, z3-z1, z3-l.
   subroutine kyvadlo_turning(orbit, values) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), intent(out) :: values(8)
      type(orbit_type), pointer :: own

      values = quiet_nan
      if (has_seal(orbit) == 0) return
      own => seen(orbit)
      associate (t => own%turning)
         values = [t%lower, t%upper, t%outer, t%lower_rise, t%upper_gap, t%swing, t%outer_gap, t%outer_excess]
      end associate
   end subroutine kyvadlo_turning

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

   !> Packs an orbit, or a code and a message that ends within the caller's buffer. Code 0: no error; the others as
   !> `code_*` of kyvadlo_status.
   subroutine deliver(made, error, orbit, message, capacity, code)
      type(orbit_type), intent(in) :: made
      type(error_type), allocatable, intent(in) :: error
      type(c_orbit_type), intent(inout) :: orbit
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), intent(in) :: capacity  !! Of any size: what C calls -1 is the largest
      integer(c_int), intent(out) :: code
      integer :: words

      orbit%hidden = 0
      words = storage_size(made)/storage_size(orbit%hidden)
      orbit%hidden(:words) = transfer(made, orbit%hidden, words)
      if (made%is_set_up()) call put_seal(orbit)
      call give_message(error, message, capacity, code)
   end subroutine deliver

   !> The code of an error and its message in C's words.
   subroutine give_message(error, message, capacity, code)
      type(error_type), allocatable, intent(in) :: error
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), intent(in) :: capacity  !! Of any size: what C calls -1 is the largest
      integer(c_int), intent(out) :: code
      character(len=:), allocatable :: text
      integer :: i, length

      code = 0
      text = ''
      if (allocated(error)) then
         code = int(error%code, c_int)
         text = error%message
         call name_as_in_c(text)
      end if
      if (capacity == 0) return
      length = len(text)
      if (capacity > 0) length = int(min(capacity - 1, int(length, c_size_t)))
      do i = 1, length
         message(i) = text(i:i)
      end do
      message(length + 1) = c_null_char
   end subroutine give_message

   !> Puts the arguments' names of kyvadlo.h for those of scenes and of Fortran.
   pure subroutine name_as_in_c(text)
      character(len=:), allocatable, intent(inout) :: text
      character(len=*), parameter :: theirs(*) = [character(len=21) :: 'z_upper', 'z_lower', 'release_angle', &
         'release_speed', 'new_orbit_to_accuracy']
      character(len=*), parameter :: ours(*) = [character(len=25) :: 'upper', 'lower', 'angle', 'speed', &
         'kyvadlo_orbit_to_accuracy']
      integer :: i, at, from

      do i = 1, size(theirs)
         from = 1
         do
            at = index(text(from:), trim(theirs(i)))
            if (at == 0) exit
            at = from + at - 1
            text = text(:at - 1)//trim(ours(i))//text(at + len_trim(theirs(i)):)
            from = at + len_trim(ours(i))
         end do
      end do
   end subroutine name_as_in_c

end module kyvadlo_c_orbits
