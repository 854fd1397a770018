!> Newton's equations of the pendulum in Cartesian coordinates, integrated by Taylor series in quadruple precision. Knows neither
!> an elliptic function nor a constant of the motion: an independent check of the closed form.
!>
!> With the rod force, x'' = -p x, y'' = -p y, z'' = -p z - g, p = (v**2 - g z)/l**2; each Taylor coefficient follows from those
!> before it by products of series.
module newton_series
   use reference_kinds, only: qp => real128
   implicit none
   private
   public :: integrate

   integer, parameter :: order = 44

contains

   !> Moves position and velocity on by `time`, of either sign.
   pure subroutine integrate(length, gravity, position, velocity, time)
      real(qp), intent(in) :: length, gravity
      real(qp), intent(inout) :: position(3), velocity(3)
      real(qp), intent(in) :: time
      real(qp) :: left, step, series(3, 0:order)

      left = time
      do
         call expand(length, gravity, position, velocity, series)
         step = longest_step(series, length)
         if (step >= abs(left)) exit
         step = sign(step, left)
         call evaluate(series, step, position, velocity)
         left = left - step
      end do
      call evaluate(series, left, position, velocity)
   end subroutine integrate

   pure subroutine expand(length, gravity, position, velocity, series)
      real(qp), intent(in) :: length, gravity, position(3), velocity(3)
      real(qp), intent(out) :: series(3, 0:order)
      real(qp) :: rates(3, 0:order), force(0:order), pull(3)
      integer :: k, i

      series(:, 0) = position
      series(:, 1) = velocity
      rates(:, 0) = velocity
      do k = 0, order - 2
         force(k) = -gravity*series(3, k)
         pull = 0
         do i = 0, k
            force(k) = force(k) + dot_product(rates(:, i), rates(:, k - i))
         end do
         force(k) = force(k)/length**2
         do i = 0, k
            pull = pull + force(i)*series(:, k - i)
         end do
         pull = -pull
         if (k == 0) pull(3) = pull(3) - gravity
         series(:, k + 2) = pull/((k + 1)*(k + 2))
         rates(:, k + 1) = (k + 2)*series(:, k + 2)
      end do
   end subroutine expand

   !> So that the last two terms stay below a hundredth of epsilon of the length.
   pure real(qp) function longest_step(series, length)
      real(qp), intent(in) :: series(3, 0:order), length
      integer :: k

      longest_step = huge(1.0_qp)
      do k = order - 1, order
         associate (size => maxval(abs(series(:, k))))
            if (size > 0) longest_step = min(longest_step, (epsilon(1.0_qp)*length/100/size)**(1.0_qp/k))
         end associate
      end do
   end function longest_step

   pure subroutine evaluate(series, step, position, velocity)
      real(qp), intent(in) :: series(3, 0:order), step
      real(qp), intent(out) :: position(3), velocity(3)
      integer :: k

      position = 0
      velocity = 0
      do k = order, 1, -1
         position = (position + series(:, k))*step
         velocity = velocity*step + k*series(:, k)
      end do
      position = position + series(:, 0)
   end subroutine evaluate

end module newton_series
