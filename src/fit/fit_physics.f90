!> What determines a motion in a fit, what can be told of a single state, and how its states are asked for: by a
!> procedure
!> that the model is handed, so that the integration is not beneath everything here.
module kyvadlo_fit_physics
   use kyvadlo_buoyancy, only: effective_gravity
   use kyvadlo_effects, only: earth_turn_rate, effects_type
   use kyvadlo_force_changes, only: change_type
   use kyvadlo_forces, only: forces_type, move, new_forces
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_orbit_real64, only: new_orbit_from_release, orbit_type
   use kyvadlo_scene_groups
   use kyvadlo_state_real64, only: new_orbit_from_state
   use kyvadlo_status, only: error_type
   implicit none
   private
   public :: physics_type, direction_type, states_procedure, effects_with, gravity_felt, tension_of, plane_of, moved, &
      unit_period

   !> What determines a motion.
   type :: physics_type
      real(wp) :: length = 1, gravity = 1
      real(wp) :: position(3) = 0, velocity(3) = 0       !! At t = 0
      type(effects_type) :: effects
      real(wp) :: frame_rate = 0
      logical :: is_exact = .true.                       !! The closed form answers, whatever the effects say
      real(wp) :: tolerance = 1e-10_wp                   !! Of a step, where it is integrated
   end type physics_type

   !> A direction in which it changes.
   type :: direction_type
      type(change_type) :: change
      real(wp) :: frame_rate = 0
   end type direction_type

   abstract interface
      !> States at ascending times as the scene's frame shows them, and their derivatives along directions.
      subroutine states_procedure(physics, directions, times, states, failed, matrices)
         import :: direction_type, physics_type, wp
         type(physics_type), intent(in) :: physics
         type(direction_type), intent(in) :: directions(:)          !! (p)
         real(wp), intent(in) :: times(:)                           !! (n)
         real(wp), intent(out) :: states(:, :)                      !! (6, n)
         logical, intent(out) :: failed
         real(wp), intent(out), optional :: matrices(:, :, :)       !! (6, p, n)
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
      end associate
   end function moved

   !> Tension per mass of the bob in a state [m/s2].
   real(wp) function tension_of(physics, time, state) result(tension)
      type(physics_type), intent(in) :: physics
      real(wp), intent(in) :: time, state(6)
      type(forces_type) :: forces
      type(error_type), allocatable :: error
      real(wp) :: acceleration(3), powers(2)

      tension = 0
      call new_forces(forces, physics%effects, physics%length, physics%gravity, error)
      if (.not. allocated(error)) call move(forces, .true., time, state(1:3), state(4:6), acceleration, tension, powers)
   end function tension_of

   !> Azimuth of the line of apsides of the orbit that the state has under gravity alone, carried at its mean rate from
   !> the turning point next to the state; modulo pi [rad].
   real(wp) function plane_of(physics, state) result(plane)
      type(physics_type), intent(in) :: physics
      real(wp), intent(in) :: state(6)
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      real(wp) :: time, half

      plane = 0
      call new_orbit_from_state(orbit, norm2(state(1:3)), gravity_felt(physics), state(1:3), state(4:6), error)
      if (allocated(error)) return
      half = orbit%period()/2
      time = orbit%next_turning_time(0.0_wp)
      if (.not. (half <= huge(half) .and. time <= huge(time))) return
      if (orbit%rise(time + half) > orbit%rise(time)) time = time + half
      if (time > half) time = time - 2*half
      plane = orbit%azimuth(time) - orbit%apsidal_rate()*time
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
