!> GSL's quadrature for the facade kyvadlo_gsl, straight onto libgsl.
module kyvadlo_gsl_quadrature
   use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_funloc, c_funptr, c_int, c_null_funptr, &
      c_null_ptr, c_ptr, c_size_t
   implicit none
   private
   public :: fgsl_function, fgsl_function_init, fgsl_function_free
   public :: fgsl_integration_workspace, fgsl_integration_workspace_alloc, fgsl_integration_workspace_free
   public :: fgsl_integration_qag, fgsl_integ_gauss15, fgsl_integ_gauss61
   public :: fgsl_integration_cquad_workspace, fgsl_integration_cquad_workspace_alloc
   public :: fgsl_integration_cquad_workspace_free, fgsl_integration_cquad
   public :: fgsl_integration_glfixed_table, fgsl_integration_glfixed_table_alloc, fgsl_integration_glfixed_table_free
   public :: fgsl_integration_glfixed, fgsl_integration_glfixed_point

   !> The 15-point and the 61-point Gauss-Kronrod rule for fgsl_integration_qag.
   integer(c_int), parameter :: fgsl_integ_gauss15 = 1, fgsl_integ_gauss61 = 6

   !> C's gsl_function.
   type, bind(c) :: gsl_function_type
      type(c_funptr) :: f = c_null_funptr
      type(c_ptr) :: params = c_null_ptr
   end type gsl_function_type

   !> An integrand and what it is called with.
   type :: fgsl_function
      private
      type(gsl_function_type), pointer :: p => null()
   end type fgsl_function

   type :: fgsl_integration_workspace
      private
      type(c_ptr) :: p = c_null_ptr
   end type fgsl_integration_workspace

   type :: fgsl_integration_cquad_workspace
      private
      type(c_ptr) :: p = c_null_ptr
   end type fgsl_integration_cquad_workspace

   !> Nodes and weights of a Gauss-Legendre rule.
   type :: fgsl_integration_glfixed_table
      private
      type(c_ptr) :: p = c_null_ptr
   end type fgsl_integration_glfixed_table

   abstract interface
      !> Must be a module procedure: an internal one would need an executable stack.
      function integrand(x, params) bind(c) result(value)
         import :: c_double, c_ptr
         real(c_double), value :: x
         type(c_ptr), value :: params
         real(c_double) :: value
      end function integrand
   end interface

   interface
      function gsl_workspace_alloc(n) bind(c, name='gsl_integration_workspace_alloc') result(w)
         import :: c_ptr, c_size_t
         integer(c_size_t), value :: n
         type(c_ptr) :: w
      end function gsl_workspace_alloc
      subroutine gsl_workspace_free(w) bind(c, name='gsl_integration_workspace_free')
         import :: c_ptr
         type(c_ptr), value :: w
      end subroutine gsl_workspace_free
      function gsl_qag(f, a, b, epsabs, epsrel, limit, key, w, r, e) bind(c, name='gsl_integration_qag') result(status)
         import :: c_double, c_int, c_ptr, c_size_t, gsl_function_type
         type(gsl_function_type), intent(in) :: f
         real(c_double), value :: a, b, epsabs, epsrel
         integer(c_size_t), value :: limit
         integer(c_int), value :: key
         type(c_ptr), value :: w
         real(c_double), intent(out) :: r, e
         integer(c_int) :: status
      end function gsl_qag
      function gsl_cquad_alloc(n) bind(c, name='gsl_integration_cquad_workspace_alloc') result(w)
         import :: c_ptr, c_size_t
         integer(c_size_t), value :: n
         type(c_ptr) :: w
      end function gsl_cquad_alloc
      subroutine gsl_cquad_free(w) bind(c, name='gsl_integration_cquad_workspace_free')
         import :: c_ptr
         type(c_ptr), value :: w
      end subroutine gsl_cquad_free
      function gsl_cquad(f, a, b, epsabs, epsrel, w, r, e, n) bind(c, name='gsl_integration_cquad') result(status)
         import :: c_double, c_int, c_ptr, c_size_t, gsl_function_type
         type(gsl_function_type), intent(in) :: f
         real(c_double), value :: a, b, epsabs, epsrel
         type(c_ptr), value :: w
         real(c_double), intent(out) :: r, e
         integer(c_size_t), intent(out) :: n
         integer(c_int) :: status
      end function gsl_cquad
      function gsl_glfixed_alloc(n) bind(c, name='gsl_integration_glfixed_table_alloc') result(t)
         import :: c_ptr, c_size_t
         integer(c_size_t), value :: n
         type(c_ptr) :: t
      end function gsl_glfixed_alloc
      subroutine gsl_glfixed_free(t) bind(c, name='gsl_integration_glfixed_table_free')
         import :: c_ptr
         type(c_ptr), value :: t
      end subroutine gsl_glfixed_free
      function gsl_glfixed(f, a, b, t) bind(c, name='gsl_integration_glfixed') result(value)
         import :: c_double, c_ptr, gsl_function_type
         type(gsl_function_type), intent(in) :: f
         real(c_double), value :: a, b
         type(c_ptr), value :: t
         real(c_double) :: value
      end function gsl_glfixed
      function gsl_glfixed_point(a, b, i, xi, wi, t) bind(c, name='gsl_integration_glfixed_point') result(status)
         import :: c_double, c_int, c_ptr, c_size_t
         real(c_double), value :: a, b
         integer(c_size_t), value :: i
         real(c_double), intent(inout) :: xi, wi
         type(c_ptr), value :: t
         integer(c_int) :: status
      end function gsl_glfixed_point
   end interface

contains

   !> An integrand; free it with fgsl_function_free.
   function fgsl_function_init(func, params) result(f)
      procedure(integrand) :: func
      type(c_ptr), intent(in) :: params   !! Handed to func
      type(fgsl_function) :: f
      allocate (f%p)
      f%p = gsl_function_type(c_funloc(func), params)
   end function fgsl_function_init

   subroutine fgsl_function_free(sfunc)
      type(fgsl_function), intent(inout) :: sfunc
      if (associated(sfunc%p)) deallocate (sfunc%p)
   end subroutine fgsl_function_free

   function fgsl_integration_workspace_alloc(n) result(w)
      integer(c_size_t), intent(in) :: n
      type(fgsl_integration_workspace) :: w
      w%p = gsl_workspace_alloc(n)
   end function fgsl_integration_workspace_alloc

   subroutine fgsl_integration_workspace_free(w)
      type(fgsl_integration_workspace), intent(inout) :: w
      if (c_associated(w%p)) call gsl_workspace_free(w%p)
      w%p = c_null_ptr
   end subroutine fgsl_integration_workspace_free

   !> Adaptive Gauss-Kronrod quadrature of f from a to b.
   function fgsl_integration_qag(f, a, b, epsabs, epsrel, limit, key, workspace, result, abserr) result(status)
      type(fgsl_function), intent(in) :: f
      real(c_double), intent(in) :: a, b, epsabs, epsrel
      integer(c_size_t), intent(in) :: limit
      integer(c_int), intent(in) :: key
      type(fgsl_integration_workspace), intent(inout) :: workspace
      real(c_double), intent(out) :: result, abserr
      integer(c_int) :: status
      status = gsl_qag(f%p, a, b, epsabs, epsrel, limit, key, workspace%p, result, abserr)
   end function fgsl_integration_qag

   function fgsl_integration_cquad_workspace_alloc(n) result(w)
      integer(c_size_t), intent(in) :: n
      type(fgsl_integration_cquad_workspace) :: w
      w%p = gsl_cquad_alloc(n)
   end function fgsl_integration_cquad_workspace_alloc

   subroutine fgsl_integration_cquad_workspace_free(w)
      type(fgsl_integration_cquad_workspace), intent(inout) :: w
      if (c_associated(w%p)) call gsl_cquad_free(w%p)
      w%p = c_null_ptr
   end subroutine fgsl_integration_cquad_workspace_free

   !> Doubly adaptive Clenshaw-Curtis quadrature of f from a to b.
   function fgsl_integration_cquad(f, a, b, epsabs, epsrel, workspace, result, abserr, nevals) result(status)
      type(fgsl_function), intent(in) :: f
      real(c_double), intent(in) :: a, b, epsabs, epsrel
      type(fgsl_integration_cquad_workspace), intent(inout) :: workspace
      real(c_double), intent(out) :: result, abserr
      integer(c_size_t), intent(inout) :: nevals
      integer(c_int) :: status
      status = gsl_cquad(f%p, a, b, epsabs, epsrel, workspace%p, result, abserr, nevals)
   end function fgsl_integration_cquad

   !> The Gauss-Legendre rule of n nodes.
   function fgsl_integration_glfixed_table_alloc(n) result(t)
      integer(c_size_t), intent(in) :: n
      type(fgsl_integration_glfixed_table) :: t
      t%p = gsl_glfixed_alloc(n)
   end function fgsl_integration_glfixed_table_alloc

   subroutine fgsl_integration_glfixed_table_free(t)
      type(fgsl_integration_glfixed_table), intent(inout) :: t
      if (c_associated(t%p)) call gsl_glfixed_free(t%p)
      t%p = c_null_ptr
   end subroutine fgsl_integration_glfixed_table_free

   !> The rule applied to f from a to b.
   function fgsl_integration_glfixed(f, a, b, t) result(value)
      type(fgsl_function), intent(in) :: f
      real(c_double), intent(in) :: a, b
      type(fgsl_integration_glfixed_table), intent(in) :: t
      real(c_double) :: value
      value = gsl_glfixed(f%p, a, b, t%p)
   end function fgsl_integration_glfixed

   !> Node and weight of number i = 0 ... n - 1 of the rule from a to b.
   function fgsl_integration_glfixed_point(a, b, i, xi, wi, t) result(status)
      real(c_double), intent(in) :: a, b
      integer(c_size_t), intent(in) :: i
      real(c_double), intent(inout) :: xi, wi
      type(fgsl_integration_glfixed_table), intent(in) :: t
      integer(c_int) :: status
      status = gsl_glfixed_point(a, b, i, xi, wi, t%p)
   end function fgsl_integration_glfixed_point

end module kyvadlo_gsl_quadrature
