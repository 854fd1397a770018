!> The derivatives of an integrated motion between its steps: the columns that kyvadlo_stepper carries, their start and
!> their values at any time within the last step.
module kyvadlo_integrated_columns
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: is_finite, quiet_nan_real64
   use kyvadlo_dense_output, only: add_node, clear, defect_point, defect_to_position, defect_to_velocity, &
      interpolant_type, interpolate, prepare
   use kyvadlo_force_changes, only: change_type, forces_change_type, move_changes, natural_size, new_forces_change
   use kyvadlo_stepper, only: add_columns, stepper_type, trial_with_columns, unknowns
   use kyvadlo_suspension, only: surface_change
   implicit none
   private
   public :: columns_type, begin_columns, note_columns, clear_columns, columns_now, columns_fit

   !> The columns between the ends of steps.
   type :: columns_type
      type(interpolant_type), allocatable :: interpolants(:)   !! (p); not allocated: there are none
      logical, allocatable :: is_undefined(:)                  !! (p) without a derivative at the start
   end type columns_type

contains

   !> The columns at time 0, on the surface if the start is put on it.
   subroutine begin_columns(columns, stepper, changes, length, gravity, position, velocity, was_put, tolerance)
      type(columns_type), intent(inout) :: columns
      type(stepper_type), intent(inout) :: stepper      !! As `new_stepper` leaves it
      type(change_type), intent(in) :: changes(:)       !! (p)
      real(wp), intent(in) :: length, gravity           !! [m], [m/s2]
      real(wp), intent(in) :: position(3), velocity(3)  !! As they were given [m], [m/s]
      logical, intent(in) :: was_put(2)                 !! Whether the position, the velocity were put on the surface
      real(wp), intent(in) :: tolerance                 !! Of the error of a step
      type(forces_change_type) :: forces_changes(size(changes))
      real(wp) :: start(6, size(changes)), sizes(size(changes)), turned(3)
      integer :: j

      columns%is_undefined = [(.not. all(is_finite([changes(j)%position, changes(j)%velocity])), j=1, size(changes))]
      start = 0
      sizes = 1
      associate (forces => stepper%problem%forces)
         do j = 1, size(changes)
            if (columns%is_undefined(j)) cycle
            call new_forces_change(forces_changes(j), changes(j), forces, gravity)
            start(1:3, j) = changes(j)%position
            start(4:6, j) = changes(j)%velocity
            if (was_put(1)) then
               turned = start(4:6, j)
               call surface_change(forces%suspension, forces_changes(j)%suspension, position, velocity, start(1:3, j), &
                  turned)
               if (was_put(2)) start(4:6, j) = turned
            end if
            associate (scales => stepper%scales)
               sizes(j) = max(natural_size(changes(j), forces, length, gravity, scales(2)), &
                  norm2(start(1:3, j))/scales(1), norm2(start(4:6, j))/scales(2))
            end associate
            if (.not. sizes(j) > 0) sizes(j) = 1
         end do
      end associate
      call add_columns(stepper, forces_changes, start, sizes, tolerance)
      allocate (columns%interpolants(size(changes)))
   end subroutine begin_columns

   !> Remembers the end of a step.
   subroutine note_columns(columns, stepper)
      type(columns_type), intent(inout) :: columns
      type(stepper_type), intent(in) :: stepper
      integer :: j

      do j = 1, size(columns%interpolants)
         call add_node(columns%interpolants(j), stepper%time, stepper%columns(1:3, j), stepper%columns(4:6, j), &
            stepper%column_rates(4:6, j))
      end do
   end subroutine note_columns

   subroutine clear_columns(columns)
      type(columns_type), intent(inout) :: columns
      integer :: j

      do j = 1, size(columns%interpolants)
         call clear(columns%interpolants(j))
      end do
   end subroutine clear_columns

   !> The columns at a time within the last step; NaN for those without a derivative.
   subroutine columns_now(columns, stepper, interpolant, time, by_polynomial, matrix)
      type(columns_type), intent(in) :: columns
      type(stepper_type), intent(in) :: stepper
      type(interpolant_type), intent(in) :: interpolant !! Of the motion
      real(wp), intent(in) :: time                      !! [s]
      logical, intent(in) :: by_polynomial              !! Else before the end of the step by a step of its own
      real(wp), intent(out) :: matrix(:, :)             !! (6, p)
      real(wp) :: y(unknowns), rates(unknowns), tension, column_rates(6, size(columns%is_undefined))
      integer :: j

      associate (problem => stepper%problem)
         if (.not. time < stepper%time) then
            matrix = stepper%columns
         else if (by_polynomial) then
            call interpolate(interpolant, time, y(1:3), y(4:6))
            do j = 1, size(columns%interpolants)
               call interpolate(columns%interpolants(j), time, matrix(1:3, j), matrix(4:6, j))
               if (problem%is_taut .and. .not. problem%forces%is_elastic) call surface_change( &
                  problem%forces%suspension, problem%changes(j)%suspension, y(1:3), y(4:6), matrix(1:3, j), &
                  matrix(4:6, j))
            end do
         else
            call trial_with_columns(stepper, time - stepper%start, y, rates, tension, matrix, column_rates)
         end if
      end associate
      do j = 1, size(columns%is_undefined)
         if (columns%is_undefined(j)) matrix(:, j) = quiet_nan_real64
      end do
   end subroutine columns_now

   !> Whether the polynomials satisfy the variational equations where they should be worst. (`move` was called for the
   !> state then.)
   logical function columns_fit(columns, stepper, position, velocity, allowed)
      type(columns_type), intent(inout) :: columns
      type(stepper_type), intent(in) :: stepper
      real(wp), intent(in) :: position(3), velocity(3)  !! At `defect_point`
      real(wp), intent(in) :: allowed                   !! Part of the size of a column
      real(wp), dimension(3, size(columns%interpolants)) :: bends, accelerations
      real(wp) :: matrix(6, size(columns%interpolants)), tensions(size(columns%interpolants)), time, defect, h
      integer :: j

      columns_fit = .true.
      if (size(columns%interpolants) == 0) return
      h = stepper%time - stepper%start
      time = stepper%time + defect_point*h
      do j = 1, size(columns%interpolants)
         call prepare(columns%interpolants(j))
         call interpolate(columns%interpolants(j), time, matrix(1:3, j), matrix(4:6, j), bends(:, j))
      end do
      associate (problem => stepper%problem, sizes => stepper%sizes)
         call move_changes(problem%forces, problem%changes, problem%is_taut, time, position, velocity, matrix, &
            accelerations, tensions)
         do j = 1, size(columns%interpolants)
            defect = norm2(bends(:, j) - accelerations(:, j))
            if (.not. (defect*h**2*defect_to_position <= allowed*sizes(j)*stepper%scales(1) .and. &
               defect*h*defect_to_velocity <= allowed*sizes(j)*stepper%scales(2))) columns_fit = .false.
         end do
      end associate
   end function columns_fit

end module kyvadlo_integrated_columns
