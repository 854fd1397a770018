!> One swing of a pendulum of 1 m that runs between 0.2 m and 0.8 m below its pivot.
program swing
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo, only: kyvadlo_error_type, new_orbit_from_heights, orbit_type
   implicit none
   type(orbit_type) :: orbit
   type(kyvadlo_error_type), allocatable :: error
   real(wp) :: position(3), velocity(3)
   integer :: i

   ! Set up once. What makes no sense is refused, with a message that says why.
   call new_orbit_from_heights(orbit, length=1.0_wp, gravity=9.80665_wp, upper=-0.2_wp, lower=-0.8_wp, error=error)
   if (allocated(error)) error stop error%message
   print '(a, f9.6, a)', 'from one highest point to the next', orbit%period(), ' s'
   print '(a, f9.6, a)', 'the line of apsides advances by   ', orbit%apsidal_advance(), ' rad'

   ! Evaluate at any time.
   print '(a)', '      t [s]      x [m]      y [m]      z [m]'
   do i = 0, 4
      call orbit%locate(i*orbit%period()/4, position, velocity)
      print '(4f11.6)', i*orbit%period()/4, position
   end do
end program swing
