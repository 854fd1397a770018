!> What moves the bob under the effects of a scene: one evaluation gives acceleration, tension and powers.
!>
!> Positions and velocities are relative to the pivot, in the axes of the laboratory (which may turn with the Earth).
!> Forces are per mass of the bob. With fluid moved along, forces are divided by the inertia 1 +
!> added_mass*density_ratio; the acceleration of the pivot is not, as the fluid rests in the laboratory, and Coriolis's
!> acceleration is the bob's alone: in a fluid at rest in the turning frame that of the added mass is balanced by the
!> lift of the fluid's vorticity (T. R. Auton, J. C. R. Hunt and M. Prud'homme, J. Fluid Mech. 197 (1988) 241).
module kyvadlo_forces
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: is_finite
   use kyvadlo_status, only: error_type, fail, code_domain
   use kyvadlo_curves, only: look_up
   use kyvadlo_effects, only: effects_type, check_effects, has_drag, has_hoist, has_moving_pivot, largest_reynolds, &
      sphere_drag
   use kyvadlo_buoyancy, only: effective_inertia, effective_weight
   use kyvadlo_pivot, only: pivot_motion
   use kyvadlo_suspension, only: suspension_type, new_suspension, stretch
   implicit none
   private
   public :: forces_type, new_forces, lengthen, move, mechanical_energy

   !> Effects with what follows from them; the flags tell which terms are evaluated at all.
   type :: forces_type
      type(effects_type) :: effects
      type(suspension_type) :: suspension
      real(wp) :: weight = 0      !! Gravity less buoyancy [m/s2]
      real(wp) :: inertia = 1     !! Mass moved over the mass of the bob
      logical :: has_drag = .false., has_turn = .false., has_moving_pivot = .false., is_elastic = .false.
      logical :: has_hoist = .false.
      logical :: has_pivot_table = .false.
      integer :: pivot_axes(2) = [1, 0]           !! The first and the last along which it swings
      real(wp) :: pivot_rate(3) = 0, pivot_pull(3) = 0  !! 2 pi frequency, and its square times -amplitude [1/s], [m/s2]
      logical :: needs_pivot_velocity = .false.   !! For drag, Coriolis's acceleration or the work of the pivot
      logical :: is_beyond = .false.  !! The drag of a sphere was asked for beyond its curve
      real(wp) :: until = huge(1.0_wp)        !! Where the present pieces of tables end [s]
      real(wp) :: pivot_time = -huge(1.0_wp)  !! When the motion of the pivot was evaluated last [s], and what it was
      real(wp) :: pivot_velocity(3) = 0, pivot_acceleration(3) = 0
      logical :: has_more = .false.   !! Than weight and rod or string
   end type forces_type

contains

   !> Fails unless length and gravity are positive and every effect is in its domain.
   pure subroutine new_forces(forces, effects, length, gravity, error)
      type(forces_type), intent(out) :: forces
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: length, gravity    !! [m], [m/s2]
      type(error_type), allocatable, intent(out) :: error
      real(wp), parameter :: two_pi = 2*acos(-1.0_wp)
      character(len=50) :: got

      if (.not. (length > 0 .and. gravity > 0 .and. is_finite(length) .and. is_finite(gravity))) then
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
      forces%has_pivot_table = allocated(effects%pivot_times) .or. allocated(effects%pivot_curve%times)
      forces%pivot_rate = two_pi*effects%pivot_frequency
      forces%pivot_pull = -effects%pivot_amplitude*forces%pivot_rate**2
      associate (swings => abs(effects%pivot_amplitude) > 0)
         if (any(swings)) forces%pivot_axes = [findloc(swings, .true.), findloc(swings, .true., back=.true.)]
      end associate
      forces%is_elastic = effects%stiffness > 0
      forces%needs_pivot_velocity = forces%has_moving_pivot
      forces%has_more = forces%has_drag .or. forces%has_turn .or. forces%has_moving_pivot .or. forces%inertia > 1
      forces%has_hoist = has_hoist(effects)
      call new_suspension(forces%suspension, length, effects%extra_length)
      if (forces%has_hoist) call lengthen(forces%suspension, effects, 0.0_wp)
   end subroutine new_forces

   !> The surface as a winch makes it at a time.
   pure subroutine lengthen(suspension, effects, time)
      type(suspension_type), intent(inout) :: suspension
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: time                 !! [s]
      real(wp) :: longer(1, 0:2)

      longer = 0
      if (allocated(effects%hoist%times)) call look_up(effects%hoist, time, longer)
      suspension%time = time
      suspension%radius = suspension%first_radius + (longer(1, 0) + effects%hoist_rate*time)
      suspension%radius_rate = longer(1, 1) + effects%hoist_rate
      suspension%radius_bend = longer(1, 2)
   end subroutine lengthen

   !> Everything that follows from a state. The innermost procedure of an integration: scalars, and every effect in its
   !> place.
   pure subroutine move(forces, is_taut, time, position, velocity, acceleration, tension, powers)
      type(forces_type), intent(inout) :: forces   !! Only what it remembers of pivot, length and air changes
      logical, intent(in) :: is_taut               !! The rod or string acts; where not, the bob flies
      real(wp), intent(in) :: time                 !! [s]
      real(wp), intent(in) :: position(3), velocity(3) !! Relative to the pivot [m], [m/s]
      real(wp), intent(out) :: acceleration(3)     !! Relative to the pivot [m/s2]
      real(wp), intent(out) :: tension             !! Of rod or string, per mass of the bob [m/s2]
      real(wp), intent(out) :: powers(2)           !! Of the drag in the laboratory, of pivot and winch [m2/s3]
      real(wp) :: distance, outward(3), bending
      real(wp) :: ax, ay, az, pull, square

      ax = 0
      ay = 0
      az = -forces%weight
      powers(1) = 0
      powers(2) = 0
      if (forces%has_more) call add_forces(forces, time, velocity, ax, ay, az, powers(1))
      if (forces%has_hoist) call lengthen(forces%suspension, forces%effects, time)
      if (.not. is_taut) then
         tension = 0
         acceleration = [ax, ay, az]
      else if (forces%suspension%is_sphere) then
         ! The case below with outward = position/distance, written out for speed: the pull per distance.
         associate (x => position(1), y => position(2), z => position(3))
            square = x**2 + y**2 + z**2
            if (forces%is_elastic) then
               distance = sqrt(square)
               tension = forces%effects%stiffness*(distance - forces%suspension%radius)
               pull = tension/(forces%inertia*distance)
            else
               pull = (x*ax + y*ay + z*az + velocity(1)**2 + velocity(2)**2 + velocity(3)**2)/square
               if (forces%has_hoist) pull = pull - (forces%suspension%radius_rate**2 &
                  + forces%suspension%radius*forces%suspension%radius_bend)/square
               tension = pull*forces%inertia*forces%suspension%radius
            end if
            acceleration(1) = ax - pull*x
            acceleration(2) = ay - pull*y
            acceleration(3) = az - pull*z
            if (forces%needs_pivot_velocity) powers(2) = -pull*forces%inertia*dot_product(position, &
               forces%pivot_velocity)
            if (forces%has_hoist) powers(2) = powers(2) - tension*forces%suspension%radius_rate
         end associate
      else
         acceleration = [ax, ay, az]
         call stretch(forces%suspension, position, velocity, distance, outward, bending)
         if (forces%is_elastic) then
            tension = forces%effects%stiffness*(distance - forces%suspension%radius)
            pull = tension/forces%inertia
         else
            ! What keeps the distance as it should be.
            pull = dot_product(outward, acceleration) + bending - forces%suspension%radius_bend
            tension = pull*forces%inertia
         end if
         acceleration = acceleration - pull*outward
         if (forces%needs_pivot_velocity) powers(2) = -tension*dot_product(outward, forces%pivot_velocity)
         if (forces%has_hoist) powers(2) = powers(2) - tension*forces%suspension%radius_rate
      end if
   end subroutine move

   !> What acts besides weight and rod or string, added to the acceleration. (Called once, so that the compiler puts it
   !> there.)
   pure subroutine add_forces(forces, time, velocity, ax, ay, az, power)
      type(forces_type), intent(inout) :: forces
      real(wp), intent(in) :: time, velocity(3)
      real(wp), intent(inout) :: ax, ay, az
      real(wp), intent(inout) :: power             !! Of the drag
      real(wp) :: u, v, w, a, b, c, drag, speed

      ! In the laboratory.
      u = velocity(1)
      v = velocity(2)
      w = velocity(3)
      if (forces%has_moving_pivot) then
         ! A step evaluates three times at its end.
         if (abs(time - forces%pivot_time) > 0) then
            forces%pivot_time = time
            if (forces%has_pivot_table) then
               call pivot_rates(forces%effects, time, forces%pivot_acceleration, forces%pivot_velocity, &
                  forces%needs_pivot_velocity, forces%until)
            else
               call swing_pivot(forces, time)
            end if
         end if
         if (forces%needs_pivot_velocity) then
            u = u + forces%pivot_velocity(1)
            v = v + forces%pivot_velocity(2)
            w = w + forces%pivot_velocity(3)
         end if
      end if
      if (forces%has_drag) then
         a = u - forces%effects%wind(1)
         b = v - forces%effects%wind(2)
         c = w - forces%effects%wind(3)
         drag = forces%effects%linear_drag
         if (forces%effects%sphere_speed > 0) then
            speed = sqrt(a**2 + b**2 + c**2)
            forces%is_beyond = speed > largest_reynolds*forces%effects%sphere_speed
            call sphere_drag(forces%effects, speed, drag)
         else if (forces%effects%quadratic_drag > 0) then
            drag = drag + forces%effects%quadratic_drag*sqrt(a**2 + b**2 + c**2)
         end if
         ax = -drag*a
         ay = -drag*b
         c = -drag*c
         az = az + c
         power = ax*u + ay*v + c*w
      end if
      if (forces%has_turn) then
         ! Coriolis; the constant centrifugal part belongs to the local gravity.
         associate (turn => forces%effects%turn_rate)
            ax = ax - 2*(turn(2)*w - turn(3)*v)
            ay = ay - 2*(turn(3)*u - turn(1)*w)
            az = az - 2*(turn(1)*v - turn(2)*u)
         end associate
      end if
      if (forces%inertia > 1) then
         ax = ax/forces%inertia
         ay = ay/forces%inertia
         az = az/forces%inertia
      end if
      if (forces%has_moving_pivot) then
         ax = ax - forces%pivot_acceleration(1)
         ay = ay - forces%pivot_acceleration(2)
         az = az - forces%pivot_acceleration(3)
      end if
   end subroutine add_forces

   !> `pivot_rates` of a pivot without a table, the same bits: what does not change with time is not formed again.
   pure subroutine swing_pivot(forces, time)
      type(forces_type), intent(inout) :: forces
      real(wp), intent(in) :: time
      real(wp) :: angle
      integer :: i

      do i = forces%pivot_axes(1), forces%pivot_axes(2)
         angle = forces%pivot_rate(i)*time + forces%effects%pivot_phase(i)
         forces%pivot_acceleration(i) = forces%pivot_pull(i)*cos(angle)
         if (forces%needs_pivot_velocity) forces%pivot_velocity(i) = -forces%effects%pivot_amplitude(i)* &
            forces%pivot_rate(i)*sin(angle)
      end do
   end subroutine swing_pivot

   !> Energy in the laboratory per mass of the bob: of motion, fluid moved included; of height above the origin, less
   !> buoyancy; of the spring. It changes by the work of drag, pivot and winch, and by what is lost where a string
   !> becomes taut [m2/s2].
   pure real(wp) function mechanical_energy(effects, length, gravity, time, position, velocity) result(energy)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: length, gravity          !! [m], [m/s2]
      real(wp), intent(in) :: time                     !! [s]
      real(wp), intent(in) :: position(3), velocity(3) !! Relative to the pivot [m], [m/s]
      type(suspension_type) :: suspension
      real(wp) :: displacement(3), in_laboratory(3), distance, outward(3), bending

      call pivot_motion(effects, time, displacement, in_laboratory)
      in_laboratory = in_laboratory + velocity
      energy = effective_inertia(effects%density_ratio, effects%added_mass)*dot_product(in_laboratory, &
         in_laboratory)/2 + effective_weight(gravity, effects%density_ratio)*(position(3) + displacement(3))
      if (.not. effects%stiffness > 0) return
      call new_suspension(suspension, length, effects%extra_length)
      if (has_hoist(effects)) call lengthen(suspension, effects, time)
      call stretch(suspension, position, velocity, distance, outward, bending)
      if (effects%is_string .and. distance < suspension%radius) return
      energy = energy + effects%stiffness*(distance - suspension%radius)**2/2
   end function mechanical_energy

   ! A copy of this module's own, to be inlined in the innermost procedure.
#include "pivot_rates.inc"

end module kyvadlo_forces
