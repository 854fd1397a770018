!> The motion between the steps of an integration: the polynomial of degree 14 through the places, velocities and
!> accelerations at the ends of the last four steps. It costs no evaluation of the forces.
!>
!> Its error in the newest interval is 3.6**3 h**15 p''''.../15! for equal steps h, below that of a step of order 8
!> where the steps are chosen by their error; what it is for a given motion tells the acceleration that it misses (see
!> `defect_point`).
module kyvadlo_dense_output
   use kyvadlo_kinds, only: wp => real64
   implicit none
   private
   public :: interpolant_type, nodes, clear, add_node, prepare, interpolate, defect_point, defect_to_position, &
      defect_to_velocity

   !> Ends of steps.
   integer, parameter :: nodes = 5
   integer, parameter :: degree = 3*nodes - 1

   !> Of the last step, from its end: where w = (x + 4)(x + 3)(x + 2)(x + 1)x, x = 0 at the end, is largest for equal
   !> steps. The error of the place there is C w**3, that of the acceleration C*3*w**2*w'' = -32 of it, and the largest
   !> of the velocity 3.7 of it: a missing acceleration a means errors of a h**2/32 and a h*3.7/32.
   real(wp), parameter :: defect_point = -0.356_wp
   real(wp), parameter :: defect_to_position = 1/32.0_wp, defect_to_velocity = 3.7_wp/32

   type :: interpolant_type
      integer :: count = 0                          !! Ends known, the newest first
      real(wp) :: time(nodes) = 0                   !! [s]
      real(wp) :: position(3, nodes) = 0, velocity(3, nodes) = 0, acceleration(3, nodes) = 0
      real(wp) :: step = 0                          !! The newest [s]
      real(wp) :: place(nodes) = 0                  !! (time - time(1))/step
      real(wp) :: difference(3, 0:degree) = 0       !! Newton's divided differences, every node three times
   end type interpolant_type

contains

   pure subroutine clear(interpolant)
      type(interpolant_type), intent(inout) :: interpolant

      interpolant%count = 0
   end subroutine clear

   pure subroutine add_node(interpolant, time, position, velocity, acceleration)
      type(interpolant_type), intent(inout) :: interpolant
      real(wp), intent(in) :: time, position(3), velocity(3), acceleration(3)
      integer :: k

      do k = min(interpolant%count, nodes - 1), 1, -1
         interpolant%time(k + 1) = interpolant%time(k)
         interpolant%position(:, k + 1) = interpolant%position(:, k)
         interpolant%velocity(:, k + 1) = interpolant%velocity(:, k)
         interpolant%acceleration(:, k + 1) = interpolant%acceleration(:, k)
      end do
      interpolant%count = min(interpolant%count + 1, nodes)
      interpolant%time(1) = time
      interpolant%position(:, 1) = position
      interpolant%velocity(:, 1) = velocity
      interpolant%acceleration(:, 1) = acceleration
   end subroutine add_node

   !> The divided differences, once `nodes` ends are known; before, nothing.
   pure subroutine prepare(interpolant)
      type(interpolant_type), intent(inout) :: interpolant
      real(wp) :: inverse(nodes, nodes)
      integer :: i, j, k, m

      if (interpolant%count < nodes) return
      associate (c => interpolant%difference, x => interpolant%place)
         interpolant%step = interpolant%time(1) - interpolant%time(2)
         x = (interpolant%time - interpolant%time(1))/interpolant%step
         do k = 1, nodes
            do m = 1, k - 1
               inverse(m, k) = 1/(x(k) - x(m))
            end do
            c(:, 3*k - 3) = interpolant%position(:, k)
            c(:, 3*k - 2) = interpolant%position(:, k)
            c(:, 3*k - 1) = interpolant%position(:, k)
         end do
         do j = 1, degree
            do i = degree, j, -1
               k = node_of(i)
               m = node_of(i - j)
               if (k /= m) then
                  c(:, i) = (c(:, i) - c(:, i - 1))*inverse(m, k)
               else if (j == 1) then
                  c(:, i) = interpolant%velocity(:, k)*interpolant%step
               else
                  c(:, i) = interpolant%acceleration(:, k)*(interpolant%step**2/2)
               end if
            end do
         end do
      end associate
   end subroutine prepare

   elemental integer function node_of(row)
      integer, intent(in) :: row
      integer, parameter :: node(0:degree) = [1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5]

      node_of = node(row)
   end function node_of

   !> The motion at a time in the last step, after `prepare`.
   pure subroutine interpolate(interpolant, time, position, velocity, acceleration)
      type(interpolant_type), intent(in) :: interpolant
      real(wp), intent(in) :: time
      real(wp), intent(out) :: position(3), velocity(3)
      real(wp), intent(out), optional :: acceleration(3)
      real(wp) :: x, away, bend(3)
      integer :: i

      x = (time - interpolant%time(1))/interpolant%step
      position = interpolant%difference(:, degree)
      velocity = 0
      if (present(acceleration)) then
         bend = 0
         do i = degree - 1, 0, -1
            away = x - interpolant%place(node_of(i))
            bend = bend*away + 2*velocity
            velocity = velocity*away + position
            position = position*away + interpolant%difference(:, i)
         end do
         acceleration = bend/interpolant%step**2
      else
         do i = degree - 1, 0, -1
            away = x - interpolant%place(node_of(i))
            velocity = velocity*away + position
            position = position*away + interpolant%difference(:, i)
         end do
      end if
      velocity = velocity/interpolant%step
   end subroutine interpolate

end module kyvadlo_dense_output
