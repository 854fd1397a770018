!> Elliptic functions: ours in three kinds beside GSL's, at benign arguments and at hard ones.
module kyvadlo_study_functions
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only: real32, real64, real128
   use kyvadlo_function_ids
   use kyvadlo_function_values, only: our_values
   use kyvadlo_function_values_gsl, only: gsl_values
   use kyvadlo_study_record, only: cell_type, measure, study_type, work_type
   implicit none
   private
   public :: ask_functions, function_names, n_functions

   integer, parameter :: q = real128
   include 'study_functions.inc'

   !> In the order of `ids`.
   character(len=12), parameter :: function_names(n_functions) = [character(len=12) :: 'R_C', 'R_F', 'R_D', 'R_J', &
      'K', 'E', 'D', 'Pi', 'F(phi)', 'E(phi)', 'D(phi)', 'Pi(phi)', 'sn cn dn']
   character(len=5), parameter :: set_names(2) = ['     ', ' hard']

   integer, parameter :: single = 1, double = 2, quad = 3, gsl = 4

   !> Columns as `our_values` wants them.
   type, extends(work_type) :: functions_work_type
      integer :: id = 0, method = double, columns = 1
      real(real32) :: x_single(calls, 4) = 0, out_single(calls, 4) = 0
      real(real64) :: x(calls, 4) = 0, out(calls, 4) = 0
      real(real128) :: x_quad(calls, 4) = 0, out_quad(calls, 4) = 0
      real(real128) :: exact(calls, 4) = 0
   contains
      procedure :: pass => functions_pass
      procedure :: error => functions_error
   end type functions_work_type

contains

   !> Adds the cells of all functions.
   subroutine ask_functions(study)
      type(study_type), intent(inout) :: study
      type(functions_work_type) :: work
      integer :: set, i, call, at_argument, at_value

      at_argument = 0
      at_value = 0
      do set = 1, 2
         do i = 1, n_functions
            work%id = ids(i)
            work%results = calls
            work%columns = merge(3, 1, ids(i) == id_jacobi)
            do call = 1, calls
               work%x(call, :arguments_of(i)) = arguments(at_argument + 1:at_argument + arguments_of(i))
               at_argument = at_argument + arguments_of(i)
               work%exact(call, :work%columns) = values(at_value + 1:at_value + work%columns)
               at_value = at_value + work%columns
            end do
            work%x_single = real(work%x, real32)
            work%x_quad = work%x
            call one(single, 'ours', 'real32')
            call one(double, 'ours', 'real64')
            call one(quad, 'ours', 'real128')
#ifdef KYVADLO_WITH_GSL
            ! GSL's integrals take the modulus, which is the last of their arguments; its Jacobi functions the
            ! parameter.
            if (ids(i) >= id_k .and. ids(i) /= id_jacobi) work%x(:, arguments_of(i)) = sqrt(work%x(:, arguments_of(i)))
            call one(gsl, 'gsl_ellint', 'real64')
#endif
         end do
      end do

   contains

      subroutine one(method, name, kind)
         integer, intent(in) :: method
         character(len=*), intent(in) :: name, kind

         work%method = method
         call measure(study, work, cell_type(question='functions', orbit=trim(function_names(i))// &
            trim(set_names(set)), method=name, setting=trim(merge('benign', 'hard  ', set == 1)), kind=kind))
      end subroutine one
   end subroutine ask_functions

   subroutine functions_pass(work)
      class(functions_work_type), intent(inout) :: work
      logical :: has

      select case (work%method)
      case (single)
         call our_values(work%id, work%x_single, work%out_single)
         work%sink = work%sink + work%out_single(1, 1)
      case (quad)
         call our_values(work%id, work%x_quad, work%out_quad)
         work%sink = work%sink + real(work%out_quad(1, 1), real64)
      case default
         if (work%method == double) then
            call our_values(work%id, work%x, work%out)
         else
            call gsl_values(work%id, work%x, work%out, has)
            if (.not. has) work%has_failed = .true.
         end if
         work%sink = work%sink + work%out(1, 1)
      end select
   end subroutine functions_pass

   !> The largest of all calls: relative, but of sn, cn, dn absolute.
   function functions_error(work) result(error)
      class(functions_work_type), intent(in) :: work
      real(real64) :: error
      real(real128), dimension(calls, work%columns) :: found, errors

      select case (work%method)
      case (single)
         found = work%out_single(:, :work%columns)
      case (quad)
         found = work%out_quad(:, :work%columns)
      case default
         found = work%out(:, :work%columns)
      end select
      errors = abs(found - work%exact(:, :work%columns))
      if (work%columns == 1) errors = errors/abs(work%exact(:, :1))
      error = ieee_value(error, ieee_quiet_nan)
      if (all(ieee_is_finite(errors))) error = real(maxval(errors), real64)
   end function functions_error

end module kyvadlo_study_functions
