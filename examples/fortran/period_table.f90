!> The period of a pendulum of 1 m, for some upper and lower turning heights.
program period_table
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo, only: orbit_period_from_gaps
   implicit none
   real(wp), parameter :: lower_rise(5) = [0.1_wp, 0.2_wp, 0.3_wp, 0.4_wp, 0.5_wp]
   integer :: i
   print '(a, 5f11.1)', ' upper\lower', lower_rise - 1
   do i = -4, 4
      print '(f12.1, 5f11.7)', 0.1_wp*i, orbit_period_from_gaps(1.0_wp, 9.80665_wp, 1 - 0.1_wp*i, lower_rise)
   end do
end program period_table
