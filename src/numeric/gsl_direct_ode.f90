!> GSL's integrators of ordinary differential equations for the facade kyvadlo_gsl, straight onto libgsl.
module kyvadlo_gsl_ode
   use, intrinsic :: iso_c_binding, only: c_double, c_funloc, c_funptr, c_int, c_long, c_null_funptr, c_null_ptr, &
      c_ptr, c_size_t, c_associated
   implicit none
   private
   public :: fgsl_odeiv2_system, fgsl_odeiv2_system_init, fgsl_odeiv2_system_free
   public :: fgsl_odeiv2_step_type, fgsl_odeiv2_step_rk8pd, fgsl_odeiv2_step_msbdf, fgsl_odeiv2_step_msadams
   public :: fgsl_odeiv2_step_rk4, fgsl_odeiv2_step_rkf45, fgsl_odeiv2_step_bsimp
   public :: fgsl_odeiv2_driver, fgsl_odeiv2_driver_alloc_y_new, fgsl_odeiv2_driver_apply, fgsl_odeiv2_driver_reset
   public :: fgsl_odeiv2_driver_set_nmax, fgsl_odeiv2_driver_set_hmin, fgsl_odeiv2_driver_set_hmax
   public :: fgsl_odeiv2_driver_free
   public :: fgsl_odeiv2_step, fgsl_odeiv2_step_alloc, fgsl_odeiv2_step_apply, fgsl_odeiv2_step_free
   public :: fgsl_odeiv2_control, fgsl_odeiv2_control_scaled_new, fgsl_odeiv2_control_hadjust, fgsl_odeiv2_control_free

   !> C's gsl_odeiv2_system.
   type, bind(c) :: gsl_system_type
      type(c_funptr) :: f = c_null_funptr, jacobian = c_null_funptr
      integer(c_size_t) :: dimension = 0
      type(c_ptr) :: params = c_null_ptr
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

   !> Room for single steps of a method.
   type :: fgsl_odeiv2_step
      private
      type(c_ptr) :: p = c_null_ptr
   end type fgsl_odeiv2_step

   !> The rule by which steps are accepted and their length is chosen.
   type :: fgsl_odeiv2_control
      private
      type(c_ptr) :: p = c_null_ptr
   end type fgsl_odeiv2_control

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
      function gsl_step_alloc(t, dim) bind(c, name='gsl_odeiv2_step_alloc') result(s)
         import :: c_ptr, c_size_t
         type(c_ptr), value :: t
         integer(c_size_t), value :: dim
         type(c_ptr) :: s
      end function gsl_step_alloc
      function gsl_step_apply(s, t, h, y, yerr, dydt_in, dydt_out, sys) bind(c, &
         name='gsl_odeiv2_step_apply') result(status)
         import :: c_double, c_int, c_ptr, gsl_system_type
         type(c_ptr), value :: s
         real(c_double), value :: t, h
         real(c_double), intent(inout) :: y(*), yerr(*), dydt_out(*)
         real(c_double), intent(in) :: dydt_in(*)
         type(gsl_system_type), intent(in) :: sys
         integer(c_int) :: status
      end function gsl_step_apply
      subroutine gsl_step_free(s) bind(c, name='gsl_odeiv2_step_free')
         import :: c_ptr
         type(c_ptr), value :: s
      end subroutine gsl_step_free
      function gsl_control_scaled_new(eps_abs, eps_rel, a_y, a_dydt, scale_abs, dim) &
            bind(c, name='gsl_odeiv2_control_scaled_new') result(c)
         import :: c_double, c_ptr, c_size_t
         real(c_double), value :: eps_abs, eps_rel, a_y, a_dydt
         real(c_double), intent(in) :: scale_abs(*)
         integer(c_size_t), value :: dim
         type(c_ptr) :: c
      end function gsl_control_scaled_new
      function gsl_control_hadjust(c, s, y, yerr, dydt, h) bind(c, name='gsl_odeiv2_control_hadjust') result(change)
         import :: c_double, c_int, c_ptr
         type(c_ptr), value :: c, s
         real(c_double), intent(in) :: y(*), yerr(*), dydt(*)
         real(c_double), intent(inout) :: h
         integer(c_int) :: change
      end function gsl_control_hadjust
      subroutine gsl_control_free(c) bind(c, name='gsl_odeiv2_control_free')
         import :: c_ptr
         type(c_ptr), value :: c
      end subroutine gsl_control_free
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

   !> Room for steps of a system of `dim` equations; free it with fgsl_odeiv2_step_free.
   function fgsl_odeiv2_step_alloc(t, dim) result(s)
      type(fgsl_odeiv2_step_type), intent(in) :: t
      integer(c_size_t), intent(in) :: dim
      type(fgsl_odeiv2_step) :: s
      s%p = gsl_step_alloc(gsl_step(t%which), dim)
   end function fgsl_odeiv2_step_alloc

   !> One step of length h from t: y moves on, yerr estimates its error, dydt_in and dydt_out are the right sides at
   !> both ends.
   function fgsl_odeiv2_step_apply(s, t, h, y, yerr, dydt_in, dydt_out, dydt) result(status)
      type(fgsl_odeiv2_step), intent(in) :: s
      real(c_double), intent(in) :: t, h
      real(c_double), intent(inout), contiguous :: y(:), yerr(:), dydt_out(:)
      real(c_double), intent(in), contiguous :: dydt_in(:)
      type(fgsl_odeiv2_system), intent(in) :: dydt
      integer(c_int) :: status
      status = gsl_step_apply(s%p, t, h, y, yerr, dydt_in, dydt_out, dydt%p)
   end function fgsl_odeiv2_step_apply

   subroutine fgsl_odeiv2_step_free(s)
      type(fgsl_odeiv2_step), intent(inout) :: s
      if (c_associated(s%p)) call gsl_step_free(s%p)
      s%p = c_null_ptr
   end subroutine fgsl_odeiv2_step_free

   !> Keeps the error of component i below eps_abs*scale_abs(i) + eps_rel*(a_y |y| + a_dydt h |dydt|).
   function fgsl_odeiv2_control_scaled_new(eps_abs, eps_rel, a_y, a_dydt, scale_abs) result(c)
      real(c_double), intent(in) :: eps_abs, eps_rel, a_y, a_dydt
      real(c_double), intent(in), contiguous :: scale_abs(:)
      type(fgsl_odeiv2_control) :: c
      c%p = gsl_control_scaled_new(eps_abs, eps_rel, a_y, a_dydt, scale_abs, size(scale_abs, kind=c_size_t))
   end function fgsl_odeiv2_control_scaled_new

   !> Changes h to what the error of the last step calls for: 1 longer, 0 as it is, -1 shorter, the step is to be
   !> repeated.
   function fgsl_odeiv2_control_hadjust(c, s, y, yerr, dydt, h) result(change)
      type(fgsl_odeiv2_control), intent(in) :: c
      type(fgsl_odeiv2_step), intent(in) :: s
      real(c_double), intent(in), contiguous :: y(:), yerr(:), dydt(:)
      real(c_double), intent(inout) :: h
      integer(c_int) :: change
      change = gsl_control_hadjust(c%p, s%p, y, yerr, dydt, h)
   end function fgsl_odeiv2_control_hadjust

   subroutine fgsl_odeiv2_control_free(c)
      type(fgsl_odeiv2_control), intent(inout) :: c
      if (c_associated(c%p)) call gsl_control_free(c%p)
      c%p = c_null_ptr
   end subroutine fgsl_odeiv2_control_free

end module kyvadlo_gsl_ode
