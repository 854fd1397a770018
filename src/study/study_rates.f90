!> Newton's equations of the spherical pendulum as a user of an integrator would write them, with their Jacobians: in
!> Cartesian coordinates, and in spherical ones with the angular momentum eliminated. For GSL.
module kyvadlo_study_rates
   use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_int, c_int64_t, c_ptr
   implicit none
   private
   public :: problem_type, cartesian_rates, cartesian_jacobian, spherical_rates, spherical_jacobian

   type :: problem_type
      real(c_double) :: length = 1, gravity = 1   !! l [m], g [m/s2]
      real(c_double) :: momentum = 0              !! c2/l**2 [1/s]
      integer(c_int64_t) :: evaluations = 0       !! Of the right side
   end type problem_type

contains

   !> y = x, y, z [m] and their rates [m/s]. The rod's force is what keeps p.p'' + v.v = 0.
   function cartesian_rates(t, y, dydt, params) bind(c, name='') result(status)
      real(c_double), value :: t
      type(c_ptr), value :: y, dydt, params
      integer(c_int) :: status
      real(c_double), pointer :: u(:), du(:)
      type(problem_type), pointer :: problem
      real(c_double) :: pull

      call c_f_pointer(y, u, [6])
      call c_f_pointer(dydt, du, [6])
      call c_f_pointer(params, problem)
      problem%evaluations = problem%evaluations + 1
      pull = (u(4)**2 + u(5)**2 + u(6)**2 - problem%gravity*u(3))/(u(1)**2 + u(2)**2 + u(3)**2)
      du(1:3) = u(4:6)
      du(4) = -pull*u(1)
      du(5) = -pull*u(2)
      du(6) = -pull*u(3) - problem%gravity
      status = 0
      if (t < 0) status = 1 ! The equations do not name the time.
   end function cartesian_rates

   !> Row by row.
   function cartesian_jacobian(t, y, dfdy, dfdt, params) bind(c, name='') result(status)
      real(c_double), value :: t
      type(c_ptr), value :: y, dfdy, dfdt, params
      integer(c_int) :: status
      real(c_double), pointer :: u(:), matrix(:, :), explicit(:)
      type(problem_type), pointer :: problem
      real(c_double) :: square, pull, slope(6)
      integer :: i

      call c_f_pointer(y, u, [6])
      call c_f_pointer(dfdy, matrix, [6, 6])   ! (column, row)
      call c_f_pointer(dfdt, explicit, [6])
      call c_f_pointer(params, problem)
      square = u(1)**2 + u(2)**2 + u(3)**2
      pull = (u(4)**2 + u(5)**2 + u(6)**2 - problem%gravity*u(3))/square
      slope(1:3) = -2*pull*u(1:3)/square
      slope(3) = slope(3) - problem%gravity/square
      slope(4:6) = 2*u(4:6)/square
      matrix = 0
      do i = 1, 3
         matrix(i + 3, i) = 1
         matrix(:, i + 3) = -slope*u(i)
         matrix(i, i + 3) = matrix(i, i + 3) - pull
      end do
      explicit = 0
      status = 0
      if (t < 0) status = 1
   end function cartesian_jacobian

   !> y = angle from the downward vertical, its rate, azimuth: angle'' = (c2/l**2)**2 cos/sin**3 - g/l sin, azimuth' =
   !> c2/(l sin)**2.
   function spherical_rates(t, y, dydt, params) bind(c, name='') result(status)
      real(c_double), value :: t
      type(c_ptr), value :: y, dydt, params
      integer(c_int) :: status
      real(c_double), pointer :: u(:), du(:)
      type(problem_type), pointer :: problem
      real(c_double) :: sine, turn

      call c_f_pointer(y, u, [3])
      call c_f_pointer(dydt, du, [3])
      call c_f_pointer(params, problem)
      problem%evaluations = problem%evaluations + 1
      sine = sin(u(1))
      turn = problem%momentum/sine**2
      du(1) = u(2)
      du(2) = turn**2*sine*cos(u(1)) - problem%gravity/problem%length*sine
      du(3) = turn
      status = 0
      if (t < 0) status = 1
   end function spherical_rates

   !> Row by row.
   function spherical_jacobian(t, y, dfdy, dfdt, params) bind(c, name='') result(status)
      real(c_double), value :: t
      type(c_ptr), value :: y, dfdy, dfdt, params
      integer(c_int) :: status
      real(c_double), pointer :: u(:), matrix(:, :), explicit(:)
      type(problem_type), pointer :: problem
      real(c_double) :: sine, cosine, turn

      call c_f_pointer(y, u, [3])
      call c_f_pointer(dfdy, matrix, [3, 3])   ! (column, row)
      call c_f_pointer(dfdt, explicit, [3])
      call c_f_pointer(params, problem)
      sine = sin(u(1))
      cosine = cos(u(1))
      turn = problem%momentum/sine**2
      matrix = 0
      matrix(2, 1) = 1
      matrix(1, 2) = -turn**2*(sine**2 + 3*cosine**2) - problem%gravity/problem%length*cosine
      matrix(1, 3) = -2*turn*cosine/sine
      explicit = 0
      status = 0
      if (t < 0) status = 1
   end function spherical_jacobian

end module kyvadlo_study_rates
