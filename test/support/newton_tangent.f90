!> Newton's equations of the pendulum and their linearisation by Taylor series in quadruple precision: how a small
!> change of the start travels. Knows neither an elliptic function nor a constant of the motion.
!>
!> x'' = -p x - g e, p = (v**2 - g z)/l**2; its change y: y'' = -p y - r x, r = (2 v.y' - g y_z)/l**2.
module newton_tangent
   use reference_kinds, only: qp => real128
   implicit none
   private
   public :: integrate_tangent, put_on_sphere

   !> A step's series ends where it has this precision: ten digits beyond those of the doubles that are compared.
   integer, parameter :: order = 26
   real(qp), parameter :: precision = 1e-26_qp

contains

   !> The start put on the sphere and its velocity in the tangent plane, and what a change of the six numbers makes of
   !> them.
   pure subroutine put_on_sphere(length, state, tangent)
      real(qp), intent(in) :: length
      real(qp), intent(inout) :: state(6), tangent(6)
      real(qp) :: x(3), v(3), a(3), b(3), square, radial, radial_change

      x = state(:3)
      v = state(4:)
      a = tangent(:3)
      b = tangent(4:)
      square = dot_product(x, x)
      radial = dot_product(x, v)/square
      radial_change = (dot_product(a, v) + dot_product(x, b))/square - 2*radial*dot_product(x, a)/square
      state(:3) = length*x/sqrt(square)
      state(4:) = v - radial*x
      tangent(:3) = length/sqrt(square)*(a - dot_product(x, a)/square*x)
      tangent(4:) = b - radial_change*x - radial*a
   end subroutine put_on_sphere

   !> Moves the state and its change on by `time`, of either sign.
   pure subroutine integrate_tangent(length, gravity, state, tangent, time)
      real(qp), intent(in) :: length, gravity
      real(qp), intent(inout) :: state(6), tangent(6)
      real(qp), intent(in) :: time
      real(qp) :: left, step, x(3, 0:order), y(3, 0:order)
      integer :: k

      left = time
      do while (abs(left) > 0)
         call expand(length, gravity, state, tangent, x, y)
         step = abs(left)
         do k = order - 1, order
            step = min(step, (precision*length/(maxval(abs(x(:, k))) + tiny(step)))**(1.0_qp/k))
            step = min(step, (precision*maxval(abs(tangent))/(maxval(abs(y(:, k))) + tiny(step)))**(1.0_qp/k))
         end do
         step = sign(step, left)
         call sum_series(x, step, state)
         call sum_series(y, step, tangent)
         left = left - step
      end do
   end subroutine integrate_tangent

   pure subroutine expand(length, gravity, state, tangent, x, y)
      real(qp), intent(in) :: length, gravity, state(6), tangent(6)
      real(qp), intent(out) :: x(3, 0:order), y(3, 0:order)
      real(qp) :: v(3, 0:order), w(3, 0:order), force(0:order), change(0:order), pull(3), pull_change(3)
      integer :: k, i

      x(:, 0) = state(:3)
      x(:, 1) = state(4:)
      y(:, 0) = tangent(:3)
      y(:, 1) = tangent(4:)
      do k = 0, order - 2
         v(:, k) = (k + 1)*x(:, k + 1)
         w(:, k) = (k + 1)*y(:, k + 1)
         force(k) = -gravity*x(3, k)
         change(k) = -gravity*y(3, k)
         do i = 0, k
            force(k) = force(k) + dot_product(v(:, i), v(:, k - i))
            change(k) = change(k) + 2*dot_product(v(:, i), w(:, k - i))
         end do
         force(k) = force(k)/length**2
         change(k) = change(k)/length**2
         pull = 0
         pull_change = 0
         do i = 0, k
            pull = pull - force(i)*x(:, k - i)
            pull_change = pull_change - force(i)*y(:, k - i) - change(i)*x(:, k - i)
         end do
         if (k == 0) pull(3) = pull(3) - gravity
         x(:, k + 2) = pull/((k + 1)*(k + 2))
         y(:, k + 2) = pull_change/((k + 1)*(k + 2))
      end do
   end subroutine expand

   pure subroutine sum_series(series, step, state)
      real(qp), intent(in) :: series(3, 0:order), step
      real(qp), intent(out) :: state(6)
      integer :: k

      state = 0
      do k = order, 1, -1
         state(:3) = (state(:3) + series(:, k))*step
         state(4:) = state(4:)*step + k*series(:, k)
      end do
      state(:3) = state(:3) + series(:, 0)
   end subroutine sum_series
end module newton_tangent
