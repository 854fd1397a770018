!> How acceleration, tension and energy change with the state, length, gravity and every coefficient of an effect: the
!> derivatives of kyvadlo_forces, term by term, for the variational equations. doc/effects.md writes them down.
module kyvadlo_force_changes
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_effects, only: effects_type, sphere_drag
   use kyvadlo_forces, only: forces_type, lengthen
   use kyvadlo_pivot, only: pivot_change, pivot_jerk, pivot_motion
   use kyvadlo_suspension, only: new_suspension_change, radius_change, stretch, stretch_change, &
      suspension_change_type, suspension_type
   implicit none
   private
   public :: change_type, forces_change_type, new_forces_change, move_changes, tension_rate, energy_change, natural_size

   !> A direction in which the numbers of a motion change: each component is the derivative of that number with respect
   !> to the parameter in question, all zero but a few.
   type :: change_type
      real(wp) :: position(3) = 0, velocity(3) = 0 !! Of the start, relative to the pivot
      real(wp) :: length = 0, gravity = 0
      type(effects_type) :: effects = effects_type()   !! Its numbers are changes; no table
   end type change_type

   !> The same with what follows from it, for `move_changes`.
   type :: forces_change_type
      type(effects_type) :: effects
      type(suspension_change_type) :: suspension
      real(wp) :: weight = 0, inertia = 0
      logical :: has_drag = .false., has_wind = .false., has_turn = .false., has_pivot = .false.
   end type forces_change_type

   !> What the changes of all parameters share.
   type :: here_type
      logical :: is_taut = .true.
      real(wp) :: seen(3) = 0                !! Velocity in the laboratory [m/s]
      real(wp) :: through(3) = 0, speed = 0  !! Velocity through the air [m/s]
      real(wp) :: drag = 0                   !! Force over mass and that speed [1/s]
      real(wp) :: drag_changes(4) = 0        !! With the speed, linear_drag, quadratic_drag, sphere_speed
      real(wp) :: force(3) = 0               !! But of rod, string and pivot, over the mass of the bob [m/s2]
      real(wp) :: free(3) = 0                !! Acceleration but for rod or string [m/s2]
      real(wp) :: distance = 0, outward(3) = 0, pull = 0
   end type here_type

contains

   pure subroutine new_forces_change(forces_change, change, forces, gravity)
      type(forces_change_type), intent(out) :: forces_change
      type(change_type), intent(in) :: change
      type(forces_type), intent(in) :: forces
      real(wp), intent(in) :: gravity                  !! Of the forces [m/s2]

      associate (effects => forces%effects, new => change%effects)
         forces_change%effects = new
         forces_change%weight = change%gravity*(1 - effects%density_ratio) - gravity*new%density_ratio
         forces_change%inertia = new%added_mass*effects%density_ratio + effects%added_mass*new%density_ratio
         call new_suspension_change(forces_change%suspension, forces%suspension, change%length, new%extra_length, &
            new%hoist_rate)
         forces_change%has_drag = any(abs([new%linear_drag, new%quadratic_drag, &
            new%sphere_speed]) > 0)
         forces_change%has_wind = forces%has_drag .and. any(abs(new%wind) > 0)
         forces_change%has_turn = any(abs(new%turn_rate) > 0)
         forces_change%has_pivot = any(abs([new%pivot_amplitude, new%pivot_frequency, new%pivot_phase]) > 0)
      end associate
   end subroutine new_forces_change

   !> The changes of acceleration and tension with the changes of state and numbers, column by column. `move` was called
   !> for the same state before, and knows the motion of the pivot.
   pure subroutine move_changes(forces, changes, is_taut, time, position, velocity, columns, accelerations, tensions)
      type(forces_type), intent(in) :: forces
      type(forces_change_type), intent(in) :: changes(:)        !! (p)
      logical, intent(in) :: is_taut
      real(wp), intent(in) :: time                              !! [s]
      real(wp), intent(in) :: position(3), velocity(3)          !! Relative to the pivot [m], [m/s]
      real(wp), intent(in) :: columns(:, :)                     !! (6, p) changes of position and velocity
      real(wp), intent(out) :: accelerations(:, :), tensions(:) !! (3, p), (p)
      type(here_type) :: here
      real(wp), dimension(3) :: displacement, pivot_velocity, pivot_acceleration
      integer :: j

      call look(forces, is_taut, position, velocity, here)
      pivot_velocity = 0
      pivot_acceleration = 0
      do j = 1, size(changes)
         if (changes(j)%has_pivot) then
            call pivot_change(forces%effects, changes(j)%effects, time, displacement, pivot_velocity, &
               pivot_acceleration)
            call change_here(forces, here, changes(j), position, velocity, columns(:, j), pivot_velocity, &
               pivot_acceleration, accelerations(:, j), tensions(j))
            pivot_velocity = 0
            pivot_acceleration = 0
         else
            call change_here(forces, here, changes(j), position, velocity, columns(:, j), pivot_velocity, &
               pivot_acceleration, accelerations(:, j), tensions(j))
         end if
      end do
   end subroutine move_changes

   !> The rate at which the tension of a taut rod or string changes as the bob moves on [m/s3].
   pure real(wp) function tension_rate(forces, time, position, velocity, acceleration) result(rate)
      type(forces_type), intent(in) :: forces
      real(wp), intent(in) :: time                        !! Of the last `move` [s]
      real(wp), intent(in) :: position(3), velocity(3), acceleration(3)
      type(here_type) :: here
      type(forces_change_type) :: none
      real(wp) :: jerk(3), pivot_jerks(3), pivot_accelerations(3)

      pivot_accelerations = 0
      pivot_jerks = 0
      if (forces%has_moving_pivot) then
         pivot_accelerations = forces%pivot_acceleration
         pivot_jerks = pivot_jerk(forces%effects, time)
      end if
      call look(forces, .true., position, velocity, here)
      call change_here(forces, here, none, position, velocity, [velocity, acceleration], &
         pivot_accelerations, pivot_jerks, jerk, rate)
   end function tension_rate

   !> What the changes of all parameters share.
   pure subroutine look(forces, is_taut, position, velocity, here)
      type(forces_type), intent(in) :: forces
      logical, intent(in) :: is_taut
      real(wp), intent(in) :: position(3), velocity(3)
      type(here_type), intent(out) :: here
      real(wp) :: bending

      here%is_taut = is_taut
      here%seen = velocity
      if (forces%has_moving_pivot) here%seen = here%seen + forces%pivot_velocity
      here%through = here%seen - forces%effects%wind
      here%speed = norm2(here%through)
      associate (effects => forces%effects, force => here%force)
         force = [0.0_wp, 0.0_wp, -forces%weight]
         if (effects%sphere_speed > 0) then
            call sphere_drag(effects, here%speed, here%drag, here%drag_changes)
         else
            here%drag = effects%linear_drag + effects%quadratic_drag*here%speed
            here%drag_changes(:3) = [effects%quadratic_drag, 1.0_wp, here%speed]
         end if
         if (forces%has_drag) force = force - here%drag*here%through
         if (forces%has_turn) force = force - 2*cross(effects%turn_rate, here%seen)
         here%free = force/forces%inertia
         if (forces%has_moving_pivot) here%free = here%free - forces%pivot_acceleration
         if (.not. is_taut) return
         call stretch(forces%suspension, position, velocity, here%distance, here%outward, bending)
         if (forces%is_elastic) then
            here%pull = effects%stiffness*(here%distance - forces%suspension%radius)/forces%inertia
         else
            here%pull = dot_product(here%outward, here%free) + bending - forces%suspension%radius_bend
         end if
      end associate
   end subroutine look

   !> One column of `move_changes`.
   pure subroutine change_here(forces, here, change, position, velocity, column, pivot_velocity, pivot_acceleration, &
         acceleration, tension)
      type(forces_type), intent(in) :: forces
      type(here_type), intent(in) :: here
      type(forces_change_type), intent(in) :: change
      real(wp), intent(in) :: position(3), velocity(3), column(6)
      real(wp), intent(in) :: pivot_velocity(3), pivot_acceleration(3)  !! Changes
      real(wp), intent(out) :: acceleration(3), tension
      real(wp), dimension(3) :: free, seen, through, outward
      real(wp) :: drag, distance, bending, pull

      seen = column(4:6) + pivot_velocity
      free = [0.0_wp, 0.0_wp, -change%weight]
      associate (effects => forces%effects, new => change%effects)
         if (forces%has_drag) then
            through = seen
            if (change%has_wind) through = through - new%wind
            drag = 0
            ! |u| u has no slope at u = 0, and the first term of it none either.
            if (here%speed > 0) drag = here%drag_changes(1)*dot_product(here%through, through)/here%speed
            free = free - drag*here%through - here%drag*through
         end if
         if (change%has_drag) free = free - dot_product(here%drag_changes(2:), [new%linear_drag, new%quadratic_drag, &
            new%sphere_speed])*here%through
         if (forces%has_turn) free = free - 2*cross(effects%turn_rate, seen)
         if (change%has_turn) free = free - 2*cross(new%turn_rate, here%seen)
         free = (free - here%force*(change%inertia/forces%inertia))/forces%inertia - pivot_acceleration
         acceleration = free
         tension = 0
         if (.not. here%is_taut) return
         call stretch_change(forces%suspension, change%suspension, position, velocity, column(1:3), column(4:6), &
            distance, outward, bending)
         if (forces%is_elastic) then
            tension = new%stiffness*(here%distance - forces%suspension%radius) + effects%stiffness*(distance &
               - radius_change(forces%suspension, change%suspension))
            pull = (tension - here%pull*change%inertia)/forces%inertia
         else
            pull = dot_product(outward, here%free) + dot_product(here%outward, free) + bending
            tension = pull*forces%inertia + here%pull*change%inertia
         end if
         acceleration = free - pull*here%outward - here%pull*outward
      end associate
   end subroutine change_here

   !> The change of `mechanical_energy`.
   pure real(wp) function energy_change(forces, change, time, position, velocity, column) result(energy)
      type(forces_type), intent(in) :: forces
      type(forces_change_type), intent(in) :: change
      real(wp), intent(in) :: time                        !! [s]
      real(wp), intent(in) :: position(3), velocity(3)    !! Relative to the pivot [m], [m/s]
      real(wp), intent(in) :: column(6)                   !! Their changes
      real(wp), dimension(3) :: displacement, seen, moved, seen_change, unused, outward
      type(suspension_type) :: suspension
      real(wp) :: distance, bending, stretched

      call pivot_motion(forces%effects, time, displacement, seen)
      call pivot_change(forces%effects, change%effects, time, moved, seen_change, unused)
      seen = seen + velocity
      seen_change = seen_change + column(4:6)
      energy = change%inertia*dot_product(seen, seen)/2 + forces%inertia*dot_product(seen, seen_change) &
         + change%weight*(position(3) + displacement(3)) + forces%weight*(column(3) + moved(3))
      if (.not. forces%is_elastic) return
      suspension = forces%suspension
      if (forces%has_hoist) call lengthen(suspension, forces%effects, time)
      call stretch(suspension, position, velocity, distance, outward, bending)
      if (forces%effects%is_string .and. distance < suspension%radius) return
      stretched = distance - suspension%radius
      call stretch_change(suspension, change%suspension, position, velocity, column(1:3), column(4:6), &
         distance, outward, bending)
      energy = energy + change%effects%stiffness*stretched**2/2 &
         + forces%effects%stiffness*stretched*(distance - radius_change(suspension, change%suspension))
   end function energy_change

   !> How much a change changes a motion within the time sqrt(l/g), about, in units of length and speed: what its errors
   !> are small beside, until it has grown.
   pure real(wp) function natural_size(change, forces, length, gravity, unit_speed) result(size)
      type(change_type), intent(in) :: change
      type(forces_type), intent(in) :: forces
      real(wp), intent(in) :: length, gravity, unit_speed  !! [m], [m/s2], [m/s]
      real(wp), parameter :: two_pi = 2*acos(-1.0_wp)
      real(wp) :: time, turns(3)

      time = sqrt(length/gravity)
      associate (new => change%effects, old => forces%effects)
         turns = two_pi*time*old%pivot_frequency
         size = max(norm2(change%position)/length, norm2(change%velocity)/unit_speed, abs(change%length)/length, &
            abs(change%gravity)/gravity, time*abs(new%linear_drag), length*abs(new%quadratic_drag), &
            norm2(new%wind)*(old%linear_drag + old%quadratic_drag*unit_speed)*time/unit_speed, &
            time*norm2(new%turn_rate), maxval(abs(new%pivot_amplitude)*(turns**2 + turns))/length, &
            maxval(abs(old%pivot_amplitude*new%pivot_frequency)*time*(two_pi + turns))/length, &
            maxval(abs(old%pivot_amplitude*new%pivot_phase)*(turns**2 + turns))/length)
         size = max(size, maxval(new%extra_length)/length, time*abs(new%hoist_rate)/length, abs(new%restitution), &
            abs(new%density_ratio), abs(new%added_mass)*old%density_ratio)
         if (old%stiffness > 0) size = max(size, abs(new%stiffness)/old%stiffness)
      end associate
   end function natural_size

   pure function cross(a, b)
      real(wp), intent(in) :: a(3), b(3)
      real(wp) :: cross(3)

      cross = [a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
   end function cross

end module kyvadlo_force_changes
