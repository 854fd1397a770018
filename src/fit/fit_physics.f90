!> What determines a motion in a fit, what can be told of a single state, and how its states are asked for: by a
!> procedure
!> that the model is handed, so that the integration is not beneath everything here.
module kyvadlo_fit_physics
   use kyvadlo_buoyancy, only: effective_gravity
   use kyvadlo_effects, only: earth_turn_rate, effects_type, has_moving_pivot
   use kyvadlo_force_changes, only: change_type
   use kyvadlo_forces, only: forces_type, move, new_forces
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_orbit_real64, only: new_orbit_from_release, orbit_type
   use kyvadlo_pivot, only: pivot_change, pivot_motion
   use kyvadlo_scene_groups
   use kyvadlo_state_real64, only: new_orbit_from_state
   use kyvadlo_status, only: error_type
   implicit none
   private
   public :: camera_type
   public :: physics_type, direction_type, states_procedure, effects_with, gravity_felt, tension_of, plane_of, &
      acceleration_of, is_seen_otherwise, show, moved, unit_period

   !> What determines a motion.
   type :: physics_type
      real(wp) :: length = 1, gravity = 1
      real(wp) :: position(3) = 0, velocity(3) = 0       !! At t = 0
      type(effects_type) :: effects
      real(wp) :: frame_rate = 0
      logical :: is_exact = .true.                       !! The closed form answers, whatever the effects say
      real(wp) :: tolerance = 1e-10_wp                   !! Of a step, where it is integrated
   end type physics_type

   !> (u, v) = scale R(angle) (seen + offset).
   type :: camera_type
      real(wp) :: scale = 1, angle = 0, offset(2) = 0, time_offset = 0
   end type camera_type

   !> A direction in which it changes.
   type :: direction_type
      type(change_type) :: change
      real(wp) :: frame_rate = 0
   end type direction_type

   abstract interface
      !> States at ascending times, relative to the pivot and in resting axes, and their derivatives along directions.
      subroutine states_procedure(physics, directions, times, states, failed, matrices)
         import :: direction_type, physics_type, wp
         type(physics_type), intent(in) :: physics
         type(direction_type), intent(in) :: directions(:)          !! (p)
         real(wp), intent(in) :: times(:)                           !! (n)
         real(wp), intent(out), contiguous :: states(:, :)                      !! (6, n)
         logical, intent(out) :: failed
         !> (6, p, n); (3, p, n): of positions alone
         real(wp), intent(out), optional, contiguous :: matrices(:, :, :)
      end subroutine states_procedure
   end interface

contains

   !> The effects of a scene with other numbers.
   pure subroutine effects_with(number, given, effects, frame_rate)
      real(wp), intent(in) :: number(:, :)               !! (3, size(settings))
      logical, intent(in) :: given(:)                    !! Groups of the scene
      type(effects_type), intent(inout) :: effects
      real(wp), intent(out) :: frame_rate
      real(wp), parameter :: degree = acos(-1.0_wp)/180

      frame_rate = 0
      if (given(turning_frame_group)) frame_rate = scalar(turning_frame_group, 'rate')
      if (given(buoyancy_group)) then
         effects%density_ratio = scalar(buoyancy_group, 'density_ratio')
         effects%added_mass = scalar(buoyancy_group, 'added_mass')
      end if
      if (given(air_group) .and. .not. scalar(air_group, 'diameter') > 0) then
         effects%linear_drag = scalar(air_group, 'linear')
         effects%quadratic_drag = scalar(air_group, 'quadratic')
      end if
      if (given(wind_group)) effects%wind = number(:, setting_place(wind_group, 'velocity'))
      if (given(earth_rotation_group)) effects%turn_rate = earth_turn_rate(scalar(earth_rotation_group, 'latitude'), &
         scalar(earth_rotation_group, 'rate'))
      if (given(moving_pivot_group) .and. .not. scalar(moving_pivot_group, 'circle_radius') > 0) then
         effects%pivot_amplitude = number(:, setting_place(moving_pivot_group, 'amplitude'))
         effects%pivot_frequency = number(:, setting_place(moving_pivot_group, 'frequency'))
         effects%pivot_phase = number(:, setting_place(moving_pivot_group, 'phase'))*degree
      end if
      if (given(elastic_group)) effects%stiffness = scalar(elastic_group, 'stiffness')/scalar(elastic_group, 'mass')
      if (given(hoist_group)) effects%hoist_rate = scalar(hoist_group, 'rate')
      if (given(anisotropic_support_group)) effects%extra_length = &
         [scalar(anisotropic_support_group, 'extra_length_x'), scalar(anisotropic_support_group, 'extra_length_y')]

   contains

      pure real(wp) function scalar(group, name)
         integer, intent(in) :: group
         character(len=*), intent(in) :: name

         scalar = number(1, setting_place(group, name))
      end function scalar
   end subroutine effects_with

   !> Of the closed form [m/s2].
   pure real(wp) function gravity_felt(physics)
      type(physics_type), intent(in) :: physics

      gravity_felt = effective_gravity(physics%gravity, physics%effects%density_ratio, physics%effects%added_mass)
   end function gravity_felt

   !> Numbers moved along a direction.
   pure function moved(physics, direction, step) result(other)
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: direction
      real(wp), intent(in) :: step
      type(physics_type) :: other

      other = physics
      associate (change => direction%change)
         other%length = physics%length + step*change%length
         other%gravity = physics%gravity + step*change%gravity
         other%effects%linear_drag = max(0.0_wp, physics%effects%linear_drag + step*change%effects%linear_drag)
         other%effects%quadratic_drag = max(0.0_wp, physics%effects%quadratic_drag + step*change%effects%quadratic_drag)
         other%effects%wind = physics%effects%wind + step*change%effects%wind
         other%effects%turn_rate = physics%effects%turn_rate + step*change%effects%turn_rate
         other%effects%stiffness = physics%effects%stiffness + step*change%effects%stiffness
         other%effects%hoist_rate = physics%effects%hoist_rate + step*change%effects%hoist_rate
         other%effects%density_ratio = physics%effects%density_ratio + step*change%effects%density_ratio
         other%effects%added_mass = physics%effects%added_mass + step*change%effects%added_mass
         other%effects%pivot_amplitude = physics%effects%pivot_amplitude + step*change%effects%pivot_amplitude
         other%effects%pivot_frequency = physics%effects%pivot_frequency + step*change%effects%pivot_frequency
         other%effects%pivot_phase = physics%effects%pivot_phase + step*change%effects%pivot_phase
         other%effects%extra_length = physics%effects%extra_length + step*change%effects%extra_length
         other%frame_rate = physics%frame_rate + step*direction%frame_rate
      end associate
   end function moved

   !> Acceleration relative to the pivot, and tension per mass of the bob, in a state [m/s2].
   subroutine acceleration_of(physics, time, state, acceleration, tension)
      type(physics_type), intent(in) :: physics
      real(wp), intent(in) :: time, state(6)
      real(wp), intent(out) :: acceleration(3), tension
      type(forces_type) :: forces
      type(error_type), allocatable :: error
      real(wp) :: powers(2)

      tension = 0
      acceleration = 0
      call new_forces(forces, physics%effects, physics%length, physics%gravity, error)
      if (.not. allocated(error)) call move(forces, .true., time, state(1:3), state(4:6), acceleration, tension, powers)
   end subroutine acceleration_of

   real(wp) function tension_of(physics, time, state) result(tension)
      type(physics_type), intent(in) :: physics
      real(wp), intent(in) :: time, state(6)
      real(wp) :: acceleration(3)

      call acceleration_of(physics, time, state, acceleration, tension)
   end function tension_of

   !> Whether what is seen is not the state itself: from a turning frame, or with a moving pivot.
   pure logical function is_seen_otherwise(physics, directions)
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)

      is_seen_otherwise = has_moving_pivot(physics%effects) .or. any(abs(physics%effects%pivot_amplitude) > 0) .or. &
         abs(physics%frame_rate) > 0 .or. any(abs(directions%frame_rate) > 0)
   end function is_seen_otherwise

   !> A state and its derivatives as the laboratory, or the turning frame in it, sees them.
   pure subroutine show(physics, directions, time, state, matrix)
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)
      real(wp), intent(in) :: time
      real(wp), intent(inout) :: state(6)
      real(wp), intent(inout), optional :: matrix(:, :)   !! (6, p)
      real(wp) :: c, s, displacement(3), velocity(3), acceleration(3)
      integer :: j

      call pivot_motion(physics%effects, time, displacement, velocity)
      state = state + [displacement, velocity]
      c = cos(physics%frame_rate*time)
      s = sin(physics%frame_rate*time)
      state = turned(state)
      if (.not. present(matrix)) return
      do j = 1, size(directions)
         call pivot_change(physics%effects, directions(j)%change%effects, time, displacement, velocity, acceleration)
         matrix(:, j) = turned(matrix(:, j) + [displacement, velocity]) + directions(j)%frame_rate* &
            (time*[state(2), -state(1), 0.0_wp, state(5), -state(4), 0.0_wp] + [0.0_wp, 0.0_wp, 0.0_wp, state(2), &
            -state(1), 0.0_wp])
      end do

   contains

      pure function turned(a) result(b)
         real(wp), intent(in) :: a(6)
         real(wp) :: b(6)

         b = [c*a(1) + s*a(2), c*a(2) - s*a(1), a(3), c*a(4) + s*a(5), c*a(5) - s*a(4), a(6)]
         b(4:5) = b(4:5) + physics%frame_rate*[b(2), -b(1)]
      end function turned
   end subroutine show

   !> Azimuth of the highest point nearest in time, on the orbit that the state has under gravity alone, as the turning
   !> frame shows it; modulo pi: the `plane` of `simulate` [rad].
   real(wp) function plane_of(physics, at, state, next_to) result(plane)
      type(physics_type), intent(in) :: physics
      real(wp), intent(in) :: at                           !! The time [s]
      real(wp), intent(in) :: state(6)
      real(wp), intent(in) :: next_to                      !! The half turn is counted from it
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      real(wp) :: time, half, other
      real(wp), parameter :: far = 0.95_wp                 !! Of a half period
      real(wp), parameter :: pi = acos(-1.0_wp)

      plane = next_to + pi/2                               ! As far as can be, where there is none
      call new_orbit_from_state(orbit, norm2(state(1:3)), gravity_felt(physics), state(1:3), state(4:6), error)
      if (allocated(error)) return
      half = orbit%period()/2
      time = orbit%next_turning_time(0.0_wp)
      if (.not. (half <= huge(half) .and. time <= huge(time))) return
      if (orbit%rise(time + half) > orbit%rise(time)) time = time + half
      if (time > half) time = time - 2*half
      plane = line_at(time)
      if (abs(time) < far*half) return
      ! Halfway between two of them little decides which is the nearest.
      other = line_at(time - sign(2*half, time))
      if (abs(other - next_to) < abs(plane - next_to)) plane = other

   contains

      real(wp) function line_at(time) result(line)
         real(wp), intent(in) :: time

         line = orbit%azimuth(time) - physics%frame_rate*at
         line = line + pi*anint((next_to - line)/pi)
      end function line_at
   end function plane_of

   !> Period to and fro with l = g = 1.
   real(wp) function unit_period(amplitude)
      real(wp), intent(in) :: amplitude                  !! [rad]
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error

      call new_orbit_from_release(orbit, 1.0_wp, 1.0_wp, max(abs(amplitude), 1e-8_wp)*180/acos(-1.0_wp), 0.0_wp, error)
      unit_period = 0
      if (.not. allocated(error)) unit_period = 2*orbit%period()
   end function unit_period

end module kyvadlo_fit_physics
