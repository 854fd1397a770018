!> The apsidal angle of a million orbits, by all threads: between which limits does it lie, and where?
!>
!>    sweep [ORBITS]
program sweep
   use, intrinsic :: iso_fortran_env, only: error_unit, int64, wp => real64
   use kyvadlo, only: kyvadlo_error_type, new_orbit_from_gaps, orbit_type
   implicit none
   real(wp), parameter :: pi = acos(-1.0_wp)
   real(wp), allocatable :: angle(:)
   character(len=40) :: text
   integer, parameter :: share = 1000   ! orbits handed to a thread at a time
   integer :: orbits, status, start_of_share, i
   integer(int64) :: start, finish, rate

   orbits = 1000000
   if (command_argument_count() > 0) then
      call get_command_argument(1, text)
      read (text, *, iostat=status) orbits
      if (status /= 0 .or. orbits < 1) then
         write (error_unit, '(a)') 'Usage: sweep [ORBITS]'
         stop 2
      end if
   end if

   allocate (angle(orbits))
   call system_clock(start, rate)
   ! Set-ups are pure and share nothing: the orbits may be taken in any order (do concurrent), on any number of threads (OpenMP).
   !$omp parallel do schedule(static) private(i)
   do start_of_share = 1, orbits, share
      do concurrent (i=start_of_share:min(start_of_share + share - 1, orbits))
         angle(i) = apsidal_angle_of(i)
      end do
   end do
   call system_clock(finish)

   if (.not. all(angle > pi/2 .and. angle < pi)) error stop 'an apsidal angle is not between pi/2 and pi'
   print '(i0, a)', orbits, ' orbits, every apsidal angle between pi/2 and pi'
   print '(a, f8.5, a, f8.5, a)', 'least ', minval(angle)/pi, ' pi, greatest ', maxval(angle)/pi, ' pi'
   write (error_unit, '(f0.3, a)') real(finish - start, wp)/real(rate, wp), ' s'
   deallocate (angle)

contains

   !> Orbit `i` of a sequence that fills the square of turning heights evenly (Kronecker, with the first two powers of the
   !> inverse of the plastic number), folded onto its half where lower < upper and below upper + lower = 0.
   pure real(wp) function apsidal_angle_of(i) result(angle)
      integer, intent(in) :: i
      real(wp), parameter :: steps(2) = [0.7548776662466927_wp, 0.5698402909980532_wp]
      real(wp) :: gaps(2), upper_gap, lower_rise
      type(orbit_type) :: orbit
      type(kyvadlo_error_type), allocatable :: error

      gaps = 2*modulo(i*steps, 1.0_wp)
      ! l - z1 and l + z2: an orbit needs lower_rise < upper_gap <= 2 l - lower_rise.
      lower_rise = minval(gaps)
      upper_gap = maxval(gaps)
      if (upper_gap + lower_rise > 2) then
         lower_rise = 2 - maxval(gaps)
         upper_gap = 2 - minval(gaps)
      end if
      call new_orbit_from_gaps(orbit, 1.0_wp, 9.80665_wp, upper_gap, lower_rise, error)
      angle = orbit%apsidal_angle()
   end function apsidal_angle_of
end program sweep
