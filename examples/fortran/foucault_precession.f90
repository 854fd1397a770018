!> Why a Foucault pendulum is long and swings narrowly: a bob that does not pass exactly through the lowest point draws an
!> ellipse, whose axis turns by itself, on a globe at rest too. This turning, over the amplitude, for Foucault's 67 m of wire
!> and a bob that misses the lowest point by 1 cm, beside Airy's rate for small ellipses, 3/8 omega a b/l**2, and beside the
!> turn of the plane at the latitude of Paris.
!>
!> Prints the table, and writes foucault_precession.dat and foucault_precession.gp: `gnuplot foucault_precession.gp` draws
!> foucault_precession.png.
program foucault_precession
   use, intrinsic :: iso_fortran_env, only: error_unit, wp => real64
   use kyvadlo, only: kyvadlo_error_type, new_orbit_from_rises, orbit_type
   implicit none
   real(wp), parameter :: length = 67, gravity = 9.80665_wp, miss = 0.01_wp
   real(wp), parameter :: pi = acos(-1.0_wp)
   real(wp), parameter :: degrees_per_hour = 180/pi*3600
   !> The sidereal rotation of the Earth, 7.292115e-5 rad/s (IERS Conventions 2010), times the sine of 48.85 degrees.
   real(wp), parameter :: plane_rate = 7.292115e-5_wp*sin(48.85_wp*pi/180)*degrees_per_hour
   type(orbit_type) :: orbit
   type(kyvadlo_error_type), allocatable :: error
   real(wp) :: amplitude, exact, airy
   integer :: data_file, script, i

   open (newunit=data_file, file='foucault_precession.dat', action='write', status='replace')
   write (data_file, '(a)') '# amplitude [m], turn of the ellipse [degrees/h], Airy [degrees/h]'
   print '(a)', 'amplitude [m]  exact [deg/h]   Airy [deg/h]'
   do i = 1, 40
      amplitude = 0.5_wp*i
      ! Rises, not heights: the ellipse is 7.5e-7 m above the lowest point where it is closest.
      call new_orbit_from_rises(orbit, length, gravity, rise_at(amplitude), rise_at(miss), error)
      if (allocated(error)) then
         write (error_unit, '(a)') error%message
         error stop
      end if
      exact = orbit%apsidal_rate()*degrees_per_hour
      airy = 3*sqrt(gravity/length)*amplitude*miss/(8*length**2)*degrees_per_hour
      write (data_file, '(f6.2, 2es24.16)') amplitude, exact, airy
      if (mod(i, 4) == 0) print '(f13.2, 2f15.8)', amplitude, exact, airy
   end do
   close (data_file)
   print '(a, f0.4, a)', 'Earth turns the plane by ', plane_rate, ' deg/h'

   open (newunit=script, file='foucault_precession.gp', action='write', status='replace')
   write (script, '(a)') 'set terminal pngcairo size 800,500', &
      'set output "foucault_precession.png"', &
      'set xlabel "amplitude a [m]"', &
      'set ylabel "turn of the ellipse [degrees per hour]"', &
      'set key left top', &
      'set grid', &
      'plot "foucault_precession.dat" using 1:2 with lines lw 2 title "exact", \', &
      '     "" using 1:3 with lines dt 2 title "Airy, 3/8 {/Symbol w} a b/l^2"'
   close (script)

contains

   !> The rise above the lowest point at a distance from the vertical [m], without forming l - sqrt(l**2 - r**2).
   pure real(wp) function rise_at(radius)
      real(wp), intent(in) :: radius  !! [m]

      rise_at = radius**2/(length + sqrt(length**2 - radius**2))
   end function rise_at
end program foucault_precession
