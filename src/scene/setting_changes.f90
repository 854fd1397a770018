!> What one unit more of a setting changes of the numbers that a motion is computed from: the chain rule between the
!> scene and kyvadlo_force_changes.
module kyvadlo_setting_changes
   use kyvadlo_derivatives_real64, only: derivatives_type, new_derivatives_from_gaps, new_derivatives_from_heights, &
      new_derivatives_from_rises, new_derivatives_from_state
   use kyvadlo_buoyancy, only: effective_gravity
   use kyvadlo_effects, only: earth_turn_rate, effects_type, put_coefficient
   use kyvadlo_force_changes, only: change_type
   use kyvadlo_forces, only: forces_type, new_forces
   use kyvadlo_integration_start, only: begin_motion
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_scene_groups
   use kyvadlo_scene_orbit_real64, only: numbers_of, numbers_type
   use kyvadlo_scene_settings, only: derivative_type, settings_type
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_status, only: error_type
   use kyvadlo_suspension, only: new_suspension_change, surface_change, suspension_change_type, &
      suspension_type
   implicit none
   private
   public :: computed_scene_type, setting_change_type, changes_of_settings

   real(wp), parameter :: degree = acos(-1.0_wp)/180

   !> The numbers that the motion of a scene is computed from.
   type :: computed_scene_type
      type(effects_type) :: effects
      real(wp) :: length = 0, gravity = 0      !! [m], [m/s2]
      type(orbit_type) :: orbit                !! Through the start, if there is one
      real(wp) :: position(3) = 0, velocity(3) = 0 !! At the start, relative to the pivot [m], [m/s]
      logical :: starts_freely = .false.       !! By a state that need not lie on the sphere
   end type computed_scene_type

   !> What one unit more of a setting adds.
   type :: setting_change_type
      type(change_type) :: change
      real(wp) :: fall = 0             !! Of the gravity less buoyancy over inertia
      real(wp) :: start(2, 3) = 0      !! Of the values of the two names of the start
      real(wp) :: frame_rate = 0       !! Of the frame of the output
   end type setting_change_type

contains

   !> For each derivative of a scene; and the closed form's own derivatives, where the start lies on an orbit.
   subroutine changes_of_settings(simulation, scene, list, changes, core, error)
      type(simulation_type), intent(in) :: simulation
      type(computed_scene_type), intent(in) :: scene
      type(derivative_type), intent(in) :: list(:)                         !! (p)
      type(setting_change_type), allocatable, intent(out) :: changes(:)    !! (p)
      type(derivatives_type), intent(out) :: core
      type(error_type), allocatable, intent(out) :: error
      type(numbers_type) :: numbers
      integer :: j

      allocate (changes(size(list)))
      do j = 1, size(list)
         call change_of_setting(simulation%settings, list(j), simulation%pendulum%start, changes(j))
         associate (new => changes(j)%change, old => scene%effects)
            associate (r => old%density_ratio, k => old%added_mass)
               changes(j)%fall = (new%gravity*(1 - r) - scene%gravity*new%effects%density_ratio*(1 + k)/(1 + k*r) &
                  - scene%gravity*(1 - r)*r*new%effects%added_mass/(1 + k*r))/(1 + k*r)
            end associate
         end associate
      end do
      call numbers_of(simulation%pendulum, numbers, error)
      if (allocated(error)) return
      do j = 1, size(list)
         associate (new => changes(j)%change, value => simulation%settings%number(1, list(j)%setting))
            ! Of a body the length is inertia/(mass distance), or that which is typed and more.
            select case (trim(group_names(settings(list(j)%setting)%group))//'.'//settings(list(j)%setting)%name)
            case ('pendulum.length')
               new%length = numbers%longer
            case ('body.inertia')
               new%length = scene%length/value
            case ('body.distance', 'body.mass')
               new%length = -scene%length/value
            end select
         end associate
      end do
      numbers%gravity = effective_gravity(scene%gravity, scene%effects%density_ratio, scene%effects%added_mass)
      call start_changes(simulation%pendulum%start, scene, numbers, changes, core, error)
      if (.not. allocated(error) .and. (scene%starts_freely .or. any(scene%effects%extra_length > 0))) &
         call put_changes_on_surface(scene, numbers, changes, error)
   end subroutine changes_of_settings

   !> What `begin_motion` makes of a start that need not lie on the sphere.
   subroutine put_changes_on_surface(scene, numbers, changes, error)
      type(computed_scene_type), intent(in) :: scene
      type(numbers_type), intent(in) :: numbers
      type(setting_change_type), intent(inout) :: changes(:)
      type(error_type), allocatable, intent(out) :: error
      type(forces_type) :: forces
      type(suspension_change_type) :: suspension_change
      real(wp), dimension(3) :: position, velocity, p, v, turned
      real(wp) :: slack
      logical :: is_taut, was_put(2)
      integer :: j

      position = numbers%first
      velocity = numbers%second
      if (.not. scene%starts_freely) call scene%orbit%locate(0.0_wp, position, velocity)
      p = position
      v = velocity
      call new_forces(forces, scene%effects, scene%length, scene%gravity, error)
      if (.not. allocated(error)) call begin_motion(forces, p, v, is_taut, slack, error, was_put)
      if (allocated(error) .or. .not. was_put(1)) return
      do j = 1, size(changes)
         associate (change => changes(j)%change)
            call new_suspension_change(suspension_change, forces%suspension, change%length, change%effects%extra_length)
            turned = change%velocity
            call surface_change(forces%suspension, suspension_change, position, velocity, change%position, turned)
            if (was_put(2)) change%velocity = turned
         end associate
      end do
   end subroutine put_changes_on_surface

   !> But the start that it makes.
   pure subroutine change_of_setting(chosen, which, start, new)
      type(settings_type), intent(in) :: chosen
      type(derivative_type), intent(in) :: which
      integer, intent(in) :: start                     !! One of the `start_*` constants
      type(setting_change_type), intent(out) :: new
      logical :: is_put

      associate (effects => new%change%effects, e => which%element, old => chosen%effects, &
         value => chosen%number(which%element, which%setting))
         select case (trim(group_names(settings(which%setting)%group))//'.'//settings(which%setting)%name)
         case ('pendulum.length', 'body.inertia', 'body.distance', 'body.mass')
            ! The numbers of the pendulum say it.
         case ('pendulum.gravity')
            new%change%gravity = 1
         case ('turning_frame.rate')
            new%frame_rate = 1
         case ('air.diameter')
            effects%linear_drag = old%linear_drag/value
            effects%quadratic_drag = 2*old%quadratic_drag/value
            effects%sphere_speed = -old%sphere_speed/value
         case ('air.mass')
            effects%linear_drag = -old%linear_drag/value
            effects%quadratic_drag = -old%quadratic_drag/value
         case ('air.density')
            effects%quadratic_drag = old%quadratic_drag/value
            effects%sphere_speed = -old%sphere_speed/value
         case ('air.viscosity')
            effects%linear_drag = old%linear_drag/value
            effects%sphere_speed = old%sphere_speed/value
         case ('earth_rotation.latitude')
            ! A quarter turn on.
            effects%turn_rate = chosen%number(1, setting_place(earth_rotation_group, 'rate'))*degree* &
               [0.0_wp, -sin(value*degree), cos(value*degree)]
         case ('earth_rotation.rate')
            effects%turn_rate = earth_turn_rate(chosen%number(1, setting_place(earth_rotation_group, 'latitude')), &
               1.0_wp)
         case ('moving_pivot.circle_radius')
            effects%pivot_amplitude(:2) = 1
         case ('moving_pivot.circle_rate')
            effects%pivot_frequency(:2) = sign(1.0_wp, value)
         case ('elastic.stiffness')
            effects%stiffness = old%stiffness/value
         case ('elastic.mass')
            effects%stiffness = -old%stiffness/value
         case default
            call put_coefficient(effects, trim(group_names(settings(which%setting)%group))//'.'// &
               trim(settings(which%setting)%name), e, 1.0_wp, is_put)
            if (.not. is_put) new%start(merge(1, 2, settings(which%setting)%name == starts(start)%first), e) = 1
         end select
      end associate
   end subroutine change_of_setting

   !> The changes of position and velocity at t = 0.
   subroutine start_changes(start, scene, numbers, changes, core, error)
      integer, intent(in) :: start
      type(computed_scene_type), intent(in) :: scene
      type(numbers_type), intent(in) :: numbers                    !! Under the effective gravity
      type(setting_change_type), intent(inout) :: changes(:)
      type(derivatives_type), intent(out) :: core
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: matrix(6, 9), position(3), velocity(3), column(6), first, second
      integer :: j

      associate (l => numbers%length, g => numbers%gravity, a => numbers%first, b => numbers%second)
         select case (start)
         case (start_heights)
            call new_derivatives_from_heights(core, l, g, a(1), b(1), error)
         case (start_gaps)
            call new_derivatives_from_gaps(core, l, g, a(1), b(1), error)
         case (start_rises)
            call new_derivatives_from_rises(core, l, g, a(1), b(1), error)
         case default
            if (.not. scene%starts_freely) call new_derivatives_from_state(core, l, g, scene%position, scene%velocity, &
               error)
         end select
         if (allocated(error)) return
         if (any(start == [start_heights, start_gaps, start_rises])) call core%evaluate(0.0_wp, position, velocity, &
            matrix)
         do j = 1, size(changes)
            associate (new => changes(j), made => changes(j)%change)
               first = new%start(1, 1)
               second = new%start(2, 1)
               select case (start)
               case (start_heights, start_gaps, start_rises)
                  column = combined(matrix(:, :4), [made%length, new%fall, first, second])
               case (start_state)
                  column = [new%start(1, :), new%start(2, :)]
                  if (.not. scene%starts_freely) call surface_change(suspension_type(radius=l), &
                     suspension_change_type(radius=made%length), a, b, column(1:3), column(4:6))
               case (start_release)
                  column = release_change(l, a(1), made%length, first, second)
               case default
                  column = energy_start_change(start, scene, g, a(1), b(1), made%length, new%fall, first, second)
               end select
               made%position = column(1:3)
               made%velocity = column(4:6)
            end associate
         end do
      end associate
   end subroutine start_changes

   !> A matrix times weights; a column of weight zero counts for nothing, even if it has no numbers.
   pure function combined(matrix, weights) result(column)
      real(wp), intent(in) :: matrix(:, :), weights(:)
      real(wp) :: column(6)
      integer :: i

      column = 0
      do i = 1, size(weights)
         if (abs(weights(i)) > 0) column = column + weights(i)*matrix(:, i)
      end do
   end function combined

   !> x = l sin(angle), z = -l cos(angle), and the speed along y.
   pure function release_change(length, angle, longer, turned, faster) result(column)
      real(wp), intent(in) :: length, angle            !! [m], [degrees]
      real(wp), intent(in) :: longer, turned, faster   !! Changes
      real(wp) :: column(6), s, c

      s = sin(angle*degree)
      c = cos(angle*degree)
      column = [longer*s + length*c*degree*turned, 0.0_wp, -longer*c + length*s*degree*turned, 0.0_wp, faster, 0.0_wp]
   end function release_change

   !> At the upper turning height z the square of the momentum is 2 (E - g z) (l**2 - z**2); x**2 = l**2 - z**2, and
   !> the speed is the momentum over x, along y.
   pure function energy_start_change(start, scene, gravity, energy, momentum, longer, heavier, first, second) &
         result(column)
      integer, intent(in) :: start
      type(computed_scene_type), intent(in) :: scene
      real(wp), intent(in) :: gravity                  !! Effective [m/s2]
      real(wp), intent(in) :: energy, momentum         !! As they were given
      real(wp), intent(in) :: longer, heavier, first, second !! Changes
      real(wp) :: column(6), more, higher, wider, kinetic
      integer :: level

      level = 0
      if (start == start_energy_above_top) level = 1
      if (start == start_energy_above_bottom) level = -1
      associate (l => scene%length, x => scene%position(1), z => scene%position(3), g => gravity)
         kinetic = energy + level*g*l - g*z
         more = first + level*(heavier*l + g*longer)
         if (.not. abs(x) > 0) then
            ! Over the top in a plane: x is the momentum over the speed there.
            associate (speed => scene%velocity(2))
               column = [second/speed, 0.0_wp, longer, 0.0_wp, (more - heavier*z - g*longer)/speed, 0.0_wp]
            end associate
            return
         end if
         higher = (x**2*(more - z*heavier) + 2*kinetic*l*longer - momentum*second)/(g*x**2 + 2*z*kinetic)
         wider = (l*longer - z*higher)/x
         column = [wider, 0.0_wp, higher, 0.0_wp, (second - momentum*wider/x)/x, 0.0_wp]
      end associate
   end function energy_start_change

end module kyvadlo_setting_changes
