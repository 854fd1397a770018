!> Where a string goes slack and becomes taut again in an integrated motion, and what the bob does there.
!>
!> A taut string whose tension vanishes lets the bob fly; a flight ends where the bob is a length away again. Either is
!> found in a step where the margin (tension, or distance left to the surface) is negative at its end or at points
!> between, and then located by steps of the integrator itself to the last digits. A string without elasticity takes the
!> radial velocity, or gives it back reversed and times the coefficient of restitution; rebounds end by the rule of
!> module kyvadlo_string.
!>
!> The derivatives of the motion go on through slack and an elastic taut as they are, since no force jumps there. At the
!> others they take their jump (saltation), because a neighbouring motion arrives at another time: doc/effects.md. Where
!> the bob only touches, a neighbour has no such event, and there is no derivative.
module kyvadlo_string_contact
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_force_changes, only: tension_rate
   use kyvadlo_forces, only: move
   use kyvadlo_pivot, only: pivot_rates
   use kyvadlo_saltation, only: is_tangential, jump_at_shock
   use kyvadlo_suspension, only: put_on_surface, stretch, surface_excess
   use kyvadlo_stepper, only: let_go, problem_type, restart, stepper_type, trial_step, &
      trial_with_columns, unknowns
   use kyvadlo_string, only: string_event_type, event_slack, event_taut, event_rebound, event_end_of_rattling
   implicit none
   private
   public :: contact_type, find_contact, make_contact

   !> Rebounds end, as if inelastic, when the radial speed is below this part of the scale of speeds: the bob then would
   !> come off by less than its square, an epsilon of the length. The rule of kyvadlo_string.
   real(wp), parameter :: rattling = sqrt(epsilon(1.0_wp))
   !> Halvings that take a step below what its length resolves.
   integer, parameter :: most_halvings = digits(1.0_wp)

   type :: contact_type
      real(wp) :: unit_speed = 1       !! Scale of speeds [m/s]
      logical :: is_touching = .false. !! The tension only touched zero; it is watched again once it is positive
      real(wp) :: closeness = 0        !! Relative error of a margin [1]
      real(wp) :: left_with = 0        !! Radial speed after the last rebound, of a flight that began with one [m/s]
      logical :: is_tangential = .false. !! The last event was, where there are derivatives
   end type contact_type

contains

   !> Ends the last step where the string goes slack or taut in it, if it does.
   subroutine find_contact(stepper, contact, found)
      type(stepper_type), intent(inout) :: stepper
      type(contact_type), intent(inout) :: contact
      logical, intent(out) :: found
      real(wp) :: h, low, high, at_low, at_high, root

      found = .false.
      if (contact%is_touching) then
         contact%is_touching = .not. stepper%tension > 0
         return
      end if
      h = stepper%time - stepper%start
      call bracket(stepper, h, low, high)
      if (.not. high > 0 .and. allocated(stepper%sizes)) then
         call look_for_touch(stepper, contact, h)
         found = contact%is_tangential
      end if
      if (.not. high > 0) return
      at_high = margin_after(stepper, high)
      ! The points between were those of a polynomial; the integrator may see it otherwise.
      if (at_high >= 0) return
      at_low = margin_after(stepper, low)
      if (low <= 0 .or. at_low < 0) then
         ! A flight begins with no margin: a short stretch of it has one.
         call shrink(stepper, low, high, at_low, at_high)
      end if
      if (at_low > 0) then
         root = root_between(stepper, low, high, at_low, at_high)
      else
         root = 0
      end if
      stepper%time = stepper%start + root
      call trial_step(stepper, root, stepper%y, stepper%rates, stepper%tension)
      stepper%rates(1:3) = stepper%y(4:6)
      ! A flight of no length is none.
      contact%is_touching = .not. root > 0 .and. .not. stepper%problem%is_taut
      if (allocated(stepper%sizes)) then
         call trial_with_columns(stepper, root, stepper%y, stepper%rates, stepper%tension, stepper%columns, &
            stepper%column_rates)
         contact%is_tangential = .not. root > 0
      end if
      found = .true.
   end subroutine find_contact

   !> The first point of the last step known to be without margin, and one before it; high = 0 if there is none.
   subroutine bracket(stepper, h, low, high)
      type(stepper_type), intent(in) :: stepper
      real(wp), intent(in) :: h
      real(wp), intent(out) :: low, high
      integer, parameter :: parts = 4
      real(wp) :: margins(0:parts), lowest, x
      integer :: i

      low = 0
      high = 0
      margins(0) = margin(stepper%problem, stepper%start_y, stepper%start_tension)
      margins(parts) = margin(stepper%problem, stepper%y, stepper%tension)
      if (margins(parts) >= 0 .and. min(margins(0), margins(parts)) > dip(stepper, h)) return
      do i = 1, parts - 1
         margins(i) = margin_between(stepper, h, i/real(parts, wp))
      end do
      do i = 1, parts
         if (margins(i) < 0) then
            high = h*i/parts
            low = h*(i - 1)/parts
            return
         end if
      end do
      ! The lowest point of the parabola through the least of them and its neighbours.
      i = minloc(margins(1:parts - 1), 1)
      lowest = margins(i + 1) - 2*margins(i) + margins(i - 1)
      if (.not. lowest > 0) return
      x = (margins(i - 1) - margins(i + 1))/(2*lowest)
      if (.not. abs(x) <= 1) return
      if (margin_between(stepper, h, (i + x)/parts) >= 0) return
      low = h*(i - 1)/parts
      high = h*(i + x)/parts
   end subroutine bracket

   !> Whether the margin vanishes at its least within a step without event: then motions next to this have one. The step
   !> ends there.
   subroutine look_for_touch(stepper, contact, h)
      type(stepper_type), intent(inout) :: stepper
      type(contact_type), intent(inout) :: contact
      real(wp), intent(in) :: h
      real(wp) :: low, high, at_low, at_high, x, y(unknowns), rates(unknowns), tension, scale
      integer, parameter :: parts = 8
      integer :: i

      if (min(margin(stepper%problem, stepper%start_y, stepper%start_tension), margin(stepper%problem, stepper%y, &
         stepper%tension)) > dip(stepper, h)) return
      low = 0
      high = 0
      at_high = margin_rate(stepper%problem, stepper%start, stepper%start_y, stepper%start_rates)
      do i = 1, parts
         low = high
         at_low = at_high
         high = h*i/parts
         call trial_step(stepper, high, y, rates, tension)
         at_high = margin_rate(stepper%problem, stepper%start + high, y, rates)
         if (at_low < 0 .and. at_high > 0) exit
      end do
      if (i > parts) return
      ! At the least margin an error of its time counts squared.
      x = high
      do while (high - low > sqrt(epsilon(h))*h)
         x = (low + high)/2
         call trial_step(stepper, x, y, rates, tension)
         if (margin_rate(stepper%problem, stepper%start + x, y, rates) < 0) then
            low = x
         else
            high = x
         end if
      end do
      associate (forces => stepper%problem%forces)
         scale = forces%suspension%radius**2
         if (stepper%problem%is_taut) scale = forces%inertia*(norm2(rates(4:6)) + forces%weight)
         if (stepper%problem%is_taut .and. forces%is_elastic) scale = forces%effects%stiffness*forces%suspension%radius
      end associate
      if (.not. margin(stepper%problem, y, tension) <= contact%closeness*scale) return
      contact%is_tangential = .true.
      stepper%time = stepper%start + x
   end subroutine look_for_touch

   !> The rate at which the margin changes.
   real(wp) function margin_rate(problem, time, y, rates) result(rate)
      type(problem_type), intent(inout) :: problem
      real(wp), intent(in) :: time, y(:), rates(:)
      real(wp) :: distance, outward(3), bending, acceleration(3), tension, powers(2)

      if (problem%is_taut) then
         call move(problem%forces, .true., time, y(1:3), y(4:6), acceleration, tension, powers)
         rate = tension_rate(problem%forces, time, y(1:3), y(4:6), rates(4:6))
      else
         call stretch(problem%forces%suspension, problem%base + y(1:3), y(4:6), distance, outward, bending)
         rate = -distance*dot_product(outward, y(4:6))
      end if
   end function margin_rate

   !> How deep the margin may dip between the ends of a step, if it changes like the motion: second derivative times
   !> h**2/2, four times what a parabola could.
   pure real(wp) function dip(stepper, h)
      type(stepper_type), intent(in) :: stepper
      real(wp), intent(in) :: h
      real(wp) :: scale

      associate (problem => stepper%problem, forces => stepper%problem%forces)
         scale = norm2(stepper%rates(4:6)) + forces%weight + dot_product(stepper%y(4:6), &
            stepper%y(4:6))/forces%suspension%radius
         if (.not. problem%is_taut) then
            dip = scale*forces%suspension%radius*h**2/2
         else if (forces%is_elastic) then
            dip = (forces%effects%stiffness*h**2/2)*scale
         else
            dip = scale**2*h**2/(2*forces%suspension%radius)
         end if
      end associate
   end function dip

   !> Tension, or how far the square of the distance is from that of the surface, halved: negative where the kind of
   !> motion ends.
   pure real(wp) function margin(problem, y, tension)
      type(problem_type), intent(in) :: problem
      real(wp), intent(in) :: y(:), tension

      if (problem%is_taut) then
         margin = tension
      else
         margin = problem%slack - surface_excess(problem%forces%suspension, problem%base, y(1:3))
      end if
   end function margin

   real(wp) function margin_after(stepper, h)
      type(stepper_type), intent(in) :: stepper
      real(wp), intent(in) :: h
      real(wp) :: y(unknowns), rates(unknowns), tension

      call trial_step(stepper, h, y, rates, tension)
      margin_after = margin(stepper%problem, y, tension)
   end function margin_after

   !> Margin at a part of the last step, along the quintic that has place, velocity and acceleration at its ends.
   real(wp) function margin_between(stepper, h, x)
      type(stepper_type), intent(in) :: stepper
      real(wp), intent(in) :: h, x
      real(wp) :: y(6), acceleration(3), tension, powers(2)
      real(wp), dimension(3) :: p, v, a, change, rise, bend, c3, c4, c5

      p = stepper%start_y(1:3)
      v = stepper%start_y(4:6)*h
      a = stepper%start_rates(4:6)*h**2/2
      change = stepper%y(1:3) - p - v - a
      rise = stepper%y(4:6)*h - v - 2*a
      bend = stepper%rates(4:6)*h**2/2 - a
      c3 = 10*change - 4*rise + bend
      c4 = 7*rise - 15*change - 2*bend
      c5 = 6*change - 3*rise + bend
      y(1:3) = p + x*(v + x*(a + x*(c3 + x*(c4 + x*c5))))
      tension = 0
      if (stepper%problem%is_taut) then
         y(4:6) = (v + x*(2*a + x*(3*c3 + x*(4*c4 + x*5*c5))))/h
         call move(stepper%problem%forces, .true., stepper%start + x*h, y(1:3), y(4:6), acceleration, tension, powers)
      end if
      margin_between = margin(stepper%problem, y, tension)
   end function margin_between

   !> Halves the stretch from the start of the step until there is margin at its end.
   subroutine shrink(stepper, low, high, at_low, at_high)
      type(stepper_type), intent(in) :: stepper
      real(wp), intent(out) :: low, at_low
      real(wp), intent(inout) :: high, at_high
      integer :: i

      low = high
      do i = 1, most_halvings
         low = low/2
         at_low = margin_after(stepper, low)
         if (at_low > 0) return
         high = low
         at_high = at_low
      end do
   end subroutine shrink

   !> Regula falsi with the Illinois rule: the end that stays has its value halved.
   real(wp) function root_between(stepper, from, to, at_from, at_to) result(root)
      type(stepper_type), intent(in) :: stepper
      real(wp), intent(in) :: from, to, at_from, at_to  !! Margins of opposite sign
      real(wp) :: low, high, at_low, at_high, value, before
      integer :: i

      low = from
      high = to
      at_low = at_from
      at_high = at_to
      root = high
      ! It converges with order 1.44, from the first step in far fewer than the bisections.
      do i = 1, 2*most_halvings
         before = root
         root = (low*at_high - high*at_low)/(at_high - at_low)
         if (.not. (root > low .and. root < high)) root = (low + high)/2
         value = margin_after(stepper, root)
         if (abs(value) <= 0 .or. abs(root - before) <= 2*epsilon(root)*root .or. high &
            - low <= 2*epsilon(root)*high) return
         if (value < 0) then
            high = root
            at_high = value
            if (before >= root) at_low = at_low/2
         else
            low = root
            at_low = value
            if (before <= root) at_high = at_high/2
         end if
      end do
   end function root_between

   !> Carries the motion over the contact where the last step ended, and tells of it.
   subroutine make_contact(stepper, contact, event)
      type(stepper_type), intent(inout) :: stepper
      type(contact_type), intent(inout) :: contact
      type(string_event_type), intent(out) :: event
      real(wp) :: distance, outward(3), bending, radial, back, pivot_velocity(3), pivot_acceleration(3), before(9)

      before = [stepper%y(1:3) + stepper%problem%base, stepper%y(4:6), stepper%rates(4:6)]
      back = 0
      radial = 0
      if (allocated(stepper%sizes)) call look_for_tangency(stepper, contact, before)
      associate (problem => stepper%problem, p => stepper%y(1:3), v => stepper%y(4:6))
         event%time = stepper%time
         event%kind = event_slack
         p = p + problem%base
         problem%base = 0
         problem%slack = 0
         if (problem%is_taut) then
            event%position = p
            call let_go(problem, p)
         else if (problem%forces%is_elastic) then
            event%kind = event_taut
            event%position = p
            problem%is_taut = .true.
         else
            call stretch(problem%forces%suspension, p, v, distance, outward, bending)
            radial = max(0.0_wp, dot_product(outward, v))
            call put_on_surface(problem%forces%suspension, p, v)
            event%position = p
            back = problem%forces%effects%restitution
            event%kind = event_rebound
            if (.not. back*radial > rattling*contact%unit_speed) then
               event%kind = merge(event_end_of_rattling, event_taut, back > 0)
               back = 0
            end if
            v = v - back*radial*outward
            event%energy_lost = problem%forces%inertia*(1 - back)*(1 + back)*radial**2/2
            if (problem%pivot_work > 0) then
               ! The pull of the string in no time, on a pivot that moves.
               call pivot_rates(problem%forces%effects, stepper%time, pivot_acceleration, pivot_velocity, .true., &
                  problem%forces%until)
               stepper%y(problem%pivot_work) = stepper%y(problem%pivot_work) &
                  - problem%forces%inertia*(1 + back)*radial*dot_product(outward, pivot_velocity)
            end if
            problem%is_taut = .true.
            if (back > 0) call let_go(problem, p)
         end if
         call restart(stepper)
         ! Without radial velocity the bob may still be too slow for its height: then it falls at once.
         if (problem%is_taut .and. stepper%tension < 0 .and. .not. contact%is_touching .and. &
            .not. problem%forces%is_elastic) then
            call let_go(problem, p)
            call restart(stepper)
         end if
         contact%left_with = back*radial
         if (allocated(stepper%sizes) .and. event%kind /= event_slack .and. .not. problem%forces%is_elastic) &
            call jump_columns(stepper, before, back)
      end associate
   end subroutine make_contact

   !> Whether an event is one that a motion next to this does not have: the margin passes zero with a slope that the
   !> error of the margin and its bend could make vanish.
   subroutine look_for_tangency(stepper, contact, before)
      type(stepper_type), intent(in) :: stepper
      type(contact_type), intent(inout) :: contact
      real(wp), intent(in) :: before(9)         !! Position, velocity and acceleration before the event
      real(wp) :: distance, outward(3), bending, scale, slope

      associate (forces => stepper%problem%forces, p => before(1:3), v => before(4:6), a => before(7:9))
         ! Of the second derivative of a distance.
         scale = norm2(a) + forces%weight + dot_product(v, v)/forces%suspension%radius
         if (stepper%problem%is_taut .and. .not. forces%is_elastic) then
            slope = tension_rate(forces, stepper%time, p, v, a)/(forces%inertia*scale)*forces%suspension%radius
         else
            call stretch(forces%suspension, p, v, distance, outward, bending)
            slope = dot_product(outward, v)
         end if
         if (is_tangential(slope, scale, forces%suspension%radius, contact%closeness)) contact%is_tangential = .true.
         ! Ever smaller rebounds are none.
         if (contact%left_with > 0 .and. slope > sqrt(contact%closeness)*contact%left_with) &
            contact%is_tangential = .false.
      end associate
   end subroutine look_for_tangency

   !> The jump of the columns where an inextensible string becomes taut.
   subroutine jump_columns(stepper, before, back)
      type(stepper_type), intent(inout) :: stepper    !! After the event
      real(wp), intent(in) :: before(9)               !! Position, velocity and acceleration before it
      real(wp), intent(in) :: back                    !! The part of the radial speed that comes back
      integer :: j

      associate (problem => stepper%problem)
         do j = 1, size(problem%changes)
            call jump_at_shock(problem%forces%suspension, problem%changes(j)%suspension, before, &
               [stepper%y(4:6), stepper%rates(4:6)], back, problem%changes(j)%effects%restitution, &
               stepper%columns(:, j))
         end do
      end associate
      call restart(stepper)
   end subroutine jump_columns

end module kyvadlo_string_contact
