!> The period T by GSL: its complete integral K, a Gauss-Legendre rule, adaptive quadrature. Without GSL `has_gsl` is
!> false.
!>
!> T = 2 sqrt(2/g) l times the integral of 1/sqrt((z3 - z2) cos**2 + (z3 - z1) sin**2) over a quarter of the circle.
module kyvadlo_study_period_gsl
   use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_int, c_loc, c_ptr, c_size_t
   use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only: int64, real64
   use kyvadlo_study_period_methods, only: swings_type
#ifdef KYVADLO_WITH_GSL
   use kyvadlo_gsl
#endif
   implicit none
   private
   public :: has_gsl, gsl_table_type, new_table, free_table, gsl_k_period, gauss_period, qag_period

   real(real64), parameter :: quarter = acos(-1.0_real64)/2

   !> What the integrand needs, and how often it was asked.
   type :: integrand_type
      type(swings_type) :: swings
      integer(int64) :: evaluations = 0
   end type integrand_type

#ifdef KYVADLO_WITH_GSL
   logical, parameter :: has_gsl = .true.

   !> Subdivisions of the adaptive quadrature; GSL stops with a status beyond them.
   integer(c_size_t), parameter :: most_intervals = 1000

   !> Nodes and weights, or the workspace of the adaptive quadrature.
   type :: gsl_table_type
      private
      logical :: has_nodes = .false., has_workspace = .false.
      type(fgsl_integration_glfixed_table) :: nodes
      type(fgsl_integration_workspace) :: workspace
   end type gsl_table_type
#else
   logical, parameter :: has_gsl = .false.

   type :: gsl_table_type
   end type gsl_table_type
#endif

contains

#ifdef KYVADLO_WITH_GSL
   !> Set up once for a process: not part of what is timed.
   subroutine new_table(table, nodes)
      type(gsl_table_type), intent(out) :: table
      integer, intent(in) :: nodes  !! 0: for the adaptive quadrature

      table%has_nodes = nodes > 0
      table%has_workspace = nodes == 0
      if (nodes > 0) then
         table%nodes = fgsl_integration_glfixed_table_alloc(int(nodes, c_size_t))
      else
         table%workspace = fgsl_integration_workspace_alloc(most_intervals)
      end if
   end subroutine new_table

   subroutine free_table(table)
      type(gsl_table_type), intent(inout) :: table

      if (table%has_nodes) call fgsl_integration_glfixed_table_free(table%nodes)
      if (table%has_workspace) call fgsl_integration_workspace_free(table%workspace)
      table%has_nodes = .false.
      table%has_workspace = .false.
   end subroutine free_table

   !> 2 K(k)/w by GSL's K of the modulus.
   real(real64) function gsl_k_period(unit_time, swings, mode) result(period)
      real(real64), intent(in) :: unit_time
      type(swings_type), intent(in) :: swings
      integer, intent(in) :: mode   !! GSL's precision: 0 double, 1 single, 2 approx
      type(fgsl_mode_t), parameter :: modes(0:2) = [fgsl_prec_double, fgsl_prec_single, fgsl_prec_approx]
      type(fgsl_sf_result) :: value
      integer(c_int) :: status
      real(real64) :: modulus

      modulus = sqrt((swings%lower_gap - swings%upper_gap)/swings%outer_swing)
      status = fgsl_sf_ellint_kcomp_e(modulus, modes(mode), value)
      period = unit_time*value%val/sqrt(swings%outer_swing)
      if (status /= 0) period = ieee_value(period, ieee_quiet_nan)
   end function gsl_k_period

   real(real64) function gauss_period(unit_time, swings, table) result(period)
      real(real64), intent(in) :: unit_time
      type(swings_type), intent(in) :: swings
      type(gsl_table_type), intent(in) :: table
      type(integrand_type), target :: problem
      type(fgsl_function) :: f

      problem%swings = swings
      f = fgsl_function_init(integrand, c_loc(problem))
      period = unit_time*fgsl_integration_glfixed(f, 0.0_c_double, quarter, table%nodes)
      call fgsl_function_free(f)
   end function gauss_period

   !> QAG with the 15-point rule: the smallest pieces GSL offers.
   subroutine qag_period(unit_time, swings, table, tolerance, period, evaluations, has_failed)
      real(real64), intent(in) :: unit_time
      type(swings_type), intent(in) :: swings
      type(gsl_table_type), intent(inout) :: table
      real(real64), intent(in) :: tolerance           !! Relative
      real(real64), intent(out) :: period
      integer(int64), intent(out) :: evaluations
      logical, intent(inout) :: has_failed
      type(integrand_type), target :: problem
      type(fgsl_function) :: f
      real(c_double) :: value, estimate
      integer(c_int) :: status

      problem%swings = swings
      f = fgsl_function_init(integrand, c_loc(problem))
      status = fgsl_integration_qag(f, 0.0_c_double, quarter, 0.0_c_double, tolerance, most_intervals, &
         fgsl_integ_gauss15, table%workspace, value, estimate)
      call fgsl_function_free(f)
      if (status /= 0) has_failed = .true.
      period = unit_time*value
      evaluations = problem%evaluations
   end subroutine qag_period
#else
   subroutine new_table(table, nodes)
      type(gsl_table_type), intent(out) :: table
      integer, intent(in) :: nodes

      if (nodes < 0) table = gsl_table_type() ! Every argument is referred to in either build.
   end subroutine new_table

   subroutine free_table(table)
      type(gsl_table_type), intent(inout) :: table

      table = gsl_table_type()
   end subroutine free_table

   real(real64) function gsl_k_period(unit_time, swings, mode) result(period)
      real(real64), intent(in) :: unit_time
      type(swings_type), intent(in) :: swings
      integer, intent(in) :: mode

      period = ieee_value(unit_time*swings%outer_gap*mode, ieee_quiet_nan)
   end function gsl_k_period

   real(real64) function gauss_period(unit_time, swings, table) result(period)
      real(real64), intent(in) :: unit_time
      type(swings_type), intent(in) :: swings
      type(gsl_table_type), intent(in) :: table

      period = ieee_value(unit_time*swings%outer_gap*storage_size(table), ieee_quiet_nan)
   end function gauss_period

   subroutine qag_period(unit_time, swings, table, tolerance, period, evaluations, has_failed)
      real(real64), intent(in) :: unit_time
      type(swings_type), intent(in) :: swings
      type(gsl_table_type), intent(inout) :: table
      real(real64), intent(in) :: tolerance
      real(real64), intent(out) :: period
      integer(int64), intent(out) :: evaluations
      logical, intent(inout) :: has_failed

      period = ieee_value(unit_time*swings%outer_gap*tolerance*storage_size(table), ieee_quiet_nan)
      evaluations = 0
      has_failed = .true.
   end subroutine qag_period
#endif

   !> One node, for GSL.
   function integrand(x, params) bind(c, name='') result(value)
      real(c_double), value :: x
      type(c_ptr), value :: params
      real(c_double) :: value
      type(integrand_type), pointer :: problem

      call c_f_pointer(params, problem)
      problem%evaluations = problem%evaluations + 1
      value = 1/sqrt(problem%swings%outer_swing*cos(x)**2 + problem%swings%outer_gap*sin(x)**2)
   end function integrand

end module kyvadlo_study_period_gsl
