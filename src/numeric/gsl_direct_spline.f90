!> GSL's splines for the facade kyvadlo_gsl, straight onto libgsl.
module kyvadlo_gsl_spline
   use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int, c_null_ptr, c_ptr, c_size_t
   implicit none
   private
   public :: fgsl_interp_type, fgsl_interp_cspline, fgsl_interp_cspline_periodic
   public :: fgsl_interp_accel, fgsl_interp_accel_alloc, fgsl_interp_accel_free
   public :: fgsl_spline, fgsl_spline_alloc, fgsl_spline_free, fgsl_spline_init
   public :: fgsl_spline_eval, fgsl_spline_eval_deriv, fgsl_spline_eval_deriv2
   public :: fgsl_spline_eval_e, fgsl_spline_eval_deriv_e, fgsl_spline_eval_deriv2_e

   !> A kind of spline; gsl_steps.c knows what the numbers stand for.
   type :: fgsl_interp_type
      private
      integer(c_int) :: which = 0
   end type fgsl_interp_type
   !> Cubic with second derivative zero at both ends, and cubic with one value and slope at both ends.
   type(fgsl_interp_type), parameter :: fgsl_interp_cspline = fgsl_interp_type(1)
   type(fgsl_interp_type), parameter :: fgsl_interp_cspline_periodic = fgsl_interp_type(2)

   !> The interval found last; each thread needs its own.
   type :: fgsl_interp_accel
      private
      type(c_ptr) :: p = c_null_ptr
   end type fgsl_interp_accel

   !> A spline with its own copy of the points.
   type :: fgsl_spline
      private
      type(c_ptr) :: p = c_null_ptr
   end type fgsl_spline

   interface
      function gsl_interp_kind(which) bind(c, name='kyvadlo_gsl_interp') result(kind)
         import :: c_int, c_ptr
         integer(c_int), value :: which
         type(c_ptr) :: kind
      end function gsl_interp_kind
      function gsl_accel_alloc() bind(c, name='gsl_interp_accel_alloc') result(a)
         import :: c_ptr
         type(c_ptr) :: a
      end function gsl_accel_alloc
      subroutine gsl_accel_free(a) bind(c, name='gsl_interp_accel_free')
         import :: c_ptr
         type(c_ptr), value :: a
      end subroutine gsl_accel_free
      function gsl_spline_alloc(kind, n) bind(c, name='gsl_spline_alloc') result(s)
         import :: c_ptr, c_size_t
         type(c_ptr), value :: kind
         integer(c_size_t), value :: n
         type(c_ptr) :: s
      end function gsl_spline_alloc
      subroutine gsl_spline_free(s) bind(c, name='gsl_spline_free')
         import :: c_ptr
         type(c_ptr), value :: s
      end subroutine gsl_spline_free
      function gsl_spline_init(s, xa, ya, n) bind(c, name='gsl_spline_init') result(status)
         import :: c_double, c_int, c_ptr, c_size_t
         type(c_ptr), value :: s
         real(c_double), intent(in) :: xa(*), ya(*)
         integer(c_size_t), value :: n
         integer(c_int) :: status
      end function gsl_spline_init
      function gsl_spline_value(s, x, a) bind(c, name='gsl_spline_eval') result(y)
         import :: c_double, c_ptr
         type(c_ptr), value :: s, a
         real(c_double), value :: x
         real(c_double) :: y
      end function gsl_spline_value
      function gsl_spline_deriv(s, x, a) bind(c, name='gsl_spline_eval_deriv') result(y)
         import :: c_double, c_ptr
         type(c_ptr), value :: s, a
         real(c_double), value :: x
         real(c_double) :: y
      end function gsl_spline_deriv
      function gsl_spline_deriv2(s, x, a) bind(c, name='gsl_spline_eval_deriv2') result(y)
         import :: c_double, c_ptr
         type(c_ptr), value :: s, a
         real(c_double), value :: x
         real(c_double) :: y
      end function gsl_spline_deriv2
      function gsl_spline_value_e(s, x, a, y) bind(c, name='gsl_spline_eval_e') result(status)
         import :: c_double, c_int, c_ptr
         type(c_ptr), value :: s, a
         real(c_double), value :: x
         real(c_double), intent(out) :: y
         integer(c_int) :: status
      end function gsl_spline_value_e
      function gsl_spline_deriv_e(s, x, a, y) bind(c, name='gsl_spline_eval_deriv_e') result(status)
         import :: c_double, c_int, c_ptr
         type(c_ptr), value :: s, a
         real(c_double), value :: x
         real(c_double), intent(out) :: y
         integer(c_int) :: status
      end function gsl_spline_deriv_e
      function gsl_spline_deriv2_e(s, x, a, y) bind(c, name='gsl_spline_eval_deriv2_e') result(status)
         import :: c_double, c_int, c_ptr
         type(c_ptr), value :: s, a
         real(c_double), value :: x
         real(c_double), intent(out) :: y
         integer(c_int) :: status
      end function gsl_spline_deriv2_e
   end interface

contains

   function fgsl_interp_accel_alloc() result(acc)
      type(fgsl_interp_accel) :: acc
      acc%p = gsl_accel_alloc()
   end function fgsl_interp_accel_alloc

   subroutine fgsl_interp_accel_free(acc)
      type(fgsl_interp_accel), intent(inout) :: acc
      if (c_associated(acc%p)) call gsl_accel_free(acc%p)
      acc%p = c_null_ptr
   end subroutine fgsl_interp_accel_free

   !> Room for a spline through `size` points, three at least.
   function fgsl_spline_alloc(interp_type, size) result(spline)
      type(fgsl_interp_type), intent(in) :: interp_type
      integer(c_size_t), intent(in) :: size
      type(fgsl_spline) :: spline
      spline%p = gsl_spline_alloc(gsl_interp_kind(interp_type%which), size)
   end function fgsl_spline_alloc

   subroutine fgsl_spline_free(spline)
      type(fgsl_spline), intent(inout) :: spline
      if (c_associated(spline%p)) call gsl_spline_free(spline%p)
      spline%p = c_null_ptr
   end subroutine fgsl_spline_free

   !> Lays the spline through the points. xa must ascend strictly: GSL's error handler hears of it otherwise.
   function fgsl_spline_init(spline, xa, ya) result(status)
      type(fgsl_spline), intent(inout) :: spline
      real(c_double), intent(in), contiguous :: xa(:), ya(:)   !! (size) of fgsl_spline_alloc
      integer(c_int) :: status
      status = gsl_spline_init(spline%p, xa, ya, size(xa, kind=c_size_t))
   end function fgsl_spline_init

   !> The spline at x; outside its points GSL's error handler is called.
   function fgsl_spline_eval(spline, x, acc) result(y)
      type(fgsl_spline), intent(in) :: spline
      real(c_double), intent(in) :: x
      type(fgsl_interp_accel), intent(inout) :: acc
      real(c_double) :: y
      y = gsl_spline_value(spline%p, x, acc%p)
   end function fgsl_spline_eval

   !> Its first derivative at x.
   function fgsl_spline_eval_deriv(spline, x, acc) result(y)
      type(fgsl_spline), intent(in) :: spline
      real(c_double), intent(in) :: x
      type(fgsl_interp_accel), intent(inout) :: acc
      real(c_double) :: y
      y = gsl_spline_deriv(spline%p, x, acc%p)
   end function fgsl_spline_eval_deriv

   !> Its second derivative at x.
   function fgsl_spline_eval_deriv2(spline, x, acc) result(y)
      type(fgsl_spline), intent(in) :: spline
      real(c_double), intent(in) :: x
      type(fgsl_interp_accel), intent(inout) :: acc
      real(c_double) :: y
      y = gsl_spline_deriv2(spline%p, x, acc%p)
   end function fgsl_spline_eval_deriv2

   !> The spline at x with a status; outside its points NaN, and no error handler is called.
   function fgsl_spline_eval_e(spline, x, acc, y) result(status)
      type(fgsl_spline), intent(in) :: spline
      real(c_double), intent(in) :: x
      type(fgsl_interp_accel), intent(inout) :: acc
      real(c_double), intent(out) :: y
      integer(c_int) :: status
      status = gsl_spline_value_e(spline%p, x, acc%p, y)
   end function fgsl_spline_eval_e

   !> Its first derivative with a status.
   function fgsl_spline_eval_deriv_e(spline, x, acc, y) result(status)
      type(fgsl_spline), intent(in) :: spline
      real(c_double), intent(in) :: x
      type(fgsl_interp_accel), intent(inout) :: acc
      real(c_double), intent(out) :: y
      integer(c_int) :: status
      status = gsl_spline_deriv_e(spline%p, x, acc%p, y)
   end function fgsl_spline_eval_deriv_e

   !> Its second derivative with a status.
   function fgsl_spline_eval_deriv2_e(spline, x, acc, y) result(status)
      type(fgsl_spline), intent(in) :: spline
      real(c_double), intent(in) :: x
      type(fgsl_interp_accel), intent(inout) :: acc
      real(c_double), intent(out) :: y
      integer(c_int) :: status
      status = gsl_spline_deriv2_e(spline%p, x, acc%p, y)
   end function fgsl_spline_eval_deriv2_e

end module kyvadlo_gsl_spline
