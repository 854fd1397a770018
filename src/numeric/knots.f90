!> Passing the knots of tables: what begins there holds from there on. Where the pivot's displacements lie on straight
!> lines its velocity jumps there: a shock, the limit of ever shorter stretches of ever larger acceleration. A rod, or a
!> string that stays taut, takes the bob along without loss; on an elastic one, and in flight, it feels nothing.
module kyvadlo_knots
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_curves, only: rate_jump
   use kyvadlo_forces, only: lengthen, move
   use kyvadlo_pivot, only: next_knot, pivot_rates
   use kyvadlo_saltation, only: is_tangential
   use kyvadlo_stepper, only: let_go, problem_type, restart, stepper_type, unknowns
   use kyvadlo_string, only: event_slack, string_event_type
   use kyvadlo_suspension, only: put_on_surface, stretch, surface_change
   implicit none
   private
   public :: pass_knot, show_behind_knot, show_columns_behind_knot

contains

   !> The pieces of tables hold from now to the next knot, whatever begins there; now the acceleration, and the velocity
   !> of the pivot, may have jumped.
   subroutine pass_knot(stepper, closeness, ends_derivatives, left_with, knot, event, has_event)
      type(stepper_type), intent(inout) :: stepper
      real(wp), intent(in) :: closeness             !! Relative error of a margin
      logical, intent(inout) :: ends_derivatives    !! Behind here there are no derivatives
      real(wp), intent(inout) :: left_with          !! Radial speed at the start of the last flight [m/s]
      real(wp), intent(out) :: knot                 !! The next one; huge if there is none [s]
      type(string_event_type), intent(out) :: event
      logical, intent(out) :: has_event             !! A string goes slack
      real(wp) :: jump(3), closing
      logical :: is_taut

      has_event = .false.
      associate (problem => stepper%problem, forces => stepper%problem%forces)
         knot = next_knot(forces%effects, stepper%time)
         if (.not. abs(forces%until - knot) > 0) return
         forces%until = knot
         forces%pivot_time = -huge(knot)
         ! At the start the velocity is given as it is behind a knot.
         if (.not. (stepper%time > 0 .and. allocated(forces%effects%pivot_curve%times))) return
         jump = rate_jump(forces%effects%pivot_curve, stepper%time)
         if (allocated(stepper%sizes)) then
            if (is_across(stepper, jump, closeness)) ends_derivatives = .true.
            call show_columns_behind_knot(problem, stepper%time, stepper%y, stepper%columns)
         end if
         is_taut = problem%is_taut
         call take_shock(problem, stepper%time, jump, stepper%y, is_taut, closing)
         if (problem%is_taut .and. .not. is_taut) then
            left_with = closing
            call leave()
         else
            call restart(stepper)
            ! Slower along the sphere than before, a taut bob may be too slow for its height.
            if (forces%effects%is_string .and. problem%is_taut .and. .not. forces%is_elastic .and. &
               any(abs(jump) > 0) .and. stepper%tension < 0) call leave()
         end if
      end associate

   contains

      subroutine leave()
         has_event = .true.
         event = string_event_type(time=stepper%time, kind=event_slack, position=stepper%y(1:3))
         call let_go(stepper%problem, stepper%y(1:3))
         call restart(stepper)
      end subroutine leave
   end subroutine pass_knot

   !> What a jump of the pivot's velocity makes of a state.
   subroutine take_shock(problem, time, jump, y, is_taut, closing)
      type(problem_type), intent(inout) :: problem
      real(wp), intent(in) :: time                  !! [s]
      real(wp), intent(in) :: jump(3)               !! [m/s]
      real(wp), intent(inout) :: y(unknowns)
      logical, intent(inout) :: is_taut
      real(wp), intent(out) :: closing              !! Speed at which the pivot begins to come nearer [m/s]
      real(wp) :: distance, outward(3), bending, acceleration(3), pivot_velocity(3)

      closing = 0
      if (.not. any(abs(jump) > 0)) return
      associate (forces => problem%forces)
         if (is_taut .and. .not. forces%is_elastic) then
            if (forces%has_hoist) call lengthen(forces%suspension, forces%effects, time)
            call stretch(forces%suspension, y(1:3), y(4:6), distance, outward, bending)
            closing = dot_product(outward, jump)
         end if
         y(4:6) = y(4:6) - jump
         if (.not. is_taut .or. forces%is_elastic) return
         if (forces%effects%is_string .and. closing > 0) then
            is_taut = .false.
            return
         end if
         call put_on_surface(forces%suspension, y(1:3), y(4:6))
         if (problem%pivot_work == 0) return
         ! The pull in no time, times the mean velocity of pivot and winch along it.
         call pivot_rates(forces%effects, time, acceleration, pivot_velocity, .true., time)
         y(problem%pivot_work) = y(problem%pivot_work) + forces%inertia*closing*(dot_product(outward, &
            pivot_velocity + jump/2) + forces%suspension%radius_rate)
      end associate
   end subroutine take_shock

   !> Whether the jump of the pivot's velocity is one across a taut string: motions next to this one go slack, or do not
   !> where this one does.
   pure logical function is_across(stepper, jump, closeness)
      type(stepper_type), intent(in) :: stepper
      real(wp), intent(in) :: jump(3)               !! [m/s]
      real(wp), intent(in) :: closeness
      real(wp) :: distance, outward(3), bending, scale

      associate (problem => stepper%problem, forces => stepper%problem%forces)
         is_across = forces%effects%is_string .and. problem%is_taut .and. .not. forces%is_elastic .and. &
            any(abs(jump) > 0)
         if (.not. is_across) return
         call stretch(forces%suspension, stepper%y(1:3), stepper%y(4:6), distance, outward, bending)
         scale = norm2(stepper%rates(4:6)) + forces%weight + dot_product(stepper%y(4:6), stepper%y(4:6))/distance
         is_across = is_tangential(dot_product(outward, jump), scale, distance, closeness)
      end associate
   end function is_across

   !> A sample at the knot where the last step ended shows what begins there: velocity, tension and work.
   subroutine show_behind_knot(stepper, y, tension)
      type(stepper_type), intent(in) :: stepper
      real(wp), intent(inout) :: y(unknowns)
      real(wp), intent(inout) :: tension
      real(wp) :: jump(3), closing, until, acceleration(3), powers(2)
      logical :: is_taut

      associate (problem => stepper%problem, forces => stepper%problem%forces)
         jump = rate_jump(forces%effects%pivot_curve, stepper%time)
         if (.not. any(abs(jump) > 0)) return
         is_taut = problem%is_taut
         call take_shock(problem, stepper%time, jump, y, is_taut, closing)
         until = forces%until
         forces%until = huge(until)
         forces%pivot_time = -huge(until)
         call move(forces, is_taut, stepper%time, problem%base + y(1:3), y(4:6), acceleration, tension, powers)
         forces%until = until
         forces%pivot_time = -huge(until)
      end associate
   end subroutine show_behind_knot

   !> The derivatives there: the knot comes at the same time in every motion next to this one.
   subroutine show_columns_behind_knot(problem, time, y, columns)
      type(problem_type), intent(inout) :: problem
      real(wp), intent(in) :: time                  !! Of the knot [s]
      real(wp), intent(in) :: y(unknowns)           !! Before it
      real(wp), intent(inout) :: columns(:, :)      !! (6, p)
      real(wp) :: jump(3), distance, outward(3), bending
      integer :: j

      associate (forces => problem%forces)
         jump = rate_jump(forces%effects%pivot_curve, time)
         if (.not. any(abs(jump) > 0) .or. .not. problem%is_taut .or. forces%is_elastic) return
         if (forces%has_hoist) call lengthen(forces%suspension, forces%effects, time)
         call stretch(forces%suspension, y(1:3), y(4:6), distance, outward, bending)
         if (forces%effects%is_string .and. dot_product(outward, jump) > 0) return
         do j = 1, size(columns, 2)
            call surface_change(forces%suspension, problem%changes(j)%suspension, y(1:3), y(4:6) - jump, &
               columns(1:3, j), columns(4:6, j))
         end do
      end associate
   end subroutine show_columns_behind_knot

end module kyvadlo_knots
