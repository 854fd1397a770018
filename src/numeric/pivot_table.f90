!> The spline through a table of the pivot's displacements, laid by GSL.
module kyvadlo_pivot_table
   use, intrinsic :: iso_c_binding, only: c_int, c_size_t
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: is_finite
   use kyvadlo_status, only: error_type, fail, code_domain, code_unsupported
   use kyvadlo_effects, only: effects_type
   use kyvadlo_gsl, only: fgsl_spline, fgsl_spline_alloc, fgsl_spline_free, fgsl_spline_init, &
      fgsl_spline_eval_deriv2_e, fgsl_interp_accel, fgsl_interp_accel_alloc, fgsl_interp_accel_free, fgsl_interp_cspline
   implicit none
   private
   public :: new_pivot_table

contains

   !> Gives effects the motion of the pivot along a natural cubic spline: through all points, twice continuously
   !> differentiable, without acceleration at its ends. Two points make a straight line. Fails on fewer and on times
   !> that do not ascend.
   subroutine new_pivot_table(effects, times, displacements, error)
      type(effects_type), intent(inout) :: effects
      real(wp), intent(in) :: times(:)             !! (n), strictly ascending [s]
      real(wp), intent(in) :: displacements(:, :)  !! (3, n) [m]
      type(error_type), allocatable, intent(out) :: error
      type(fgsl_spline) :: spline
      type(fgsl_interp_accel) :: accel
      integer(c_int) :: status
      integer :: axis, k, n
      character(len=12) :: got

      n = size(times)
      if (n < 2) then
         write (got, '(i0)') n
         call fail(error, code_domain, 'pivot table: at least 2 times are needed, got '//trim(got))
      else if (size(displacements, 1) /= 3 .or. size(displacements, 2) /= n) then
         call fail(error, code_domain, 'pivot table: every time needs three displacements')
      else if (.not. (all(is_finite(times)) .and. all(is_finite(displacements)))) then
         call fail(error, code_domain, 'pivot table: times and displacements must be finite')
      else
         do k = 2, n
            if (times(k) > times(k - 1)) cycle
            write (got, '(i0)') k
            call fail(error, code_domain, 'pivot table: the times must ascend, but number '//trim(got)//' does not')
            return
         end do
      end if
      if (allocated(error)) return
      effects%pivot_times = times
      effects%pivot_displacements = displacements
      allocate (effects%pivot_curvatures, mold=displacements)
      effects%pivot_curvatures = 0
      if (n == 2) return
      spline = fgsl_spline_alloc(fgsl_interp_cspline, int(n, c_size_t))
      accel = fgsl_interp_accel_alloc()
      do axis = 1, 3
         status = fgsl_spline_init(spline, times, effects%pivot_displacements(axis, :))
         do k = 1, n
            if (status == 0) status = fgsl_spline_eval_deriv2_e(spline, times(k), accel, &
               effects%pivot_curvatures(axis, k))
         end do
         if (status /= 0) call fail(error, code_unsupported, 'pivot table: GSL could not lay the spline')
         if (status /= 0) exit
      end do
      call fgsl_interp_accel_free(accel)
      call fgsl_spline_free(spline)
   end subroutine new_pivot_table

end module kyvadlo_pivot_table
