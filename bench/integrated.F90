!> `kyvadlo-bench --integrated`: what scenes without a closed form cost, beside GSL's driver with the same method and
!> tolerance, its forces as a user would write them down.
module kyvadlo_bench_integrated
#ifdef KYVADLO_WITH_GSL
   use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_int, c_loc, c_ptr
   use kyvadlo_effects, only: earth_turn_rate, effects_type
   use kyvadlo_gsl
   use kyvadlo_integrator, only: integration_type, new_integration
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_status, only: error_type
   use kyvadlo_stopwatch, only: median
#endif
   implicit none
   private
   public :: bench_integrated

#ifdef KYVADLO_WITH_GSL
   !> The pendulum of all scenes, as in `bench/integrated_beside_heyoka.py`. A period is that of its small swings.
   real(wp), parameter :: length = 1, gravity = 9.81_wp, latitude = 48.85_wp
   real(wp), parameter :: position(3) = [0.6_wp, 0.0_wp, -0.8_wp], velocity(3) = [0.0_wp, 1.5_wp, 0.0_wp]
   real(wp), parameter :: period = 8*atan(1.0_wp)*sqrt(length/gravity)
   integer, parameter :: drag = 1, earth = 2, spring = 3, pivot = 4
   character(len=*), parameter :: names(4) = [character(len=6) :: 'drag', 'Earth', 'spring', 'pivot']
   integer, parameter :: spans(3) = [1, 100, 10000]
   real(wp), parameter :: tolerances(3) = [1e-6_wp, 1e-9_wp, 1e-12_wp]

   !> What the driver's right side needs.
   type :: problem_type
      integer :: scene = drag
      type(effects_type) :: effects
   end type problem_type
#endif

contains

   !> The motion at the end of a span, nothing in between: processor time, medians of runs taken in turn.
   subroutine bench_integrated(unit, quick)
      integer, intent(in) :: unit    !! Where to print
      logical, intent(in) :: quick   !! One run each and no long span: to see that it runs, not to measure
#ifdef KYVADLO_WITH_GSL
      integer :: scene, span, digits

      write (unit, '(a,/,a,/,/,a6,a9,a11,2a11,a8,a12,2x,a)') &
         'Integrated scenes, the state at the end of a span: microseconds a period, ours and by the driver of GSL', &
         '(same method and tolerance, its forces as a user would write them), how far the ends differ, and ours.', &
         'scene', 'periods', 'tolerance', 'ours', 'driver', 'times', 'difference', 'x, y, z [m]'
      do scene = 1, size(names)
         do span = 1, merge(2, size(spans), quick)
            do digits = 1, size(tolerances)
               call measure(unit, quick, scene, spans(span), tolerances(digits))
            end do
         end do
      end do
#else

      if (.not. quick) write (unit, '(a)') 'Integrated scenes need GSL, and this build has none.'
#endif
   end subroutine bench_integrated

#ifdef KYVADLO_WITH_GSL
   subroutine measure(unit, quick, scene, span, tolerance)
      integer, intent(in) :: unit
      logical, intent(in) :: quick
      integer, intent(in) :: scene, span
      real(wp), intent(in) :: tolerance
      real(wp), allocatable :: ours(:), theirs(:)
      real(wp) :: begun, ended, end_ours(3), end_theirs(3)
      integer :: pass, passes, runs, run
      logical :: has_failed
      character(len=31) :: beside

      passes = merge(1, merge(3, 11, span > 1000), quick)
      runs = merge(1, max(1, 200/span), quick)
      allocate (ours(passes), theirs(passes))
      do pass = 1, passes
         call cpu_time(begun)
         do run = 1, runs
            call integrate(scene, span*period, tolerance, end_ours)
         end do
         call cpu_time(ended)
         ours(pass) = (ended - begun)/runs
         call cpu_time(begun)
         do run = 1, runs
            call drive(scene, span*period, tolerance, end_theirs, has_failed)
         end do
         call cpu_time(ended)
         theirs(pass) = (ended - begun)/runs
      end do
      write (beside, '(f11.2,f8.2,es12.1)') 1e6_wp*median(theirs)/span, median(theirs)/median(ours), &
         norm2(end_ours - end_theirs)
      if (has_failed) beside = '     failed       -           -'
      write (unit, '(a6,i9,es11.0,f11.2,a31,3(1x,f19.16))') names(scene), span, tolerance, &
         1e6_wp*median(ours)/span, beside, end_ours
   end subroutine measure

   pure function effects_of(scene) result(effects)
      integer, intent(in) :: scene
      type(effects_type) :: effects

      select case (scene)
      case (drag)
         effects%quadratic_drag = 1e-5_wp
      case (earth)
         effects%turn_rate = earth_turn_rate(latitude, 7.292115e-5_wp)
      case (spring)
         effects%stiffness = 100
      case (pivot)
         effects%pivot_amplitude(1) = 0.01_wp
         effects%pivot_frequency(1) = 0.7_wp
      end select
   end function effects_of

   subroutine integrate(scene, time, tolerance, place)
      integer, intent(in) :: scene
      real(wp), intent(in) :: time, tolerance
      real(wp), intent(out) :: place(3)
      type(integration_type) :: run
      type(error_type), allocatable :: error
      real(wp) :: positions(3, 1), velocities(3, 1), tensions(1), works(1, 2)

      call new_integration(run, effects_of(scene), length, gravity, position, velocity, tolerance, error, &
         with_work=.false.)
      if (allocated(error)) error stop 'bench_integrated: no integration'
      call run%advance([time], positions, velocities, tensions, works(:, 1), works(:, 2), error)
      if (allocated(error)) error stop 'bench_integrated: the integration failed'
      call run%finish()
      place = positions(:, 1)
   end subroutine integrate

   subroutine drive(scene, time, tolerance, place, has_failed)
      integer, intent(in) :: scene
      real(wp), intent(in) :: time, tolerance
      real(wp), intent(out) :: place(3)
      logical, intent(out) :: has_failed
      type(problem_type), target :: problem
      type(fgsl_odeiv2_system) :: system
      type(fgsl_odeiv2_driver) :: driver
      real(c_double) :: t, y(6)
      integer(fgsl_int) :: status

      problem%scene = scene
      problem%effects = effects_of(scene)
      system = fgsl_odeiv2_system_init(right_side, 6_fgsl_size_t, c_loc(problem))
      driver = fgsl_odeiv2_driver_alloc_y_new(system, fgsl_odeiv2_step_rk8pd, 1e-3_c_double*sqrt(length/gravity), &
         tolerance, 0.0_c_double)
      t = 0
      y = [position, velocity]
      status = fgsl_odeiv2_driver_apply(driver, t, time, y)
      has_failed = status /= 0 ! Nothing holds its bob on the sphere.
      call fgsl_odeiv2_driver_free(driver)
      call fgsl_odeiv2_system_free(system)
      place = y(1:3)
   end subroutine drive

   !> Newton's equations; the rod's force is what keeps p.p'' + v.v = 0.
   function right_side(t, y, dydt, params) bind(c, name='') result(status)
      real(c_double), value :: t
      type(c_ptr), value :: y, dydt, params
      integer(c_int) :: status
      type(problem_type), pointer :: problem
      real(c_double), pointer :: u(:), du(:)
      real(c_double) :: force(3), turn

      call c_f_pointer(y, u, [6])
      call c_f_pointer(dydt, du, [6])
      call c_f_pointer(params, problem)
      force = [0.0_wp, 0.0_wp, -gravity]
      associate (p => u(1:3), v => u(4:6), effects => problem%effects)
         select case (problem%scene)
         case (drag)
            force = force - effects%quadratic_drag*norm2(v)*v
         case (earth)
            associate (w => effects%turn_rate)
               force = force - 2*[w(2)*v(3) - w(3)*v(2), w(3)*v(1) - w(1)*v(3), w(1)*v(2) - w(2)*v(1)]
            end associate
         case (pivot)
            turn = 8*atan(1.0_wp)*effects%pivot_frequency(1)
            force(1) = force(1) + effects%pivot_amplitude(1)*turn**2*cos(turn*t)
         end select
         du(1:3) = v
         if (problem%scene == spring) then
            du(4:6) = force - effects%stiffness*(1 - length/norm2(p))*p
         else
            du(4:6) = force - (dot_product(force, p) + dot_product(v, v))/dot_product(p, p)*p
         end if
      end associate
      status = 0
   end function right_side
#endif

end module kyvadlo_bench_integrated
