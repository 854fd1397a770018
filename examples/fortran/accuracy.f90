!> One orbit over 1000 s, about 900 periods, to the accuracy asked for: which way of computing keeps it at the least cost?
program accuracy
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo, only: accurate_orbit_type, kyvadlo_error_type, new_orbit_to_accuracy, start_heights
   implicit none
   real(real64), parameter :: wanted(6) = [1e-3_real64, 1e-6_real64, 1e-9_real64, 1e-12_real64, 1e-15_real64, 1e-20_real64]
   real(real64), parameter :: length = 1.0_real64, gravity = 9.80665_real64, upper = 0.3_real64, lower = -0.8_real64
   real(real64), parameter :: span = 1000.0_real64  ! [s], before t = 0 and after
   type(accurate_orbit_type) :: orbit
   type(kyvadlo_error_type), allocatable :: error
   real(real64) :: time(1000), x(1000), y(1000), z(1000)
   integer :: i

   time = [(span*i/1000, i=1, 1000)]
   do i = 1, size(wanted)
      call new_orbit_to_accuracy(orbit, start_heights, length, gravity, [upper], [lower], wanted(i), span, error)
      if (allocated(error)) error stop error%message
      call orbit%locate(time, x, y, z)
      print '(es8.0, 2x, a)', wanted(i), trim(orbit%choice_text())
   end do
end program accuracy
