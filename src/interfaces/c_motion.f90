!> What an orbit answers in C: NaN of a struct that is not sealed (c_orbits.f90). Documented in kyvadlo.h.
module kyvadlo_c_motion
   use, intrinsic :: iso_c_binding, only: c_double, c_int, c_size_t
   use kyvadlo, only: orbit_type
   use kyvadlo_c_orbits, only: c_orbit_type, has_seal, seen
   use kyvadlo_numbers_real64, only: quiet_nan
   implicit none
   public

contains

   real(c_double) function kyvadlo_height_period(orbit) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%period()
   end function kyvadlo_height_period

   real(c_double) function kyvadlo_modulus(orbit) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%modulus()
   end function kyvadlo_modulus

   real(c_double) function kyvadlo_complementary_modulus(orbit) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%complementary_modulus()
   end function kyvadlo_complementary_modulus

   real(c_double) function kyvadlo_quarter_period(orbit) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%quarter_period()
   end function kyvadlo_quarter_period

   real(c_double) function kyvadlo_nome(orbit) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%nome()
   end function kyvadlo_nome

   real(c_double) function kyvadlo_phase_rate(orbit) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%phase_rate()
   end function kyvadlo_phase_rate

   real(c_double) function kyvadlo_azimuth_rate(orbit) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%azimuth_rate()
   end function kyvadlo_azimuth_rate

   real(c_double) function kyvadlo_azimuth_per_period(orbit) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%azimuth_per_period()
   end function kyvadlo_azimuth_per_period

   real(c_double) function kyvadlo_apsidal_advance(orbit) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%apsidal_advance()
   end function kyvadlo_apsidal_advance

   real(c_double) function kyvadlo_apsidal_angle(orbit) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%apsidal_angle()
   end function kyvadlo_apsidal_angle

   real(c_double) function kyvadlo_orbit_energy(orbit) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%energy()
   end function kyvadlo_orbit_energy

   real(c_double) function kyvadlo_orbit_momentum(orbit) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%momentum()
   end function kyvadlo_orbit_momentum

   real(c_double) function kyvadlo_height(orbit, t) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), value :: t
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%height(t)
   end function kyvadlo_height

   real(c_double) function kyvadlo_rise(orbit, t) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), value :: t
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%rise(t)
   end function kyvadlo_rise

   real(c_double) function kyvadlo_top_clearance(orbit, t) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), value :: t
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%gap(t)
   end function kyvadlo_top_clearance

   real(c_double) function kyvadlo_azimuth(orbit, t) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), value :: t
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%azimuth(t)
   end function kyvadlo_azimuth

   real(c_double) function kyvadlo_vertical_speed(orbit, t) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), value :: t
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%vertical_speed(t)
   end function kyvadlo_vertical_speed

   real(c_double) function kyvadlo_azimuthal_speed(orbit, t) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), value :: t
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%azimuthal_speed(t)
   end function kyvadlo_azimuthal_speed

   real(c_double) function kyvadlo_speed(orbit, t) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), value :: t
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%speed(t)
   end function kyvadlo_speed

   real(c_double) function kyvadlo_rod_force(orbit, t) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), value :: t
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%rod_force(t)
   end function kyvadlo_rod_force

   real(c_double) function kyvadlo_time_to_height(orbit, z) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), value :: z
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%time_to_height(z)
   end function kyvadlo_time_to_height

   real(c_double) function kyvadlo_time_to_rise(orbit, rise_there) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), value :: rise_there
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%time_to_rise(rise_there)
   end function kyvadlo_time_to_rise

   real(c_double) function kyvadlo_time_to_azimuth(orbit, phi) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), value :: phi
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%time_to_azimuth(phi)
   end function kyvadlo_time_to_azimuth

   real(c_double) function kyvadlo_next_turning_time(orbit, t) result(y) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), value :: t
      type(orbit_type), pointer :: own

      own => seen(orbit)
      y = quiet_nan
      if (has_seal(orbit) /= 0) y = own%next_turning_time(t)
   end function kyvadlo_next_turning_time

   subroutine kyvadlo_locate(orbit, time, position, velocity) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      real(c_double), value :: time
      real(c_double), intent(out) :: position(3), velocity(3)
      type(orbit_type), pointer :: own

      own => seen(orbit)
      if (has_seal(orbit) /= 0) then
         call own%locate(time, position, velocity)
      else
         position = quiet_nan
         velocity = quiet_nan
      end if
   end subroutine kyvadlo_locate

   !> By the vector kernels, on the caller's thread.
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
      !> `locate` counts in default integers: longer arrays go in pieces.
      integer(c_size_t), parameter :: longest = 2**28
      integer(c_size_t) :: start, last
      type(orbit_type), pointer :: own

      own => seen(orbit)
      if (has_seal(orbit) == 0) then
         positions = quiet_nan
         velocities = quiet_nan
         return
      end if
      do start = 1, count, longest
         last = min(count, start + longest - 1)
         call own%locate(times(start:last), positions(:, start:last), velocities(:, start:last), &
            threads=int(threads))
      end do
   end subroutine kyvadlo_locate_many_threads

   !> Azimuths by the vector kernels and `threads` threads, 0: as many as OpenMP offers.
   subroutine kyvadlo_azimuths(orbit, count, times, azimuths, threads) bind(c)
      type(c_orbit_type), intent(in), target :: orbit
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: times(count)
      real(c_double), intent(out) :: azimuths(count)
      integer(c_int), value :: threads
      integer(c_size_t), parameter :: longest = 2**28
      integer(c_size_t) :: start, last
      type(orbit_type), pointer :: own

      own => seen(orbit)
      if (has_seal(orbit) == 0) then
         azimuths = quiet_nan
         return
      end if
      do start = 1, count, longest
         last = min(count, start + longest - 1)
         call own%azimuths(times(start:last), azimuths(start:last), threads=int(threads))
      end do
   end subroutine kyvadlo_azimuths

end module kyvadlo_c_motion
