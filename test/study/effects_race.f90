!> One scene under effects, integrated by the library, by GSL's own driver and, for the error, in quadruple precision.
module effects_race
   use, intrinsic :: iso_c_binding, only: c_double, c_int, c_loc, c_long, c_size_t
   use, intrinsic :: iso_fortran_env, only: int64, real64, real128
   use kyvadlo, error_type => kyvadlo_error_type
   use kyvadlo_buoyancy
   use kyvadlo_effects
   use kyvadlo_forces
   use kyvadlo_gsl
   use kyvadlo_integrator
   use kyvadlo_stopwatch, only: median
   use kyvadlo_suspension
   use kyvadlo_turning_frame
   use bare_equations
   use lagrange_motion
   implicit none
   private
   public :: race, time_closed_form, bound, rod, air, earth, shaken, spring, any_kind

   integer, parameter :: rod = 1, air = 2, earth = 3, shaken = 4, spring = 5, any_kind = 6
   !> A pendulum of one metre, let go sideways at 53 degrees from the vertical, for a minute: some thirty swings.
   real(real64), parameter :: l = 1, g = 9.80665_real64, duration = 60, tolerance = 1e-12_real64
   real(real64), parameter :: start(3) = [0.8_real64, 0.0_real64, -0.6_real64], push(3) = [0.0_real64, 1.5_real64, 0.0_real64]
   !> Samples: close, 100 to the second; far, 2 to the second, several steps of the integrator apart.
   integer, parameter :: samples(2) = [6000, 120]
   !> Errors are the largest distances at these times, in units of the length.
   real(real64), parameter :: error_until = 10
   integer, parameter :: error_samples = 20
   !> Worst measured 4.3e-12, of the spring; four times that.
   real(real64), parameter :: bound = 1.7e-11_real64
   !> For a turning frame [rad/s].
   real(real64), parameter :: frame_rate = 0.25_real64

   !> What is raced.
   type :: entry_type
      type(effects_type) :: effects
      integer :: which = rod             !! The bare equations for GSL
      logical :: with_work = .false.
      real(real64) :: position(3) = start, velocity(3) = push
      real(real64), allocatable :: times(:), places(:, :)
   end type entry_type

contains

   !> Nanoseconds a sample of ours and of GSL's driver, of the processor's time, medians of passes taken in turn, and both errors.
   subroutine race(effects, which, with_work, passes, ours, theirs, worst, worst_of_gsl)
      type(effects_type), intent(in) :: effects
      integer, intent(in) :: which
      logical, intent(in) :: with_work
      integer, intent(in) :: passes
      real(real64), intent(out) :: ours(2), theirs(2), worst, worst_of_gsl
      type(entry_type) :: entry
      type(suspension_type) :: suspension
      real(real64) :: measured(passes, 2), ratio(passes)
      real(real128) :: exact(3, error_samples)
      integer :: k, pass

      entry%effects = effects
      entry%which = which
      entry%with_work = with_work
      call new_suspension(suspension, l, effects%extra_length)
      call put_on_surface(suspension, entry%position, entry%velocity)
      do k = 1, 2
         call ask_for(entry, samples(k), duration)
         do pass = 0, passes   ! The first warms the caches and is not counted.
            measured(max(pass, 1), 1) = time_of(entry, .true.)
            measured(max(pass, 1), 2) = time_of(entry, .false.)
         end do
         ratio = measured(:, 1)/measured(:, 2)
         ours(k) = median(measured(:, 1))
         ! So that the ratio of both is the median of the ratios.
         theirs(k) = ours(k)/median(ratio)
      end do
      call ask_for(entry, error_samples, error_until)
      exact = exact_places(entry)
      call integrate_here(entry)
      worst = worst_distance(entry%places, exact)
      call integrate_by_gsl(entry)
      worst_of_gsl = worst_distance(entry%places, exact)
   end subroutine race

   subroutine ask_for(entry, count, until)
      type(entry_type), intent(inout) :: entry
      integer, intent(in) :: count
      real(real64), intent(in) :: until
      integer :: i

      entry%times = [(until*i/count, i=1, count)]
      if (allocated(entry%places)) deallocate (entry%places)
      allocate (entry%places(3, count))
   end subroutine ask_for

   real(real64) function time_of(entry, is_ours) result(nanoseconds)
      type(entry_type), intent(inout) :: entry
      logical, intent(in) :: is_ours
      real(real64) :: from, to

      call cpu_time(from)
      if (is_ours) then
         call integrate_here(entry)
      else
         call integrate_by_gsl(entry)
      end if
      call cpu_time(to)
      nanoseconds = 1e9_real64*(to - from)/size(entry%times)
   end function time_of

   subroutine integrate_here(entry)
      type(entry_type), intent(inout) :: entry
      type(integration_type) :: run
      type(error_type), allocatable :: error
      real(real64), dimension(size(entry%times)) :: tensions, drag_work, pivot_work
      real(real64) :: velocities(3, size(entry%times))

      call new_integration(run, entry%effects, l, g, entry%position, entry%velocity, tolerance, error, entry%with_work)
      if (.not. allocated(error)) &
         call run%advance(entry%times, entry%places, velocities, tensions, drag_work, pivot_work, error)
      call run%finish()
      if (allocated(error)) error stop 'effects_race: the integration failed'
   end subroutine integrate_here

   !> GSL's driver, rk8pd, the same tolerance, the right side of `bare_equations`.
   subroutine integrate_by_gsl(entry)
      type(entry_type), intent(inout) :: entry
      type(forces_type), target :: forces
      type(error_type), allocatable :: error
      type(fgsl_odeiv2_system) :: system
      type(fgsl_odeiv2_driver) :: driver
      real(c_double) :: t, y(6), velocities(3, size(entry%times))
      integer(c_int) :: status
      integer :: i

      call new_forces(forces, entry%effects, l, g, error)
      select case (entry%which)
      case (rod)
         system = fgsl_odeiv2_system_init(bare_rod, 6_c_size_t, c_loc(forces))
      case (air)
         system = fgsl_odeiv2_system_init(bare_air, 6_c_size_t, c_loc(forces))
      case (earth)
         system = fgsl_odeiv2_system_init(bare_earth, 6_c_size_t, c_loc(forces))
      case (shaken)
         system = fgsl_odeiv2_system_init(bare_shaken, 6_c_size_t, c_loc(forces))
      case (spring)
         system = fgsl_odeiv2_system_init(bare_spring, 6_c_size_t, c_loc(forces))
      case default
         system = fgsl_odeiv2_system_init(bare_any, 6_c_size_t, c_loc(forces))
      end select
      driver = fgsl_odeiv2_driver_alloc_y_new(system, fgsl_odeiv2_step_rk8pd, 1e-3_c_double*sqrt(l/g), tolerance, 0.0_c_double)
      status = fgsl_odeiv2_driver_set_nmax(driver, 1000000_c_long)
      t = 0
      y = [entry%position, entry%velocity]
      do i = 1, size(entry%times)
         if (status == 0) status = fgsl_odeiv2_driver_apply(driver, t, entry%times(i), y)
         entry%places(:, i) = y(1:3)
         velocities(:, i) = y(4:6)
      end do
      call fgsl_odeiv2_driver_free(driver)
      call fgsl_odeiv2_system_free(system)
      if (status /= 0 .or. .not. all(abs(velocities) <= huge(t))) error stop 'effects_race: the driver of GSL failed'
   end subroutine integrate_by_gsl

   function exact_places(entry) result(places)
      type(entry_type), intent(in) :: entry
      real(real128), dimension(3, size(entry%times)) :: places, velocities
      real(real128) :: tensions(size(entry%times)), works(2, size(entry%times))
      type(scene_type) :: scene
      type(contact_type), allocatable :: contacts(:)

      associate (effects => entry%effects)
         scene%length = l
         scene%gravity = real(g, real128)
         scene%linear_drag = effects%linear_drag
         scene%quadratic_drag = effects%quadratic_drag
         scene%wind = effects%wind
         scene%turn_rate = effects%turn_rate
         scene%amplitude = effects%pivot_amplitude
         scene%frequency = effects%pivot_frequency
         scene%phase = effects%pivot_phase
         if (allocated(effects%pivot_times)) then
            scene%times = real(effects%pivot_times, real128)
            scene%displacements = real(effects%pivot_displacements, real128)
         end if
         scene%stiffness = effects%stiffness
         scene%extra_length = effects%extra_length
         scene%density_ratio = effects%density_ratio
         scene%added_mass = effects%added_mass
         scene%is_string = effects%is_string
      end associate
      call lagrange_run(scene, real(entry%position, real128), real(entry%velocity, real128), real(entry%times, real128), &
         merge(1/64.0_real128, 1/16.0_real128, scene%stiffness > 0), places, velocities, tensions, works, contacts)
   end function exact_places

   !> The closed form: alone (1), in a fluid (2), seen from a turning frame (3).
   subroutine time_closed_form(kind, passes, nanoseconds, worst)
      integer, intent(in) :: kind, passes
      real(real64), intent(out) :: nanoseconds(2), worst
      type(entry_type) :: entry
      real(real128) :: exact(3, error_samples), angle
      integer(int64) :: from, to, rate
      integer :: i, k, pass

      if (kind == 2) entry%effects = effects_type(density_ratio=0.125_real64, added_mass=0.5_real64)
      do k = 1, 2
         call ask_for(entry, samples(k), duration)
         nanoseconds(k) = huge(worst)
         ! The fastest of twenty times as many passes: they are short, and take all cores, which other work on one of them stops.
         do pass = 0, 20*passes
            call system_clock(from, rate)
            call locate_here(entry, kind)
            call system_clock(to)
            nanoseconds(k) = min(nanoseconds(k), 1e9_real64*real(to - from, real64)/real(rate, real64)/samples(k))
         end do
      end do
      call ask_for(entry, error_samples, error_until)
      exact = exact_places(entry)
      if (kind == 3) then
         do i = 1, error_samples
            angle = -frame_rate*real(entry%times(i), real128)
            exact(:2, i) = [cos(angle)*exact(1, i) - sin(angle)*exact(2, i), sin(angle)*exact(1, i) + cos(angle)*exact(2, i)]
         end do
      end if
      call locate_here(entry, kind)
      worst = worst_distance(entry%places, exact)
   end subroutine time_closed_form

   subroutine locate_here(entry, kind)
      type(entry_type), intent(inout) :: entry
      integer, intent(in) :: kind
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      real(real64), dimension(size(entry%times)) :: x, y, z, u, v, w
      real(real64) :: velocity(3)
      integer :: i

      call new_orbit_from_state(orbit, l, effective_gravity(g, entry%effects%density_ratio, entry%effects%added_mass), &
         entry%position, entry%velocity, error)
      if (allocated(error)) error stop 'effects_race: no orbit'
      call orbit%locate(entry%times, x, y, z, u, v, w)
      do i = 1, size(entry%times)
         entry%places(:, i) = [x(i), y(i), z(i)]
         velocity = [u(i), v(i), w(i)]
         if (kind == 3) call seen_from_turning_frame(frame_rate, entry%times(i), entry%places(:, i), velocity)
      end do
   end subroutine locate_here

   !> NaN is the largest.
   pure real(real64) function worst_distance(places, exact)
      real(real64), intent(in) :: places(:, :)
      real(real128), intent(in) :: exact(:, :)
      real(real64) :: distance
      integer :: i

      worst_distance = 0
      do i = 1, size(places, 2)
         distance = real(norm2(places(:, i) - exact(:, i))/l, real64)
         if (.not. distance <= worst_distance) worst_distance = distance
         if (.not. distance <= huge(distance)) then
            worst_distance = huge(distance)
            return
         end if
      end do
   end function worst_distance

end module effects_race
