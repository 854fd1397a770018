!> A spherical pendulum by Taylor series of Newton's equations in Cartesian coordinates, the constraint written out. It
!> shares no code with kyvadlo: `fit_campaign` makes its data with it, and derivatives by quotients of differences.
module taylor_motion
   use, intrinsic :: iso_fortran_env, only: wp => real64
   implicit none
   private
   public :: pendulum_type, states_at, crossings

   type :: pendulum_type
      real(wp) :: length = 1, gravity = 1, linear = 0    !! Drag per mass and speed [1/s]
      real(wp) :: turn(3) = 0                            !! Of the ground [rad/s]
   end type pendulum_type

   integer, parameter :: order = 24
   !> The last two terms of a step are below this part of the length: their sum's error is far below any noise.
   real(wp), parameter :: tolerance = 1e-15_wp

contains

   !> States at ascending times >= 0.
   subroutine states_at(pendulum, start, times, states)
      type(pendulum_type), intent(in) :: pendulum
      real(wp), intent(in) :: start(6), times(:)
      real(wp), intent(out) :: states(:, :)              !! (6, n)
      real(wp) :: s(6), c(6, 0:order), t, h
      integer :: i

      s = start
      t = 0
      i = 1
      do while (i <= size(times))
         call expand(pendulum, s, c, h)
         do while (i <= size(times))
            if (times(i) > t + h) exit
            states(:, i) = summed(c, times(i) - t)
            i = i + 1
         end do
         call step_on(pendulum, c, h, s)
         t = t + h
      end do
   end subroutine states_at

   !> The first times > 0 at which x = 0.
   subroutine crossings(pendulum, start, times)
      type(pendulum_type), intent(in) :: pendulum
      real(wp), intent(in) :: start(6)
      real(wp), intent(out) :: times(:)
      real(wp) :: s(6), c(6, 0:order), t, h, low(6), high(6), a, b
      integer :: i, k, pass
      integer, parameter :: parts = 4                    !! No step has two crossings in a quarter

      s = start
      t = 0
      i = 1
      do while (i <= size(times))
         call expand(pendulum, s, c, h)
         do k = 1, parts
            low = summed(c, h*(k - 1)/parts)
            high = summed(c, h*k/parts)
            if (low(1)*high(1) > 0 .or. i > size(times)) cycle
            a = h*(k - 0.5_wp)/parts
            do pass = 1, 30
               high = summed(c, a)
               b = -high(1)/high(4)
               a = a + b
               if (abs(b) < 1e-15_wp*h) exit
            end do
            times(i) = t + a
            i = i + 1
         end do
         call step_on(pendulum, c, h, s)
         t = t + h
      end do
   end subroutine crossings

   !> The end of a step, put back on the sphere: rounding grows where a rod pushes.
   pure subroutine step_on(pendulum, c, h, s)
      type(pendulum_type), intent(in) :: pendulum
      real(wp), intent(in) :: c(6, 0:order), h
      real(wp), intent(out) :: s(6)

      s = summed(c, h)
      s(1:3) = s(1:3)*pendulum%length/norm2(s(1:3))
      s(4:6) = s(4:6) - dot_product(s(1:3), s(4:6))/pendulum%length**2*s(1:3)
   end subroutine step_on

   pure function summed(c, h) result(s)
      real(wp), intent(in) :: c(6, 0:order), h
      real(wp) :: s(6)
      integer :: k

      s = c(:, order)
      do k = order - 1, 0, -1
         s = s*h + c(:, k)
      end do
   end function summed

   !> Coefficients of position and velocity, and how far they reach. r'' = a - q r, q = (r.a + v.v)/l**2.
   pure subroutine expand(pendulum, s, c, h)
      type(pendulum_type), intent(in) :: pendulum
      real(wp), intent(in) :: s(6)
      real(wp), intent(out) :: c(6, 0:order), h
      real(wp) :: a(3, 0:order), q(0:order), qr(3)
      integer :: k, n

      c(:, 0) = s
      do n = 0, order - 1
         associate (w => pendulum%turn, v => c(4:6, n))
            a(:, n) = -pendulum%linear*v - 2*[w(2)*v(3) - w(3)*v(2), w(3)*v(1) - w(1)*v(3), w(1)*v(2) - w(2)*v(1)]
         end associate
         if (n == 0) a(3, 0) = a(3, 0) - pendulum%gravity
         q(n) = 0
         do k = 0, n
            q(n) = q(n) + dot_product(c(1:3, k), a(:, n - k)) + dot_product(c(4:6, k), c(4:6, n - k))
         end do
         q(n) = q(n)/pendulum%length**2
         qr = 0
         do k = 0, n
            qr = qr + q(k)*c(1:3, n - k)
         end do
         c(4:6, n + 1) = (a(:, n) - qr)/(n + 1)
         c(1:3, n + 1) = c(4:6, n)/(n + 1)
      end do
      h = min((tolerance*pendulum%length/norm2(c(1:3, order)))**(1.0_wp/order), &
         (tolerance*pendulum%length/norm2(c(1:3, order - 1)))**(1.0_wp/(order - 1)))
   end subroutine expand

end module taylor_motion
