!> Does this build work? Values in three kinds, an orbit, arrays. The tests of the digits are pFUnit files, which fpm cannot run.
program smoke
   use, intrinsic :: iso_fortran_env, only: real32, real64, real128
   use kyvadlo, only: elliptic_k, kyvadlo_error_type, new_orbit_from_heights, orbit_type, orbit_type_real128
   implicit none
   type(orbit_type) :: orbit
   type(orbit_type_real128) :: wide
   real(real128) :: exact(3)
   type(kyvadlo_error_type), allocatable :: error
   real(real64) :: time(1000), position(3, 1000), velocity(3, 1000)
   integer :: i

   ! Gauss's lemniscate constant (DLMF 19.20.2): K(1/2) = 1.85407 46773 01371 91843 38503 47195 26005 for its parameter 1/2
   call check('K(1/2) in real32', real(elliptic_k(0.5_real32), real64), 1.8540746773013719_real64, 1e-6_real64)
   call check('K(1/2) in real64', elliptic_k(0.5_real64), 1.8540746773013719_real64, 1e-15_real64)
   call check('K(1/2) in real128', real(elliptic_k(0.5_real128) - 1.85407467730137191843385034719526005_real128, real64), &
      0.0_real64, 1e-32_real64)

   call new_orbit_from_heights(orbit, 1.0_real64, 9.80665_real64, 0.3_real64, -0.8_real64, error)
   if (allocated(error)) error stop 'no orbit'
   ! Quadrature of dz/sqrt(2 g/l**2 (z1 - z)(z - z2)(z3 - z)) by mpmath
   call check('period', orbit%period(), 1.08679328201239380702_real64, 1e-14_real64)
   time = [(0.01_real64*i, i = 1, size(time))]
   call orbit%locate(time, position, velocity)
   do i = 1, size(time)
      call check('on the sphere', sum(position(:, i)**2), 1.0_real64, 1e-14_real64)
      call check('energy', sum(velocity(:, i)**2)/2 + 9.80665_real64*position(3, i), orbit%energy(), 1e-13_real64)
      call check('momentum', position(1, i)*velocity(2, i) - position(2, i)*velocity(1, i), orbit%momentum(), 1e-13_real64)
   end do

   ! A place after a thousand million periods: of no use unless T is kept in two parts, which flags could spoil.
   call new_orbit_from_heights(wide, 1.0_real128, real(9.80665_real64, real128), real(0.3_real64, real128), &
      real(-0.8_real64, real128), error)
   do i = 1, size(time)
      time(i) = (1e9_real64 + i/7.0_real64)*orbit%period()
      call orbit%locate(time(i), position(:, i))
      call wide%locate(real(time(i), real128), exact)
      call check('place after 1e9 periods', maxval(abs(position(:, i) - real(exact, real64))), 0.0_real64, 4e-15_real64)
   end do

   call new_orbit_from_heights(orbit, 1.0_real64, 9.80665_real64, 0.8_real64, 0.3_real64, error)
   if (.not. allocated(error)) error stop 'an impossible orbit was accepted'
   print '(a)', 'kyvadlo works'

contains

   subroutine check(what, got, want, tolerance)
      character(len=*), intent(in) :: what
      real(real64), intent(in) :: got, want, tolerance

      if (abs(got - want) <= tolerance) return
      print '(2a, 2es25.17)', what, ': got, want', got, want
      error stop 'kyvadlo does not work'
   end subroutine check
end program smoke
