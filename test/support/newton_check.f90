!> The closed form beside Newton's equations, in quadruple precision.
module newton_check
   use reference_kinds, only: qp => real128
   use kyvadlo, error_type => kyvadlo_error_type
   use newton_series, only: integrate
   implicit none
   private
   public :: distance_from_newton

contains

   !> Worst distance of `locate` at 24 times over three periods, started at the upper turning point: positions in units of
   !> the length, velocities in units of the largest speed.
   real(qp) function distance_from_newton(length, gravity, upper_gap, lower_rise) result(worst)
      real(qp), intent(in) :: length, gravity
      real(qp), intent(in) :: upper_gap, lower_rise  !! l - z1, l + z2
      type(orbit_type_real128) :: orbit
      type(error_type), allocatable :: error
      real(qp), dimension(3) :: position, velocity, there, moving
      real(qp) :: radius, fastest, step
      integer :: i

      call new_orbit_from_gaps(orbit, length, gravity, upper_gap, lower_rise, error)
      if (allocated(error)) error stop 'distance_from_newton: no orbit'
      associate (h1 => upper_gap, d2 => lower_rise, d1 => 2*length - upper_gap, h2 => 2*length - lower_rise)
         ! (9): c2**2 = 2 g d1 d2 h1 h2/s, s = h1 - d2; the largest speed from the energy
         radius = sqrt(d1*h1)
         position = [radius, 0.0_qp, merge(d1 - length, length - h1, d1 < h1)]
         velocity = [0.0_qp, sqrt(2*gravity*d2*h2/(h1 - d2)), 0.0_qp]
         fastest = sqrt(velocity(2)**2 + 2*gravity*((d1 - d2)))
      end associate
      worst = 0
      step = orbit%period()/8
      do i = 1, 24
         call integrate(length, gravity, position, velocity, step)
         call orbit%locate(i*step, there, moving)
         worst = larger(worst, norm2(position - there)/length)
         worst = larger(worst, norm2(velocity - moving)/fastest)
      end do
   end function distance_from_newton

   !> NaN is the largest.
   real(qp) function larger(x, y)
      real(qp), intent(in) :: x, y

      larger = y
      if (y <= x) larger = x
      if (.not. x <= huge(x)) larger = x
   end function larger

end module newton_check
