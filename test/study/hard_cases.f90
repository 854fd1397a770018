!> Random orbits of every hard regime against the library's own quadruple precision, and that against Newton's equations:
!> prints the tables of doc/hard_cases.md.
!>
!>     hard_cases [COUNT [SEED]]      (orbits a regime, 10000 if not given; another seed draws other orbits)
!>
!> Exit status 1 if a promise is broken.
program hard_cases
   use, intrinsic :: iso_fortran_env, only: real32, real64, real128, output_unit, error_unit
   use campaign, only: compare_orbits
   use hard_regimes, only: regimes, measures, promises, promises_of, title_of_regime
   use kyvadlo, only: orbit_type_real128, error_type => kyvadlo_error_type, new_orbit_from_gaps
   use newton_check, only: distance_from_newton
   use study_pages, only: write_machine, number_text
   implicit none

   !> How far the exponents of single precision reach, of those of double precision (37 of 307 decades).
   real(real64), parameter :: single_reach = 0.12_real64
   character(len=32) :: argument
   integer :: count, seed, status
   logical :: broken

   count = 10000
   seed = 1
   status = 0
   if (command_argument_count() > 0) then
      call get_command_argument(1, argument)
      read (argument, *, iostat=status) count
   end if
   if (command_argument_count() > 1 .and. status == 0) then
      call get_command_argument(2, argument)
      read (argument, *, iostat=status) seed
   end if
   if (status /= 0 .or. count < 1 .or. seed < 1) error stop 'usage: hard_cases [COUNT [SEED]]'
   broken = .false.

   call write_machine('cmake --build build/release --target hard_cases_page')
   write (output_unit, '(a, i0, a)') 'Double precision, ', count, ' random orbits a regime, each at two times or more:'
   write (output_unit, '(a)') ''
   call campaign_table(.false.)
   write (output_unit, '(a)') 'Single precision, the same with exponents in proportion to its range:', ''
   call campaign_table(.true.)
   call newton_table()
   if (broken) stop 1, quiet=.true.

contains

   subroutine campaign_table(single)
      logical, intent(in) :: single
      real(real64) :: worst(measures)
      character(len=:), allocatable :: line
      integer :: i, j, refused

      write (output_unit, '(a)') &
         '| regime | T, k'', K, lambda T [ulp] | A [ulp] | position to 1000 T [eps l] | velocity to 1000 T [eps v_max] ' &
         //'| position to 1e9 T [eps l] | velocity to 1e9 T [eps v_max] | azimuth [ulp] | own size [eps] | laws [eps] |', &
         '|---|---|---|---|---|---|---|---|---|---|'
      line = '| *promised* |'
      do j = 1, measures
         line = line//' '//number_text(promises(j))//' |'
      end do
      write (output_unit, '(a)') line
      do i = 1, size(regimes)
         if (single) then
            call compare_orbits(trim(regimes(i)), count, seed, single_reach, 1.0_real32, worst, refused)
         else
            call compare_orbits(trim(regimes(i)), count, seed, 1.0_real64, 1.0_real64, worst, refused)
         end if
         line = '| '//title_of_regime(regimes(i))//' |'
         do j = 1, measures
            line = line//' '//number_text(worst(j))//' |'
         end do
         write (output_unit, '(a)') line
         ! Rounding may put a random start just outside what determines an orbit; more than that would hide a regime.
         if (.not. all(worst <= promises_of(trim(regimes(i)))) .or. refused > count/50) then
            broken = .true.
            write (error_unit, '(a, i0, a)') merge('single: ', 'double: ', single)//line, refused, ' refused'
         end if
      end do
      write (output_unit, '(a)') ''
   end subroutine campaign_table

   subroutine newton_table()
      write (output_unit, '(a)') &
         'Quadruple precision against Newton''s equations by Taylor series: the largest distance at 24 times over three periods,', &
         'positions in units of l, velocities in units of v_max:', '', &
         '| regime | l - z1 | l + z2 | distance | allowed |', '|---|---|---|---|---|'
      call newton_row('typical', 1.2_real128, 0.2_real128)
      call newton_row('typical, c1 > g l', 0.6_real128, 0.5_real128)
      call newton_row('near conical', 1.5_real128, 0.5_real128 - 1e-4_real128)
      call newton_row('near conical', 1.5_real128, 0.5_real128 - 1e-16_real128)
      call newton_row('near plane', 1.3_real128, 1e-10_real128)
      call newton_row('near plane', 1.3_real128, 1e-290_real128)
      call newton_row('near upright', 1e-2_real128, 1e-3_real128)
      call newton_row('near upright', 1e-5_real128, 1e-7_real128)
      call newton_row('near rotation', 1e-9_real128, 1e-9_real128*(1 - 1e-9_real128))
      call newton_row('small', 2 - 1e-4_real128, 1e-5_real128)
      call newton_row('energetic', 0.9_real128, 0.9_real128 - 1e-12_real128)
      write (output_unit, '(a)') ''
   end subroutine newton_table

   !> The integration starts with rounded numbers, and the motion itself makes their error grow: near the top as exp(t sqrt(g/l)),
   !> over all by 1/(k'**2) in a period.
   subroutine newton_row(name, upper_gap, lower_rise)
      character(len=*), intent(in) :: name
      real(real128), intent(in) :: upper_gap, lower_rise
      type(orbit_type_real128) :: orbit
      type(error_type), allocatable :: error
      real(real64) :: distance, allowed

      call new_orbit_from_gaps(orbit, 1.0_real128, 9.80665_real128, upper_gap, lower_rise, error)
      distance = real(distance_from_newton(1.0_real128, 9.80665_real128, upper_gap, lower_rise), real64)
      allowed = real(100*epsilon(1.0_real128)*max(1.0_real128, orbit%complementary_modulus()**(-6)), real64)
      write (output_unit, '(a)') '| '//name//' | '//number_text(real(upper_gap, real64))//' l | ' &
         //number_text(real(lower_rise, real64))//' l | '//number_text(distance)//' | '//number_text(allowed)//' |'
      if (distance <= allowed) return
      broken = .true.
      write (error_unit, '(a)') 'Newton, '//name//': '//number_text(distance)
   end subroutine newton_row

end program hard_cases
