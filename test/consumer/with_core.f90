!> A program of somebody else that needs the core only.
program with_core
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo, only: carlson_rf, elliptic_k, kyvadlo_error_type, kyvadlo_version_linked, kyvadlo_version_number, &
      new_orbit_from_heights, orbit_type
   implicit none
   type(kyvadlo_error_type), allocatable :: error
   type(orbit_type) :: orbit
   real(real64) :: z
   character(len=20) :: expected

   ! The version that find_package found, if it is given.
   call get_command_argument(1, expected)
   if (expected /= '' .and. (kyvadlo_version_number /= expected .or. kyvadlo_version_linked() /= expected)) &
      error stop 'another version'

   ! K(1/2) = RF(0, 1/2, 1) = 1.8540746773013719...
   call check(elliptic_k(0.5_real64))
   call check(carlson_rf(0.0_real64, 0.5_real64, 1.0_real64))

   ! Half a period after the upper turning height comes the lower one.
   call new_orbit_from_heights(orbit, 1.0_real64, 9.80665_real64, 0.25_real64, -0.75_real64, error)
   if (allocated(error)) error stop 'no orbit between 0.25 and -0.75'
   z = orbit%height(orbit%period()/2)
   if (.not. abs(z + 0.75_real64) <= 4*epsilon(z)) error stop 'not at the lower turning height'
   print '(a, f6.3)', 'z(T/2) = ', z

   call new_orbit_from_heights(orbit, -1.0_real64, 9.80665_real64, 0.25_real64, -0.75_real64, error)
   if (.not. allocated(error)) error stop 'a negative length went through'
   print '(a)', error%message
   deallocate (error)   ! the leak sanitizer counts what a main program keeps

contains

   subroutine check(value)
      real(real64), intent(in) :: value
      if (.not. abs(value - 1.8540746773013719_real64) <= 4*epsilon(value)) error stop 'not K(1/2)'
      print '(a, f18.16)', 'K(1/2) = ', value
   end subroutine check

end program with_core
