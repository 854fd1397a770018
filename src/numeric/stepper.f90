!> Steps of Newton's equations in Cartesian coordinates by GSL's Runge-Kutta-Prince-Dormand method of order 8, their
!> length chosen by GSL from the error of each.
!>
!> The force of rod or string follows from the surface it keeps the bob on, so no coordinate is singular at the lowest
!> and highest points. What a step lets slip off the surface, a part of its error, is put back at its end.
!>
!> On request the derivatives of the motion with respect to parameters are integrated with it, by the variational
!> equations (kyvadlo_force_changes): a column of six numbers for each, in the same steps, with their errors among those
!> that choose the length of the step.
module kyvadlo_stepper
   use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_int, c_loc, c_ptr, c_size_t
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_force_changes, only: forces_change_type, move_changes
   use kyvadlo_forces, only: forces_type, move
   use kyvadlo_numbers, only: is_finite
   use kyvadlo_suspension, only: put_on_surface, surface_change
   use kyvadlo_gsl, only: fgsl_odeiv2_system, fgsl_odeiv2_system_init, fgsl_odeiv2_system_free, fgsl_odeiv2_step, &
      fgsl_odeiv2_step_alloc, fgsl_odeiv2_step_apply, fgsl_odeiv2_step_free, fgsl_odeiv2_step_rk8pd, &
      fgsl_odeiv2_control, fgsl_odeiv2_control_scaled_new, fgsl_odeiv2_control_hadjust, fgsl_odeiv2_control_free
   implicit none
   private
   public :: stepper_type, problem_type, new_stepper, add_columns, free_stepper, take_step, trial_step, &
      trial_with_columns, restart, let_go, unknowns, works

   !> Place less `base`, velocity, and with them the work of drag and of the pivot per mass.
   integer, parameter :: unknowns = 8
   !> A step shorter than this part of the time scale fails: the motion is singular, or so stiff that a second of it
   !> would take minutes. A spring that calls for such steps would have 1e16 times the stiffness that the weight
   !> stretches by the length.
   real(wp), parameter :: shortest = 1e-8_wp

   !> What the right side needs. Where GSL calls it, its address must stay.
   type :: problem_type
      type(forces_type) :: forces
      logical :: is_taut = .true.
      real(wp) :: base(3) = 0         !! In flight where it began, so that its first stretch has all its digits; else 0
      real(wp) :: slack = 0           !! In flight: (radius**2 - s**2)/2 of where it began [m2]
      real(wp) :: tension = 0         !! At the right side evaluated last
      integer :: drag_work = 0        !! Its place among the unknowns; 0: not asked for
      integer :: pivot_work = 0
      integer :: unknowns = 6
      integer(int64) :: evaluations = 0 !! Of the right side
      type(forces_change_type), allocatable :: changes(:) !! (p) of columns that are integrated too
   end type problem_type

   !> GSL's arrays, of which the first `problem%unknowns` are there: known to be contiguous.
   type :: numbers_type
      real(c_double) :: number(unknowns) = 0
   end type numbers_type

   !> An integration between two steps.
   type :: stepper_type
      type(problem_type), pointer :: problem => null()
      real(wp) :: time = 0, y(unknowns) = 0, rates(unknowns) = 0, tension = 0           !! Now
      real(wp) :: start = 0, start_y(unknowns) = 0, start_rates(unknowns) = 0, start_tension = 0 !! Before the last step
      real(wp) :: next = 0                  !! Length of the next step [s]
      real(wp) :: time_scale = 0            !! In which the bob moves by its length [s]
      integer(int64) :: rejected = 0        !! Steps repeated with a shorter length
      !> Derivatives of position and velocity now, before the last step, and of the step that is tried; with their rates
      real(wp), allocatable, dimension(:, :) :: columns, column_rates, start_columns, start_column_rates !! (6, p)
      real(wp), allocatable, dimension(:, :) :: trial_columns, trial_column_rates                        !! (6, p)
      !> The largest that each column has been, in units of the scales; not allocated: there are none
      real(wp), allocatable :: sizes(:)
      real(wp) :: scales(3) = 1             !! Of positions, velocities and works
      type(fgsl_odeiv2_system) :: system
      type(fgsl_odeiv2_step) :: step
      type(fgsl_odeiv2_control) :: control
   end type stepper_type

contains

   !> A start at time 0.
   subroutine new_stepper(stepper, forces, is_taut, with_work, position, velocity, tolerance, scales, first_step)
      type(stepper_type), intent(inout) :: stepper
      type(forces_type), intent(in) :: forces
      logical, intent(in) :: is_taut
      logical, intent(in) :: with_work                  !! Whether works are integrated too
      real(wp), intent(in) :: position(3), velocity(3)  !! [m], [m/s]
      real(wp), intent(in) :: tolerance                 !! Of the error of a step, in units of the scales
      real(wp), intent(in) :: scales(3)                 !! Of places, velocities and works
      real(wp), intent(in) :: first_step                !! [s]
      real(wp) :: scale(unknowns)

      call free_stepper(stepper)
      allocate (stepper%problem)
      associate (problem => stepper%problem)
         problem%forces = forces
         problem%is_taut = is_taut
         if (with_work .and. forces%has_drag) then
            problem%unknowns = problem%unknowns + 1
            problem%drag_work = problem%unknowns
         end if
         if (with_work .and. (forces%has_moving_pivot .or. forces%has_hoist)) then
            problem%unknowns = problem%unknowns + 1
            problem%pivot_work = problem%unknowns
         end if
         problem%forces%needs_pivot_velocity = forces%has_moving_pivot .and. &
            (with_work .or. forces%has_drag .or. forces%has_turn)
         scale = [scales(1), scales(1), scales(1), scales(2), scales(2), scales(2), scales(3), scales(3)]
         stepper%system = fgsl_odeiv2_system_init(right_side, int(problem%unknowns, c_size_t), c_loc(stepper%problem))
         stepper%step = fgsl_odeiv2_step_alloc(fgsl_odeiv2_step_rk8pd, int(problem%unknowns, c_size_t))
         stepper%control = fgsl_odeiv2_control_scaled_new(tolerance, 0.0_wp, 1.0_wp, 0.0_wp, scale(:problem%unknowns))
      end associate
      stepper%time = 0
      stepper%rejected = 0
      stepper%y = [position, velocity, 0.0_wp, 0.0_wp]
      stepper%next = first_step
      stepper%time_scale = scales(1)/scales(2)
      stepper%scales = scales
      call restart(stepper)
   end subroutine new_stepper

   !> From the start on, columns too.
   subroutine add_columns(stepper, changes, columns, sizes, tolerance)
      type(stepper_type), intent(inout) :: stepper         !! As `new_stepper` leaves it
      type(forces_change_type), intent(in) :: changes(:)   !! (p)
      real(wp), intent(in) :: columns(:, :)                !! (6, p) at the start
      real(wp), intent(in) :: sizes(:)                     !! (p) in units of the scales: errors are small beside them
      real(wp), intent(in) :: tolerance
      real(wp), allocatable :: scale(:)
      integer :: n, p

      n = stepper%problem%unknowns
      p = size(changes)
      stepper%problem%changes = changes
      ! The surface counts the time of a length that may begin to grow.
      if (any(abs(changes%suspension%growth) > 0)) stepper%problem%forces%has_hoist = .true.
      stepper%problem%forces%needs_pivot_velocity = stepper%problem%forces%has_moving_pivot
      stepper%columns = columns
      stepper%sizes = sizes
      allocate (stepper%column_rates(6, p), stepper%trial_columns(6, p), stepper%trial_column_rates(6, p))
      allocate (scale(n + 6*p))
      scale(:n) = pack([spread(stepper%scales(1), 1, 3), spread(stepper%scales(2), 1, 3), &
         spread(stepper%scales(3), 1, n - 6)], .true.)
      scale(n + 1:) = pack(spread([spread(stepper%scales(1), 1, 3), spread(stepper%scales(2), 1, 3)], 2, p), .true.)
      call free_gsl(stepper)
      stepper%system = fgsl_odeiv2_system_init(right_side_with_columns, int(size(scale), c_size_t), &
         c_loc(stepper%problem))
      stepper%step = fgsl_odeiv2_step_alloc(fgsl_odeiv2_step_rk8pd, int(size(scale), c_size_t))
      stepper%control = fgsl_odeiv2_control_scaled_new(tolerance, 0.0_wp, 1.0_wp, 0.0_wp, scale)
      call restart(stepper)
   end subroutine add_columns

   subroutine free_stepper(stepper)
      type(stepper_type), intent(inout) :: stepper

      if (.not. associated(stepper%problem)) return
      call free_gsl(stepper)
      deallocate (stepper%problem)
      if (.not. allocated(stepper%sizes)) return
      deallocate (stepper%columns, stepper%column_rates, stepper%start_columns, stepper%start_column_rates, &
         stepper%trial_columns, stepper%trial_column_rates, stepper%sizes)
   end subroutine free_stepper

   subroutine free_gsl(stepper)
      type(stepper_type), intent(inout) :: stepper

      call fgsl_odeiv2_control_free(stepper%control)
      call fgsl_odeiv2_step_free(stepper%step)
      call fgsl_odeiv2_system_free(stepper%system)
   end subroutine free_gsl

   !> After a change of state or of the problem: the rates anew, and no step before.
   subroutine restart(stepper)
      type(stepper_type), intent(inout) :: stepper

      call find_rates(stepper%problem, stepper%time, stepper%y, stepper%rates)
      stepper%tension = stepper%problem%tension
      if (allocated(stepper%sizes)) then
         call find_column_rates(stepper%problem, stepper%time, stepper%y, stepper%columns, stepper%column_rates)
         stepper%start_columns = stepper%columns
         stepper%start_column_rates = stepper%column_rates
      end if
      stepper%start = stepper%time
      stepper%start_y = stepper%y
      stepper%start_rates = stepper%rates
      stepper%start_tension = stepper%tension
   end subroutine restart

   !> From here the bob flies, its place counted from here.
   pure subroutine let_go(problem, place)
      type(problem_type), intent(inout) :: problem
      real(wp), intent(inout) :: place(3)

      problem%is_taut = .false.
      problem%base = place
      place = 0
   end subroutine let_go

   !> One step, not beyond `limit`. Fails where the steps become too short.
   subroutine take_step(stepper, limit, failed)
      type(stepper_type), intent(inout) :: stepper
      real(wp), intent(in) :: limit             !! Later than now [s]
      logical, intent(out) :: failed
      real(wp) :: h, wanted, ends, y(unknowns), rates(unknowns), errors(unknowns)
      logical :: is_cut, is_good
      integer :: n, status, change

      failed = .false.
      n = stepper%problem%unknowns
      h = stepper%next
      do
         is_cut = stepper%time + h >= limit
         ends = stepper%time + h
         if (is_cut) ends = limit
         ! Exact: times add up without error.
         h = ends - stepper%time
         wanted = h
         if (allocated(stepper%sizes)) then
            call try_with_columns(stepper, h, y, rates, wanted, is_good)
            if (is_good) exit
            h = wanted
            stepper%rejected = stepper%rejected + 1
            if (.not. h > max(shortest*stepper%time_scale, spacing(stepper%time))) failed = .true.
            if (failed) return
            cycle
         end if
         y = stepper%y
         status = fgsl_odeiv2_step_apply(stepper%step, stepper%time, h, y(:n), errors(:n), stepper%rates(:n), &
            rates(:n), stepper%system)
         ! Errors that are numbers say that the state is one.
         if (status == 0 .and. all(is_finite(errors(:n)))) then
            change = fgsl_odeiv2_control_hadjust(stepper%control, stepper%step, y(:n), errors(:n), rates(:n), wanted)
            if (.not. (change < 0 .and. wanted < h)) exit
         else
            ! As GSL's driver after a failure of the right side.
            wanted = h/2
         end if
         h = wanted
         stepper%rejected = stepper%rejected + 1
         if (.not. h > max(shortest*stepper%time_scale, spacing(stepper%time))) then
            failed = .true.
            return
         end if
      end do
      ! A step cut short tells of longer ones only.
      if (wanted > stepper%next .or. .not. is_cut) stepper%next = wanted
      call accept(stepper, ends, y, rates)
   end subroutine take_step

   !> A step with columns, their errors in units of the largest they have been; `wanted` is what GSL makes of the step.
   subroutine try_with_columns(stepper, h, y, rates, wanted, is_good)
      type(stepper_type), intent(inout) :: stepper
      real(wp), intent(in) :: h
      real(wp), intent(out) :: y(unknowns), rates(unknowns)
      real(wp), intent(inout) :: wanted                    !! h before
      logical, intent(out) :: is_good
      real(wp), dimension(stepper%problem%unknowns + size(stepper%columns)) :: z, z_rates, errors
      integer :: n, j, status, change

      n = stepper%problem%unknowns
      call step_joint(stepper, stepper%time, h, stepper%y, stepper%columns, stepper%rates, stepper%column_rates, z, &
         z_rates, errors, status)
      y = 0
      rates = 0
      y(:n) = z(:n)
      rates(:n) = z_rates(:n)
      is_good = status == 0 .and. sum(abs(errors)) <= huge(h)
      if (is_good) then
         do j = 1, size(stepper%sizes)
            errors(n + 6*j - 5:n + 6*j) = errors(n + 6*j - 5:n + 6*j)/stepper%sizes(j)
         end do
         change = fgsl_odeiv2_control_hadjust(stepper%control, stepper%step, z, errors, z_rates, wanted)
         is_good = .not. (change < 0 .and. wanted < h)
         stepper%trial_columns = reshape(z(n + 1:), shape(stepper%columns))
         stepper%trial_column_rates = reshape(z_rates(n + 1:), shape(stepper%columns))
      else
         wanted = h/2
      end if
   end subroutine try_with_columns

   !> GSL's step of state and columns together.
   subroutine step_joint(stepper, time, h, y, columns, rates, column_rates, z, z_rates, errors, status)
      type(stepper_type), intent(in) :: stepper
      real(wp), intent(in) :: time, h
      real(wp), intent(in) :: y(unknowns), columns(:, :), rates(unknowns), column_rates(:, :)
      real(wp), intent(out), contiguous :: z(:), z_rates(:), errors(:)
      integer, intent(out) :: status
      real(wp) :: old_rates(size(z))
      integer :: n

      n = stepper%problem%unknowns
      z(:n) = y(:n)
      z(n + 1:) = pack(columns, .true.)
      old_rates(:n) = rates(:n)
      old_rates(n + 1:) = pack(column_rates, .true.)
      z_rates = 0
      errors = 0
      status = fgsl_odeiv2_step_apply(stepper%step, time, h, z, errors, old_rates, z_rates, stepper%system)
   end subroutine step_joint

   !> One step of a given length from where the last one began, unchecked: for a place between its ends.
   subroutine trial_step(stepper, h, y, rates, tension)
      type(stepper_type), intent(in) :: stepper
      real(wp), intent(in) :: h                 !! Up to the length of the last step [s]
      real(wp), intent(out) :: y(unknowns), rates(unknowns)
      real(wp), intent(out) :: tension          !! [m/s2]
      real(wp) :: errors(unknowns)
      real(wp), allocatable :: columns(:, :), column_rates(:, :)
      integer :: n, status

      if (allocated(stepper%sizes)) then
         allocate (columns, column_rates, mold=stepper%columns)
         call trial_with_columns(stepper, h, y, rates, tension, columns, column_rates)
         return
      end if
      n = stepper%problem%unknowns
      y = stepper%start_y
      rates = 0
      status = fgsl_odeiv2_step_apply(stepper%step, stepper%start, h, y(:n), errors(:n), stepper%start_rates(:n), &
         rates(:n), stepper%system)
      tension = stepper%problem%tension
      call put_back(stepper%problem, y)
   end subroutine trial_step

   !> The same with columns.
   subroutine trial_with_columns(stepper, h, y, rates, tension, columns, column_rates)
      type(stepper_type), intent(in) :: stepper
      real(wp), intent(in) :: h
      real(wp), intent(out) :: y(unknowns), rates(unknowns), tension
      real(wp), intent(out) :: columns(:, :), column_rates(:, :) !! (6, p)
      real(wp), dimension(stepper%problem%unknowns + size(stepper%columns)) :: z, z_rates, errors
      integer :: n, status

      n = stepper%problem%unknowns
      call step_joint(stepper, stepper%start, h, stepper%start_y, stepper%start_columns, stepper%start_rates, &
         stepper%start_column_rates, z, z_rates, errors, status)
      y = 0
      rates = 0
      y(:n) = z(:n)
      rates(:n) = z_rates(:n)
      tension = stepper%problem%tension
      columns = reshape(z(n + 1:), shape(columns))
      column_rates = reshape(z_rates(n + 1:), shape(column_rates))
      call put_columns_back(stepper%problem, y, columns)
      call put_back(stepper%problem, y)
      column_rates(1:3, :) = columns(4:6, :)
   end subroutine trial_with_columns

   !> Makes a state at a later time the present one.
   subroutine accept(stepper, time, y, rates)
      type(stepper_type), intent(inout) :: stepper
      real(wp), intent(in) :: time, y(unknowns), rates(unknowns)

      stepper%start = stepper%time
      stepper%start_y = stepper%y
      stepper%start_rates = stepper%rates
      stepper%start_tension = stepper%tension
      stepper%time = time
      stepper%y = y
      stepper%rates = rates
      stepper%tension = stepper%problem%tension
      if (allocated(stepper%sizes)) call accept_columns(stepper)
      call put_back(stepper%problem, stepper%y)
      stepper%rates(1:3) = stepper%y(4:6)
   end subroutine accept

   !> Those of the step that was tried, before its state is put back.
   subroutine accept_columns(stepper)
      type(stepper_type), intent(inout) :: stepper
      integer :: j

      stepper%start_columns = stepper%columns
      stepper%start_column_rates = stepper%column_rates
      stepper%columns = stepper%trial_columns
      stepper%column_rates = stepper%trial_column_rates
      call put_columns_back(stepper%problem, stepper%y, stepper%columns)
      stepper%column_rates(1:3, :) = stepper%columns(4:6, :)
      do j = 1, size(stepper%sizes)
         stepper%sizes(j) = max(stepper%sizes(j), norm2(stepper%columns(1:3, j))/stepper%scales(1), &
            norm2(stepper%columns(4:6, j))/stepper%scales(2))
      end do
   end subroutine accept_columns

   !> What `put_back` makes of the columns.
   pure subroutine put_columns_back(problem, y, columns)
      type(problem_type), intent(in) :: problem
      real(wp), intent(in) :: y(unknowns)                  !! Before it
      real(wp), intent(inout) :: columns(:, :)
      integer :: j

      if (.not. problem%is_taut .or. problem%forces%is_elastic) return
      do j = 1, size(problem%changes)
         call surface_change(problem%forces%suspension, problem%changes(j)%suspension, y(1:3), y(4:6), &
            columns(1:3, j), columns(4:6, j))
      end do
   end subroutine put_columns_back

   pure subroutine put_back(problem, y)
      type(problem_type), intent(in) :: problem
      real(wp), intent(inout) :: y(unknowns)

      if (problem%is_taut .and. .not. problem%forces%is_elastic) &
         call put_on_surface(problem%forces%suspension, y(1:3), y(4:6))
   end subroutine put_back

   !> Of drag and pivot, among the unknowns; zero where they are not asked for.
   pure function works(problem, y) result(work)
      type(problem_type), intent(in) :: problem
      real(wp), intent(in) :: y(:)
      real(wp) :: work(2)

      work = 0
      if (problem%drag_work > 0) work(1) = y(problem%drag_work)
      if (problem%pivot_work > 0) work(2) = y(problem%pivot_work)
   end function works

   subroutine find_rates(problem, time, y, rates)
      type(problem_type), intent(inout) :: problem
      real(wp), intent(in) :: time, y(unknowns)
      real(wp), intent(inout) :: rates(unknowns)
      real(wp) :: powers(2)

      ! The place counts for a taut rod or string only, and then the base is zero.
      call move(problem%forces, problem%is_taut, time, y(1:3), y(4:6), rates(4:6), problem%tension, powers)
      rates(1) = y(4)
      rates(2) = y(5)
      rates(3) = y(6)
      if (problem%drag_work > 0) rates(problem%drag_work) = powers(1)
      if (problem%pivot_work > 0) rates(problem%pivot_work) = powers(2)
   end subroutine find_rates

   !> The variational equations, after `find_rates` for the same state.
   pure subroutine find_column_rates(problem, time, y, columns, rates)
      type(problem_type), intent(in) :: problem
      real(wp), intent(in) :: time, y(:)
      real(wp), intent(in) :: columns(:, :)
      real(wp), intent(out) :: rates(:, :)
      real(wp) :: accelerations(3, size(columns, 2)), tensions(size(columns, 2))

      call move_changes(problem%forces, problem%changes, problem%is_taut, time, y(1:3), y(4:6), columns, &
         accelerations, tensions)
      rates(1:3, :) = columns(4:6, :)
      rates(4:6, :) = accelerations
   end subroutine find_column_rates

   !> dy/dt for GSL.
   function right_side(t, y, dydt, params) bind(c, name='') result(status)
      real(c_double), value :: t
      type(c_ptr), value :: y, dydt, params
      integer(c_int) :: status
      type(numbers_type), pointer :: u, du
      type(problem_type), pointer :: problem

      call c_f_pointer(params, problem)
      call c_f_pointer(y, u)
      call c_f_pointer(dydt, du)
      call find_rates(problem, t, u%number, du%number)
      problem%evaluations = problem%evaluations + 1
      status = merge(1, 0, problem%forces%is_beyond)
   end function right_side

   !> The same with columns behind the state.
   function right_side_with_columns(t, y, dydt, params) bind(c, name='') result(status)
      real(c_double), value :: t
      type(c_ptr), value :: y, dydt, params
      integer(c_int) :: status
      real(c_double), pointer, contiguous :: u(:), du(:), columns(:, :), rates(:, :)
      type(problem_type), pointer :: problem
      real(wp) :: state(unknowns), state_rates(unknowns)
      integer :: n, p

      call c_f_pointer(params, problem)
      n = problem%unknowns
      p = size(problem%changes)
      call c_f_pointer(y, u, [n + 6*p])
      call c_f_pointer(dydt, du, [n + 6*p])
      columns(1:6, 1:p) => u(n + 1:)
      rates(1:6, 1:p) => du(n + 1:)
      state = 0
      state_rates = 0
      state(:n) = u(:n)
      call find_rates(problem, t, state, state_rates)
      du(:n) = state_rates(:n)
      call find_column_rates(problem, t, state, columns, rates)
      problem%evaluations = problem%evaluations + 1
      status = merge(1, 0, problem%forces%is_beyond)
   end function right_side_with_columns

end module kyvadlo_stepper
