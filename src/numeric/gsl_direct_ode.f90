!> GSL's integrators of ordinary differential equations for the facade kyvadlo_gsl, straight onto libgsl.
module kyvadlo_gsl_ode
   use, intrinsic :: iso_c_binding, only: c_double, c_funloc, c_funptr, c_int, c_long, c_null_funptr, c_null_ptr, c_ptr, &
      c_size_t, c_associated
   implicit none
   private
   public :: fgsl_odeiv2_system, fgsl_odeiv2_system_init, fgsl_odeiv2_system_free
   public :: fgsl_odeiv2_step_type, fgsl_odeiv2_step_rk8pd, fgsl_odeiv2_step_msbdf, fgsl_odeiv2_step_msadams
   public :: fgsl_odeiv2_step_rk4, fgsl_odeiv2_step_rkf45, fgsl_odeiv2_step_bsimp
   public :: fgsl_odeiv2_driver, fgsl_odeiv2_driver_alloc_y_new, fgsl_odeiv2_driver_apply, fgsl_odeiv2_driver_reset
   public :: fgsl_odeiv2_driver_set_nmax, fgsl_odeiv2_driver_set_hmin, fgsl_odeiv2_driver_set_hmax
   public :: fgsl_odeiv2_driver_free

   !> C's gsl_odeiv2_system.
   type, bind(c) :: gsl_system_type
      type(c_funptr) :: f, jacobian
      integer(c_size_t) :: dimension
      type(c_ptr) :: params
   end type gsl_system_type

   !> The equations: right side, Jacobian, dimension and what they are called with.
   type :: fgsl_odeiv2_system
      private
      type(gsl_system_type), pointer :: p => null()
   end type fgsl_odeiv2_system

   !> A method; gsl_steps.c knows what the numbers stand for.
   type :: fgsl_odeiv2_step_type
      private
      integer(c_int) :: which = 0
   end type fgsl_odeiv2_step_type
   type(fgsl_odeiv2_step_type), parameter :: fgsl_odeiv2_step_rk8pd = fgsl_odeiv2_step_type(1)
   type(fgsl_odeiv2_step_type), parameter :: fgsl_odeiv2_step_msbdf = fgsl_odeiv2_step_type(2)
   type(fgsl_odeiv2_step_type), parameter :: fgsl_odeiv2_step_msadams = fgsl_odeiv2_step_type(3)
   type(fgsl_odeiv2_step_type), parameter :: fgsl_odeiv2_step_rk4 = fgsl_odeiv2_step_type(4)
   type(fgsl_odeiv2_step_type), parameter :: fgsl_odeiv2_step_rkf45 = fgsl_odeiv2_step_type(5)
   !> Bulirsch and Stoer's with Bader and Deuflhard's implicit midpoint rule: needs the Jacobian.
   type(fgsl_odeiv2_step_type), parameter :: fgsl_odeiv2_step_bsimp = fgsl_odeiv2_step_type(6)

   !> An integration in progress.
   type :: fgsl_odeiv2_driver
      private
      type(c_ptr) :: p = c_null_ptr
   end type fgsl_odeiv2_driver

   abstract interface
      !> dy/dt at time t. Must be a module procedure: an internal one would need an executable stack.
      function right_side(t, y, dydt, params) bind(c) result(status)
         import :: c_double, c_int, c_ptr
         real(c_double), value :: t
         type(c_ptr), value :: y, dydt, params
         integer(c_int) :: status
      end function right_side
      !> Its derivatives, dfdy row by row.
      function jacobian_matrix(t, y, dfdy, dfdt, params) bind(c) result(status)
         import :: c_double, c_int, c_ptr
         real(c_double), value :: t
         type(c_ptr), value :: y, dfdy, dfdt, params
         integer(c_int) :: status
      end function jacobian_matrix
   end interface

   interface
      function gsl_step(which) bind(c, name='kyvadlo_gsl_step') result(step)
         import :: c_int, c_ptr
         integer(c_int), value :: which
         type(c_ptr) :: step
      end function gsl_step
      function gsl_driver_new(sys, t, hstart, epsabs, epsrel) bind(c, name='gsl_odeiv2_driver_alloc_y_new') result(d)
         import :: c_double, c_ptr, gsl_system_type
         type(gsl_system_type), intent(in) :: sys
         type(c_ptr), value :: t
         real(c_double), value :: hstart, epsabs, epsrel
         type(c_ptr) :: d
      end function gsl_driver_new
      function gsl_driver_apply(d, t, t1, y) bind(c, name='gsl_odeiv2_driver_apply') result(status)
         import :: c_double, c_int, c_ptr
         type(c_ptr), value :: d
         real(c_double), intent(inout) :: t, y(*)
         real(c_double), value :: t1
         integer(c_int) :: status
      end function gsl_driver_apply
      function gsl_driver_set_nmax(d, n) bind(c, name='gsl_odeiv2_driver_set_nmax') result(status)
         import :: c_int, c_long, c_ptr
         type(c_ptr), value :: d
         integer(c_long), value :: n
         integer(c_int) :: status
      end function gsl_driver_set_nmax
      function gsl_driver_set_hmin(d, h) bind(c, name='gsl_odeiv2_driver_set_hmin') result(status)
         import :: c_double, c_int, c_ptr
         type(c_ptr), value :: d
         real(c_double), value :: h
         integer(c_int) :: status
      end function gsl_driver_set_hmin
      function gsl_driver_set_hmax(d, h) bind(c, name='gsl_odeiv2_driver_set_hmax') result(status)
         import :: c_double, c_int, c_ptr
         type(c_ptr), value :: d
         real(c_double), value :: h
         integer(c_int) :: status
      end function gsl_driver_set_hmax
      function gsl_driver_reset(d) bind(c, name='gsl_odeiv2_driver_reset') result(status)
         import :: c_int, c_ptr
         type(c_ptr), value :: d
         integer(c_int) :: status
      end function gsl_driver_reset
      subroutine gsl_driver_free(d) bind(c, name='gsl_odeiv2_driver_free')
         import :: c_ptr
         type(c_ptr), value :: d
      end subroutine gsl_driver_free
   end interface

contains

   !> A system of `dimension` equations; free it with fgsl_odeiv2_system_free, after its drivers.
   function fgsl_odeiv2_system_init(func, dimension, params, jacobian) result(system)
      procedure(right_side) :: func
      integer(c_size_t), intent(in) :: dimension
      type(c_ptr), intent(in), optional :: params           !! Handed to func and jacobian
      procedure(jacobian_matrix), optional :: jacobian      !! The implicit methods need it
      type(fgsl_odeiv2_system) :: system

      allocate (system%p)
      system%p = gsl_system_type(c_funloc(func), c_null_funptr, dimension, c_null_ptr)
      if (present(params)) system%p%params = params
      if (present(jacobian)) system%p%jacobian = c_funloc(jacobian)
   end function fgsl_odeiv2_system_init

   subroutine fgsl_odeiv2_system_free(system)
      type(fgsl_odeiv2_system), intent(inout) :: system
      if (associated(system%p)) deallocate (system%p)
   end subroutine fgsl_odeiv2_system_free

   !> A driver with bounds on the error of each component of y; free it with fgsl_odeiv2_driver_free.
   function fgsl_odeiv2_driver_alloc_y_new(sys, t, hstart, epsabs, epsrel) result(d)
      type(fgsl_odeiv2_system), intent(in) :: sys
      type(fgsl_odeiv2_step_type), intent(in) :: t
      real(c_double), intent(in) :: hstart, epsabs, epsrel
      type(fgsl_odeiv2_driver) :: d
      d%p = gsl_driver_new(sys%p, gsl_step(t%which), hstart, epsabs, epsrel)
   end function fgsl_odeiv2_driver_alloc_y_new

   !> Carries y from t to t1.
   function fgsl_odeiv2_driver_apply(d, t, t1, y) result(status)
      type(fgsl_odeiv2_driver), intent(inout) :: d
      real(c_double), intent(inout) :: t
      real(c_double), intent(in) :: t1
      real(c_double), intent(inout) :: y(:)
      integer(c_int) :: status
      status = gsl_driver_apply(d%p, t, t1, y)
   end function fgsl_odeiv2_driver_apply

   !> At most nmax steps in each call of fgsl_odeiv2_driver_apply.
   function fgsl_odeiv2_driver_set_nmax(d, nmax) result(status)
      type(fgsl_odeiv2_driver), intent(inout) :: d
      integer(c_long), intent(in) :: nmax
      integer(c_int) :: status
      status = gsl_driver_set_nmax(d%p, nmax)
   end function fgsl_odeiv2_driver_set_nmax

   !> No step shorter than hmin.
   function fgsl_odeiv2_driver_set_hmin(d, hmin) result(status)
      type(fgsl_odeiv2_driver), intent(inout) :: d
      real(c_double), intent(in) :: hmin
      integer(c_int) :: status
      status = gsl_driver_set_hmin(d%p, hmin)
   end function fgsl_odeiv2_driver_set_hmin

   !> No step longer than hmax.
   function fgsl_odeiv2_driver_set_hmax(d, hmax) result(status)
      type(fgsl_odeiv2_driver), intent(inout) :: d
      real(c_double), intent(in) :: hmax
      integer(c_int) :: status
      status = gsl_driver_set_hmax(d%p, hmax)
   end function fgsl_odeiv2_driver_set_hmax

   !> Forgets the steps taken: for a new start with the same equations.
   function fgsl_odeiv2_driver_reset(d) result(status)
      type(fgsl_odeiv2_driver), intent(inout) :: d
      integer(c_int) :: status
      status = gsl_driver_reset(d%p)
   end function fgsl_odeiv2_driver_reset

   subroutine fgsl_odeiv2_driver_free(d)
      type(fgsl_odeiv2_driver), intent(inout) :: d
      if (c_associated(d%p)) call gsl_driver_free(d%p)
      d%p = c_null_ptr
   end subroutine fgsl_odeiv2_driver_free

end module kyvadlo_gsl_ode
