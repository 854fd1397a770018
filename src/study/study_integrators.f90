!> Places by GSL's integrators, from the start to every time in turn.
module kyvadlo_study_integrators
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use, intrinsic :: iso_c_binding, only: c_double, c_loc
   use, intrinsic :: iso_fortran_env, only: real64, real128
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_status, only: error_type
   use kyvadlo_gsl
   use kyvadlo_study_orbits, only: study_orbit_type, n_times, one_period
   use kyvadlo_study_places, only: places_type, ask, farthest, span_questions
   use kyvadlo_study_rates
   use kyvadlo_study_record, only: cell_type, study_type, add_cell, capped, out_of_time
   use kyvadlo_study_set_up, only: set_up_orbit
   implicit none
   private
   public :: ask_integrators

   character(len=*), parameter :: method_names(5) = [character(len=11) :: 'gsl_rk4', 'gsl_rkf45', 'gsl_rk8pd', &
      'gsl_msadams', 'gsl_bsimp']
   character(len=*), parameter :: coordinate_names(2) = [character(len=9) :: 'cartesian', 'spherical']
   integer, parameter :: cartesian = 1, spherical = 2

   type, extends(places_type) :: integrator_type
      integer :: method = 1, coordinates = cartesian
      real(real64) :: tolerance = 0      !! Of the local error: of places and speeds per l, of angles and their rates
      real(real64), dimension(n_times) :: x = 0, y = 0, z = 0
   contains
      procedure :: pass => integrator_pass
      procedure :: error => integrator_error
   end type integrator_type

   !> Between two looks at the clock.
   integer(fgsl_long), parameter :: steps_at_once = 500
   !> GSL_EMAXITER: so many steps were not enough, but nothing else is wrong.
   integer(fgsl_int), parameter :: out_of_steps = 11

contains

   !> Every method in both coordinates at tolerances from 1e-3 to 1e-14; at fewer over 1000 periods, where a cell takes
   !> as long as the cap lets it. Behind a tolerance that took too long the tighter ones are not tried.
   subroutine ask_integrators(study, orbit, span)
      type(study_type), intent(inout) :: study
      type(study_orbit_type), intent(in) :: orbit
      integer, intent(in) :: span
      type(integrator_type), allocatable :: work
      character(len=24) :: setting
      integer :: method, coordinates, digits
      logical :: is_too_long

      allocate (work)
      do method = 1, size(method_names)
         do coordinates = cartesian, spherical
            is_too_long = .false.
            do digits = 3, 14
               if (.not. is_asked(study%quick, span, coordinates, digits)) cycle
               work%method = method
               work%coordinates = coordinates
               work%tolerance = 10.0_real64**(-digits)
               write (setting, '(a,a,i0)') trim(coordinate_names(coordinates)), ' 1e-', digits
               if (is_too_long) then
                  call add_cell(study, cell_type(question=span_questions(span), orbit=orbit%name, &
                     method=method_names(method), setting=setting, kind='real64', outcome=capped))
               else
                  call ask(study, work, orbit, span, trim(method_names(method)), trim(setting), 'real64')
                  is_too_long = study%cells(study%count)%outcome == capped
               end if
            end do
         end do
      end do
   end subroutine ask_integrators

   !> Whether a tolerance of 10**(-digits) is among those of a study.
   pure logical function is_asked(quick, span, coordinates, digits)
      logical, intent(in) :: quick
      integer, intent(in) :: span, coordinates, digits
      integer, parameter :: quick_digits(3) = [3, 6, 9], long_digits(7) = [3, 5, 7, 9, 11, 13, 14]

      if (span == one_period) then
         is_asked = .not. quick .or. any(digits == quick_digits)
      else if (quick) then
         is_asked = digits == quick_digits(2) .and. coordinates == cartesian
      else
         is_asked = any(digits == long_digits)
      end if
   end function is_asked

   !> In Cartesian coordinates the bob slips off the sphere, the farther the longer: it is put back once a period.
   subroutine integrator_pass(work)
      class(integrator_type), intent(inout) :: work
      type(problem_type), target :: problem
      type(error_type), allocatable :: error
      type(orbit_type) :: orbit
      type(fgsl_odeiv2_system) :: system
      type(fgsl_odeiv2_driver) :: driver
      real(c_double) :: t, radius, period
      real(c_double), allocatable :: y(:)
      integer(fgsl_int) :: status
      integer :: i

      call set_up_orbit(work%start, orbit, error)
      work%has_failed = allocated(error)
      if (work%has_failed) return
      problem%length = work%start%length
      problem%gravity = work%start%gravity
      problem%momentum = orbit%momentum()/problem%length**2
      if (work%coordinates == cartesian) then
         radius = sqrt(orbit%turning%upper_rise*orbit%turning%upper_gap)
         y = [radius, 0.0_c_double, orbit%turning%upper, 0.0_c_double, orbit%momentum()/radius, 0.0_c_double]
         system = fgsl_odeiv2_system_init(cartesian_rates, 6_fgsl_size_t, c_loc(problem), cartesian_jacobian)
      else
         y = [2*atan2(sqrt(orbit%turning%upper_rise), sqrt(orbit%turning%upper_gap)), 0.0_c_double, 0.0_c_double]
         system = fgsl_odeiv2_system_init(spherical_rates, 3_fgsl_size_t, c_loc(problem), spherical_jacobian)
      end if
      ! A first step far below the shortest time scale; GSL adapts it at once.
      driver = fgsl_odeiv2_driver_alloc_y_new(system, step_of(work%method), &
         1e-3_c_double*sqrt(problem%length/problem%gravity), work%tolerance*merge(problem%length, 1.0_c_double, &
         work%coordinates == cartesian), 0.0_c_double)
      status = fgsl_odeiv2_driver_set_nmax(driver, steps_at_once)
      t = 0
      if (work%coordinates == cartesian) then
         period = orbit%period()
         do i = 1, int(work%times(1)/period)
            call go_on(i*period)
            if (work%has_failed .or. work%is_capped) exit
            call put_on_sphere(problem%length, y)
            status = fgsl_odeiv2_driver_reset(driver)
         end do
      end if
      do i = 1, n_times
         if (work%has_failed .or. work%is_capped) exit
         call go_on(work%times(i))
         if (work%coordinates == cartesian) then
            work%x(i) = y(1)
            work%y(i) = y(2)
            work%z(i) = y(3)
         else
            work%x(i) = problem%length*sin(y(1))*cos(y(3))
            work%y(i) = problem%length*sin(y(1))*sin(y(3))
            work%z(i) = -problem%length*cos(y(1))
         end if
      end do
      call fgsl_odeiv2_driver_free(driver)
      call fgsl_odeiv2_system_free(system)
      work%evaluations = problem%evaluations
      work%sink = work%sink + sum(work%x) + sum(work%y) + sum(work%z)

   contains

      !> Carries y on to a time, with a look at the clock now and then.
      subroutine go_on(time)
         real(c_double), intent(in) :: time

         do
            status = fgsl_odeiv2_driver_apply(driver, t, time, y)
            if (status /= out_of_steps) exit
            work%is_capped = out_of_time(work)
            if (work%is_capped) return
         end do
         work%has_failed = status /= fgsl_success .or. .not. all(ieee_is_finite(y))
      end subroutine go_on
   end subroutine integrator_pass

   !> The nearest point of the sphere, and of its tangent plane there.
   pure subroutine put_on_sphere(length, y)
      real(c_double), intent(in) :: length
      real(c_double), intent(inout) :: y(:)   !! Place and velocity

      y(1:3) = y(1:3)*(length/norm2(y(1:3)))
      y(4:6) = y(4:6) - dot_product(y(1:3), y(4:6))/length**2*y(1:3)
   end subroutine put_on_sphere

   type(fgsl_odeiv2_step_type) function step_of(method)
      integer, intent(in) :: method

      select case (method)
      case (1)
         step_of = fgsl_odeiv2_step_rk4
      case (2)
         step_of = fgsl_odeiv2_step_rkf45
      case (3)
         step_of = fgsl_odeiv2_step_rk8pd
      case (4)
         step_of = fgsl_odeiv2_step_msadams
      case default
         step_of = fgsl_odeiv2_step_bsimp
      end select
   end function step_of

   function integrator_error(work) result(error)
      class(integrator_type), intent(in) :: work
      real(real64) :: error

      error = farthest(work, real(work%x, real128), real(work%y, real128), real(work%z, real128))
   end function integrator_error

end module kyvadlo_study_integrators
