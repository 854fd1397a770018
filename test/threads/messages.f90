!> Failures of the Fortran interface and of scenes, for `many_threads.c`.
module messages
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_null_char
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo, only: new_orbit_from_heights, new_orbit_from_release, orbit_type
   use kyvadlo_number_text, only: digits_text, shortest_text
   use kyvadlo_simulation, only: parse_simulation, simulation_type
   use kyvadlo_status, only: error_type
   use kyvadlo_text, only: integer_text
   implicit none
   private
   public :: fortran_message
   character(len=*), parameter :: start = '&pendulum length=1 release_angle=60 release_speed=0 /'

contains

   subroutine fortran_message(which, text, capacity) bind(c)
      integer(c_int), value :: which, capacity
      character(kind=c_char), intent(out) :: text(capacity)
      type(orbit_type) :: orbit
      type(simulation_type) :: simulation
      type(error_type), allocatable :: error
      integer :: i

      text = c_null_char
      select case (which)
      case (0)
         call new_orbit_from_heights(orbit, 1.0_real64, 9.80665_real64, 0.5_real64, -1.25e-7_real64 - 1, error)
      case (1)
         call new_orbit_from_release(orbit, 1.0_real64, -1e200_real64, 30.0_real64, 0.0_real64, error)
      case (2)
         call parse_simulation(start//' &air linear=-1e-300 /', 'a scene', simulation, error)
      case (3)
         call parse_simulation(start//' &output quantities=''position nonsense'' /', 'another scene', simulation, error)
      case (4)
         call parse_simulation('&pendulum length=1 energy=1 /', 'third.nml', simulation, error)
      case (5)
         call put(shortest_text(0.0_real64)//' '//shortest_text(3.25e-16_real64)//' '//shortest_text(-1.7e308_real64))
      case (6)
         call put(digits_text(1/3.0_real64, 12)//' '//integer_text(-123456)//' '//shortest_text(5e-324_real64))
      case default
         call parse_simulation('&pendulum length = 12 13 /', 'fourth.nml', simulation, error)
      end select
      if (allocated(error)) call put(error%message)

   contains

      subroutine put(words)
         character(len=*), intent(in) :: words

         do i = 1, min(len(words), capacity - 1)
            text(i) = words(i:i)
         end do
      end subroutine put
   end subroutine fortran_message

end module messages
