!> The motion under effects that have no closed form: Newton's equations on the sphere in Cartesian coordinates, by GSL.
!>
!> The rod's force follows from the constraint (p.a + v.v = 0), so no coordinate is singular anywhere on the sphere; at every
!> requested time the state is put back on it, which removes what the steps between have let slip.
module kyvadlo_integrator
   use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_int, c_loc, c_long, c_ptr, c_size_t
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_quiet_nan, ieee_value
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_status, only: error_type, fail, code_domain, code_unsupported
   use kyvadlo_effects, only: effects_type, applied_acceleration, drag_acceleration, pivot_acceleration
   use kyvadlo_gsl, only: fgsl_odeiv2_system, fgsl_odeiv2_system_init, fgsl_odeiv2_system_free, fgsl_odeiv2_driver, &
      fgsl_odeiv2_driver_alloc_y_new, fgsl_odeiv2_driver_apply, fgsl_odeiv2_driver_free, fgsl_odeiv2_driver_set_nmax, &
      fgsl_odeiv2_driver_reset, fgsl_odeiv2_step_rk8pd
   implicit none
   private
   public :: integrate

   !> What the right side needs.
   type :: problem_type
      type(effects_type) :: effects
      real(wp) :: gravity = 0
   end type problem_type

   !> Position, velocity, and the work of drag and of the pivot per mass.
   integer(c_size_t), parameter :: unknowns = 8
   !> Steps between two requested times; a swing takes some tens of them at the tightest tolerance.
   integer(c_long), parameter :: most_steps = 10000000

contains

   !> Position and velocity relative to the pivot at ascending times, from a start at t = 0.
   !>
   !> GSL's Runge-Kutta-Prince-Dormand method of order 8 with the local error per step below `tolerance`, relative to length and to
   !> sqrt(gravity length). Failure: a start off the sphere, a tolerance outside 1e-15 ... 0.1, times that do not ascend from
   !> 0, or the integrator's own.
   subroutine integrate(effects, length, gravity, start_position, start_velocity, times, tolerance, positions, velocities, &
         tensions, drag_work, pivot_work, error)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: length, gravity                   !! [m], [m/s2]
      real(wp), intent(in) :: start_position(3), start_velocity(3) !! On the sphere, tangential
      real(wp), intent(in) :: times(:)                          !! (n) [s]
      real(wp), intent(in) :: tolerance                         !! Of the local error
      real(wp), intent(out) :: positions(:, :), velocities(:, :) !! (3, n)
      real(wp), intent(out) :: tensions(:)                      !! (n) rod force over mass [m/s2]
      real(wp), intent(out) :: drag_work(:), pivot_work(:)      !! (n) since t = 0, per mass [m2/s2]
      type(error_type), allocatable, intent(out) :: error
      type(problem_type), target :: problem
      type(fgsl_odeiv2_system) :: system
      type(fgsl_odeiv2_driver) :: driver
      real(c_double) :: t, y(unknowns), unit_time, unit_speed
      integer(c_int) :: status
      integer :: i

      drag_work = ieee_value(drag_work, ieee_quiet_nan)
      pivot_work = ieee_value(pivot_work, ieee_quiet_nan)
      tensions = ieee_value(tensions, ieee_quiet_nan)
      positions = ieee_value(positions, ieee_quiet_nan)
      velocities = ieee_value(velocities, ieee_quiet_nan)
      if (.not. (length > 0 .and. gravity > 0 .and. ieee_is_finite(length) .and. ieee_is_finite(gravity))) then
         call fail(error, code_domain, 'integrate: length and gravity must be positive and finite, got'//listed([length, gravity]))
      else if (.not. (tolerance >= 1e-15_wp .and. tolerance <= 0.1_wp)) then
         call fail(error, code_domain, 'integrate: the tolerance must lie between 1e-15 and 0.1, got'//listed([tolerance]))
      else if (.not. abs(norm2(start_position) - length) <= 1e-12_wp*length) then
         call fail(error, code_domain, 'integrate: the start must lie on the sphere, got the distance and the length'// &
            listed([norm2(start_position), length]))
      else if (size(times) > 0) then
         if (.not. (times(1) >= 0 .and. all(times(2:) >= times(:size(times) - 1)) .and. all(ieee_is_finite(times)))) &
            call fail(error, code_domain, 'integrate: the times must ascend from 0')
      end if
      if (allocated(error)) return

      ! In units of length and sqrt(length/gravity), so that one tolerance serves every component.
      unit_time = sqrt(length/gravity)
      unit_speed = sqrt(length*gravity)
      problem%gravity = 1
      problem%effects = effects
      problem%effects%linear_drag = effects%linear_drag*unit_time
      problem%effects%quadratic_drag = effects%quadratic_drag*length
      problem%effects%wind = effects%wind/unit_speed
      problem%effects%turn_rate = effects%turn_rate*unit_time
      problem%effects%pivot_amplitude = effects%pivot_amplitude/length
      problem%effects%pivot_frequency = effects%pivot_frequency*unit_time

      system = fgsl_odeiv2_system_init(right_side, unknowns, c_loc(problem))
      driver = fgsl_odeiv2_driver_alloc_y_new(system, fgsl_odeiv2_step_rk8pd, 1e-3_c_double, tolerance, 0.0_c_double)
      status = fgsl_odeiv2_driver_set_nmax(driver, most_steps)
      t = 0
      y = [start_position/length, start_velocity/unit_speed, 0.0_c_double, 0.0_c_double]
      do i = 1, size(times)
         if (times(i)/unit_time > t) status = fgsl_odeiv2_driver_apply(driver, t, times(i)/unit_time, y)
         if (status /= 0 .or. .not. all(ieee_is_finite(y))) then
            call fail(error, code_unsupported, 'integrate: the integrator gave up; a larger tolerance may help')
            exit
         end if
         call put_on_sphere(y)
         status = fgsl_odeiv2_driver_reset(driver)
         positions(:, i) = length*y(1:3)
         velocities(:, i) = unit_speed*y(4:6)
         tensions(i) = gravity*tension(problem, t, y)
         drag_work(i) = unit_speed**2*y(7)
         pivot_work(i) = unit_speed**2*y(8)
      end do
      call fgsl_odeiv2_driver_free(driver)
      call fgsl_odeiv2_system_free(system)
   end subroutine integrate

   !> Numbers for a message, a blank before each.
   pure function listed(numbers) result(text)
      real(wp), intent(in) :: numbers(:)
      character(len=24*size(numbers)) :: text

      write (text, '(*(es24.16))') numbers
   end function listed

   !> The nearest point of the unit sphere, and of its tangent plane there.
   pure subroutine put_on_sphere(y)
      real(c_double), intent(inout) :: y(:)

      y(1:3) = y(1:3)/norm2(y(1:3))
      y(4:6) = y(4:6) - dot_product(y(1:3), y(4:6))*y(1:3)
   end subroutine put_on_sphere

   !> Rod force over mass: what the constraint needs, p.(applied) + v.v over |p|.
   pure real(c_double) function tension(problem, t, y)
      type(problem_type), intent(in) :: problem
      real(c_double), intent(in) :: t, y(:)

      tension = (dot_product(y(1:3), applied_acceleration(problem%effects, problem%gravity, t, y(4:6))) &
         + dot_product(y(4:6), y(4:6)))/norm2(y(1:3))
   end function tension

   !> dy/dt for GSL.
   function right_side(t, y, dydt, params) bind(c) result(status)
      real(c_double), value :: t
      type(c_ptr), value :: y, dydt, params
      integer(c_int) :: status
      real(c_double), pointer :: u(:), du(:)
      type(problem_type), pointer :: problem
      real(c_double) :: applied(3)

      call c_f_pointer(y, u, [unknowns])
      call c_f_pointer(dydt, du, [unknowns])
      call c_f_pointer(params, problem)
      applied = applied_acceleration(problem%effects, problem%gravity, t, u(4:6))
      du(1:3) = u(4:6)
      du(4:6) = applied - u(1:3)*(dot_product(u(1:3), applied) + dot_product(u(4:6), u(4:6)))/dot_product(u(1:3), u(1:3))
      ! In the pivot's frame its acceleration works as a force does.
      du(7) = dot_product(drag_acceleration(problem%effects, t, u(4:6)), u(4:6))
      du(8) = -dot_product(pivot_acceleration(problem%effects, t), u(4:6))
      status = 0
   end function right_side

end module kyvadlo_integrator
