!> What moves the bob under the effects of a scene: one evaluation gives acceleration, tension and powers.
!>
!> Positions and velocities are relative to the pivot, in the axes of the laboratory (which may turn with the Earth). Forces
!> are per mass of the bob. With fluid moved along, forces are divided by the inertia 1 + added_mass*density_ratio; the
!> acceleration of the pivot is not, as the fluid rests in the laboratory, and Coriolis's acceleration is the bob's alone: in a fluid at
!> rest in the turning frame that of the added mass is balanced by the lift of the fluid's vorticity (T. R. Auton,
!> J. C. R. Hunt and M. Prud'homme, J. Fluid Mech. 197 (1988) 241).
module kyvadlo_forces
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_status, only: error_type, fail, code_domain
   use kyvadlo_effects, only: effects_type, check_effects, has_drag, has_moving_pivot
   use kyvadlo_buoyancy, only: effective_inertia, effective_weight
   use kyvadlo_pivot, only: pivot_motion
   use kyvadlo_suspension, only: suspension_type, new_suspension, stretch
   implicit none
   private
   public :: forces_type, new_forces, move, applied_acceleration, mechanical_energy

   !> Effects with what follows from them; the flags tell which terms are evaluated at all.
   type :: forces_type
      type(effects_type) :: effects
      type(suspension_type) :: suspension
      real(wp) :: weight = 0      !! Gravity less buoyancy [m/s2]
      real(wp) :: inertia = 1     !! Mass moved over the mass of the bob
      logical :: has_drag = .false., has_turn = .false., has_moving_pivot = .false., is_elastic = .false.
      logical :: has_more = .false.   !! Than weight and rod or string
   end type forces_type

contains

   !> Fails unless length and gravity are positive and every effect is in its domain.
   pure subroutine new_forces(forces, effects, length, gravity, error)
      type(forces_type), intent(out) :: forces
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: length, gravity    !! [m], [m/s2]
      type(error_type), allocatable, intent(out) :: error
      character(len=50) :: got

      if (.not. (length > 0 .and. gravity > 0 .and. ieee_is_finite(length) .and. ieee_is_finite(gravity))) then
         write (got, '(2es25.16)') length, gravity
         call fail(error, code_domain, 'forces: length and gravity must be positive and finite, got'//got)
         return
      end if
      call check_effects(effects, error)
      if (allocated(error)) return
      forces%effects = effects
      forces%weight = effective_weight(gravity, effects%density_ratio)
      forces%inertia = effective_inertia(effects%density_ratio, effects%added_mass)
      forces%has_drag = has_drag(effects)
      forces%has_turn = any(abs(effects%turn_rate) > 0)
      forces%has_moving_pivot = has_moving_pivot(effects)
      forces%is_elastic = effects%stiffness > 0
      forces%has_more = forces%has_drag .or. forces%has_turn .or. forces%has_moving_pivot .or. forces%inertia > 1
      call new_suspension(forces%suspension, length, effects%extra_length)
   end subroutine new_forces

   !> Everything that follows from a state.
   pure subroutine move(forces, is_taut, time, position, velocity, acceleration, tension, drag_power, pivot_power)
      type(forces_type), intent(in) :: forces
      logical, intent(in) :: is_taut               !! The rod or string acts; where not, the bob flies
      real(wp), intent(in) :: time                 !! [s]
      real(wp), intent(in) :: position(3), velocity(3) !! Relative to the pivot [m], [m/s]
      real(wp), intent(out) :: acceleration(3)     !! Relative to the pivot [m/s2]
      real(wp), intent(out) :: tension             !! Of rod or string, per mass of the bob [m/s2]
      real(wp), intent(out) :: drag_power          !! Of the drag in the laboratory, per mass of the bob [m2/s3]
      real(wp), intent(out) :: pivot_power         !! Of the pivot on the pendulum, likewise [m2/s3]
      real(wp) :: pivot_velocity(3), distance, outward(3), bending, pull, square

      call applied_acceleration(forces, time, velocity, acceleration, pivot_velocity, drag_power)
      tension = 0
      pivot_power = 0
      if (.not. is_taut) return
      if (forces%suspension%is_sphere .and. .not. forces%is_elastic) then
         ! The case below with outward = position/distance, written out for speed.
         square = position(1)**2 + position(2)**2 + position(3)**2
         pull = (position(1)*acceleration(1) + position(2)*acceleration(2) + position(3)*acceleration(3) &
            + velocity(1)**2 + velocity(2)**2 + velocity(3)**2)/square
         acceleration(1) = acceleration(1) - pull*position(1)
         acceleration(2) = acceleration(2) - pull*position(2)
         acceleration(3) = acceleration(3) - pull*position(3)
         pull = pull*forces%inertia
         tension = pull*sqrt(square)
         if (forces%has_moving_pivot) pivot_power = -pull*dot_product(position, pivot_velocity)
         return
      end if
      call stretch(forces%suspension, position, velocity, distance, outward, bending)
      if (forces%is_elastic) then
         tension = forces%effects%stiffness*(distance - forces%suspension%radius)
         pull = tension/forces%inertia
      else
         ! What keeps the distance constant.
         pull = dot_product(outward, acceleration) + bending
         tension = pull*forces%inertia
      end if
      acceleration = acceleration - pull*outward
      if (forces%has_moving_pivot) pivot_power = -tension*dot_product(outward, pivot_velocity)
   end subroutine move

   !> The acceleration relative to the pivot by everything but rod or string.
   pure subroutine applied_acceleration(forces, time, velocity, acceleration, pivot_velocity, drag_power)
      type(forces_type), intent(in) :: forces
      real(wp), intent(in) :: time, velocity(3)
      real(wp), intent(out) :: acceleration(3)
      real(wp), intent(out) :: pivot_velocity(3)  !! Set where the pivot moves [m/s]
      real(wp), intent(out) :: drag_power
      real(wp) :: in_laboratory(3), through_air(3), drag(3), displacement(3), pivot_acceleration(3)

      acceleration(1) = 0
      acceleration(2) = 0
      acceleration(3) = -forces%weight
      drag_power = 0
      if (.not. forces%has_more) return
      in_laboratory = velocity
      pivot_velocity = 0
      if (forces%has_moving_pivot) then
         call pivot_motion(forces%effects, time, displacement, pivot_velocity, pivot_acceleration)
         in_laboratory = velocity + pivot_velocity
      end if
      if (forces%has_drag) then
         through_air = in_laboratory - forces%effects%wind
         drag = -(forces%effects%linear_drag + forces%effects%quadratic_drag*sqrt(dot_product(through_air, through_air))) &
            *through_air
         drag_power = dot_product(drag, in_laboratory)
         acceleration = acceleration + drag
      end if
      if (forces%has_turn) then
         ! Coriolis; the constant centrifugal part belongs to the local gravity.
         associate (w => forces%effects%turn_rate, v => in_laboratory)
            acceleration(1) = acceleration(1) - 2*(w(2)*v(3) - w(3)*v(2))
            acceleration(2) = acceleration(2) - 2*(w(3)*v(1) - w(1)*v(3))
            acceleration(3) = acceleration(3) - 2*(w(1)*v(2) - w(2)*v(1))
         end associate
      end if
      if (forces%inertia > 1) acceleration = acceleration/forces%inertia
      if (forces%has_moving_pivot) acceleration = acceleration - pivot_acceleration
   end subroutine applied_acceleration

   !> Energy in the laboratory per mass of the bob: of motion, fluid moved included; of height above the origin, less buoyancy;
   !> of the spring. It changes by the work of drag and pivot, and by what is lost where a string becomes taut [m2/s2].
   pure real(wp) function mechanical_energy(effects, length, gravity, time, position, velocity) result(energy)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: length, gravity          !! [m], [m/s2]
      real(wp), intent(in) :: time                     !! [s]
      real(wp), intent(in) :: position(3), velocity(3) !! Relative to the pivot [m], [m/s]
      type(suspension_type) :: suspension
      real(wp) :: displacement(3), in_laboratory(3), distance, outward(3), bending

      call pivot_motion(effects, time, displacement, in_laboratory)
      in_laboratory = in_laboratory + velocity
      energy = effective_inertia(effects%density_ratio, effects%added_mass)*dot_product(in_laboratory, in_laboratory)/2 &
         + effective_weight(gravity, effects%density_ratio)*(position(3) + displacement(3))
      if (.not. effects%stiffness > 0) return
      call new_suspension(suspension, length, effects%extra_length)
      call stretch(suspension, position, velocity, distance, outward, bending)
      if (effects%is_string .and. distance < suspension%radius) return
      energy = energy + effects%stiffness*(distance - suspension%radius)**2/2
   end function mechanical_energy

end module kyvadlo_forces
