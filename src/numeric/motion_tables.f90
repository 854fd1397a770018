!> Tables of the pivot's displacements, and of the length that a winch leaves: splines through them, laid by GSL.
module kyvadlo_motion_tables
   use, intrinsic :: iso_c_binding, only: c_int, c_size_t
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: is_finite
   use kyvadlo_status, only: error_type, fail, code_domain, code_unsupported
   use kyvadlo_curves, only: curve_type, integrated, least_value, look_up
   use kyvadlo_effects, only: effects_type
   use kyvadlo_gsl, only: fgsl_spline, fgsl_spline_alloc, fgsl_spline_free, fgsl_spline_init, &
      fgsl_spline_eval_deriv2_e, fgsl_interp_accel, fgsl_interp_accel_alloc, fgsl_interp_accel_free, fgsl_interp_cspline
   implicit none
   private
   public :: new_pivot_table, new_hoist_table

contains

   !> Gives effects the motion of the pivot along a natural cubic spline: through all points, twice continuously
   !> differentiable, without acceleration at its ends. Two points make a straight line. Fails on fewer and on times
   !> that do not ascend.
   !>
   !> Of velocities or accelerations the motion is from rest at 0 at time 0. Straight lines through the points may be
   !> asked for in the place of a spline; of displacements, the velocity then jumps at every point (kyvadlo_knots).
   subroutine new_pivot_table(effects, times, displacements, error, order, is_linear)
      type(effects_type), intent(inout) :: effects
      real(wp), intent(in) :: times(:)             !! (n), strictly ascending [s]
      real(wp), intent(in) :: displacements(:, :)  !! (3, n), or their derivatives [m]
      type(error_type), allocatable, intent(out) :: error
      integer, intent(in), optional :: order       !! Of these derivatives, 0 to 2
      logical, intent(in), optional :: is_linear   !! Straight lines
      real(wp), allocatable :: curvatures(:, :)
      type(curve_type) :: curve
      logical :: straight
      integer :: i, rates

      rates = 0
      straight = .false.
      if (present(order)) rates = order
      if (present(is_linear)) straight = is_linear
      call lay_spline('pivot table', times, displacements, 3, curvatures, error)
      if (allocated(error)) return
      if (straight) curvatures = 0
      if (rates > 0 .or. straight) then
         ! By their degree straight lines are known from what only looks like them.
         call cubic_pieces(times, displacements, curvatures, merge(1, 3, straight), curve)
         do i = 1, rates
            curve = integrated(curve)
         end do
         effects%pivot_curve = curve
         return
      end if
      effects%pivot_times = times
      effects%pivot_displacements = displacements
      call move_alloc(curvatures, effects%pivot_curvatures)
   end subroutine new_pivot_table

   !> Gives effects a length that follows a natural cubic spline: what it is at a time more than at time 0. Fails as
   !> `new_pivot_table`, on a table that begins after time 0 and on a length that is not positive all along.
   subroutine new_hoist_table(effects, times, lengths, error, first_length)
      type(effects_type), intent(inout) :: effects
      real(wp), intent(in) :: times(:)             !! (n), strictly ascending, the first one 0 or before [s]
      real(wp), intent(in) :: lengths(:)           !! (n) [m]
      type(error_type), allocatable, intent(out) :: error
      real(wp), intent(out), optional :: first_length !! At time 0 [m]
      real(wp), allocatable :: curvatures(:, :)
      type(curve_type) :: curve
      real(wp) :: start(1, 0:0), least
      character(len=12) :: got
      integer :: n

      n = size(times)
      call lay_spline('hoist table', times, reshape(lengths, [1, size(lengths)]), 1, curvatures, error)
      if (.not. allocated(error) .and. n > 0) then
         if (times(1) > 0) call fail(error, code_domain, 'hoist table: it must begin at time 0 or before')
      end if
      if (allocated(error)) return
      call cubic_pieces(times, reshape(lengths, [1, n]), curvatures, 3, curve)
      least = least_value(curve, 1, times(1), times(n))
      if (.not. least > 0) then
         write (got, '(es12.4)') least
         call fail(error, code_domain, 'hoist table: the length must be positive all along, its least is '// &
            trim(adjustl(got))//' m')
         return
      end if
      call look_up(curve, 0.0_wp, start)
      curve%terms(1, 0, :) = curve%terms(1, 0, :) - start(1, 0)
      if (present(first_length)) first_length = start(1, 0)
      effects%hoist = curve
   end subroutine new_hoist_table

   !> Second derivatives of the splines at their knots.
   subroutine lay_spline(name, times, values, components, curvatures, error)
      character(len=*), intent(in) :: name         !! For messages
      real(wp), intent(in) :: times(:)             !! (n)
      real(wp), intent(in) :: values(:, :)         !! (components, n)
      integer, intent(in) :: components
      real(wp), allocatable, intent(out) :: curvatures(:, :) !! Likewise
      type(error_type), allocatable, intent(out) :: error
      type(fgsl_spline) :: spline
      type(fgsl_interp_accel) :: accel
      real(wp) :: line(size(times))
      integer(c_int) :: status
      integer :: i, k, n
      character(len=12) :: got

      n = size(times)
      if (n < 2) then
         write (got, '(i0)') n
         call fail(error, code_domain, name//': at least 2 times are needed, got '//trim(got))
      else if (size(values, 1) /= components .or. size(values, 2) /= n) then
         write (got, '(i0)') components
         call fail(error, code_domain, name//': values are missing; every time needs '//trim(got))
      else if (.not. (all(is_finite(times)) .and. all(is_finite(values)))) then
         call fail(error, code_domain, name//': times and values must be finite')
      else
         do k = 2, n
            if (times(k) > times(k - 1)) cycle
            write (got, '(i0)') k
            call fail(error, code_domain, name//': the times must ascend, but number '//trim(got)//' does not')
            return
         end do
      end if
      if (allocated(error)) return
      allocate (curvatures, mold=values)
      curvatures = 0
      if (n == 2) return
      spline = fgsl_spline_alloc(fgsl_interp_cspline, int(n, c_size_t))
      accel = fgsl_interp_accel_alloc()
      do i = 1, components
         line = values(i, :)
         status = fgsl_spline_init(spline, times, line)
         do k = 1, n
            if (status == 0) status = fgsl_spline_eval_deriv2_e(spline, times(k), accel, curvatures(i, k))
         end do
         if (status /= 0) call fail(error, code_unsupported, name//': GSL could not lay the spline')
         if (status /= 0) exit
      end do
      call fgsl_interp_accel_free(accel)
      call fgsl_spline_free(spline)
   end subroutine lay_spline

   !> The pieces between knots from values and second derivatives there.
   pure subroutine cubic_pieces(times, values, curvatures, degree, curve)
      real(wp), intent(in) :: times(:), values(:, :), curvatures(:, :)
      integer, intent(in) :: degree                !! 3, or 1 where all curvatures are zero
      type(curve_type), intent(out) :: curve
      real(wp) :: step
      integer :: k, n

      n = size(times)
      curve%times = times
      allocate (curve%terms(size(values, 1), 0:degree, n - 1))
      do k = 1, n - 1
         step = times(k + 1) - times(k)
         curve%terms(:, 0, k) = values(:, k)
         curve%terms(:, 1, k) = (values(:, k + 1) - values(:, k))/step - step*(2*curvatures(:, k) &
            + curvatures(:, k + 1))/6
         if (degree == 1) cycle
         curve%terms(:, 2, k) = curvatures(:, k)/2
         curve%terms(:, 3, k) = (curvatures(:, k + 1) - curvatures(:, k))/(6*step)
      end do
   end subroutine cubic_pieces

end module kyvadlo_motion_tables
