!> The motion of a fit with its derivatives along given changes of the numbers that determine it, in closed form or by
!> the
!> variational equations.
module kyvadlo_fit_motion
   use kyvadlo_derivatives_real64, only: derivatives_type, new_derivatives_from_state
   use kyvadlo_effects, only: has_moving_pivot
   use kyvadlo_fit_physics, only: direction_type, gravity_felt, physics_type
   use kyvadlo_integrator, only: integration_type, new_integration
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_pivot, only: pivot_change, pivot_motion
   use kyvadlo_state_real64, only: new_orbit_from_state
   use kyvadlo_status, only: error_type
   implicit none
   private
   public :: find_states

contains

   !> States at ascending times as the scene's frame shows them, and their derivatives along directions.
   subroutine find_states(physics, directions, times, states, failed, matrices)
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)          !! (p)
      real(wp), intent(in) :: times(:)                           !! (n)
      real(wp), intent(out) :: states(:, :)                      !! (6, n)
      logical, intent(out) :: failed
      real(wp), intent(out), optional :: matrices(:, :, :)       !! (6, p, n)

      failed = .not. (physics%length > 0 .and. physics%gravity > 0)
      if (failed) return
      if (size(times) == 0) return
      if (physics%is_exact) then
         call exact_states(physics, directions, times, states, failed, matrices)
      else
         call integrated_states(physics, directions, times, states, failed, matrices)
      end if
      if (failed) return
      failed = .not. all(abs(states(:, size(times))) <= huge(1.0_wp))
      if (abs(physics%frame_rate) > 0 .or. any(abs(directions%frame_rate) > 0)) &
         call turn(physics, directions, times, states, matrices)
   end subroutine find_states

   subroutine exact_states(physics, directions, times, states, failed, matrices)
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)
      real(wp), intent(in) :: times(:)
      real(wp), intent(out) :: states(:, :)
      logical, intent(out) :: failed
      real(wp), intent(out), optional :: matrices(:, :, :)
      type(derivatives_type) :: derivatives
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      integer, parameter :: block = 64
      real(wp) :: weights(8, size(directions)), felt, r, a, dr, da
      real(wp) :: position(3, block), velocity(3, block), columns(6, 8, block)
      integer :: i, j, k, n

      felt = gravity_felt(physics)
      if (.not. present(matrices)) then
         call new_orbit_from_state(orbit, physics%length, felt, physics%position, physics%velocity, error)
         failed = allocated(error)
         if (failed) return
         do i = 1, size(times), block
            n = min(block, size(times) - i + 1)
            call orbit%locate(times(i:i + n - 1), position(:, :n), velocity(:, :n))
            states(1:3, i:i + n - 1) = position(:, :n)
            states(4:6, i:i + n - 1) = velocity(:, :n)
         end do
         return
      end if
      call new_derivatives_from_state(derivatives, physics%length, felt, physics%position, physics%velocity, error)
      failed = allocated(error)
      if (failed) return
      r = physics%effects%density_ratio
      a = physics%effects%added_mass
      do j = 1, size(directions)
         associate (change => directions(j)%change)
            dr = change%effects%density_ratio
            da = change%effects%added_mass
            weights(:, j) = [change%position, change%velocity, change%length, change%gravity*(1 - r)/(1 + a*r) &
               + physics%gravity*(-dr*(1 + a*r) - (1 - r)*(da*r + a*dr))/(1 + a*r)**2]
         end associate
      end do
      do i = 1, size(times), block
         n = min(block, size(times) - i + 1)
         call derivatives%evaluate(times(i:i + n - 1), position(:, :n), velocity(:, :n), columns(:, :, :n), &
            [1, 2, 3, 4, 5, 6, 7, 8])
         do k = 1, n
            states(1:3, i + k - 1) = position(:, k)
            states(4:6, i + k - 1) = velocity(:, k)
            do j = 1, size(directions)
               matrices(:, j, i + k - 1) = matmul(columns(:, :, k), weights(:, j))
            end do
         end do
      end do
   end subroutine exact_states

   subroutine integrated_states(physics, directions, times, states, failed, matrices)
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)
      real(wp), intent(in) :: times(:)
      real(wp), intent(out) :: states(:, :)
      logical, intent(out) :: failed
      real(wp), intent(out), optional :: matrices(:, :, :)
      type(integration_type) :: run
      type(error_type), allocatable :: error
      real(wp), allocatable :: positions(:, :), velocities(:, :), tensions(:), works(:, :)
      real(wp), parameter :: most_steps = 2e6_wp
      real(wp) :: displacement(3), velocity(3), acceleration(3)
      integer :: n, i, j

      n = size(times)
      allocate (positions(3, n), velocities(3, n), tensions(n), works(n, 2))
      if (present(matrices)) then
         call new_integration(run, physics%effects, physics%length, physics%gravity, physics%position, &
            physics%velocity, physics%tolerance, error, with_work=.false., most_steps=most_steps, &
            changes=directions%change)
         if (.not. allocated(error)) call run%advance(times, positions, velocities, tensions, works(:, 1), works(:, &
            2), &
            error, matrices=matrices)
      else
         call new_integration(run, physics%effects, physics%length, physics%gravity, physics%position, &
            physics%velocity, physics%tolerance, error, with_work=.false., most_steps=most_steps)
         if (.not. allocated(error)) call run%advance(times, positions, velocities, tensions, works(:, 1), works(:, &
            2), &
            error)
      end if
      call run%finish()
      failed = allocated(error)
      if (failed) return
      states(1:3, :) = positions
      states(4:6, :) = velocities
      if (.not. (has_moving_pivot(physics%effects) .or. any(abs(physics%effects%pivot_amplitude) > 0))) return
      do i = 1, n
         call pivot_motion(physics%effects, times(i), displacement, velocity)
         states(:, i) = states(:, i) + [displacement, velocity]
         if (.not. present(matrices)) cycle
         do j = 1, size(directions)
            call pivot_change(physics%effects, directions(j)%change%effects, times(i), displacement, velocity, &
               acceleration)
            matrices(:, j, i) = matrices(:, j, i) + [displacement, velocity]
         end do
      end do
   end subroutine integrated_states

   !> As seen from the turning frame.
   subroutine turn(physics, directions, times, states, matrices)
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)
      real(wp), intent(in) :: times(:)
      real(wp), intent(inout) :: states(:, :)
      real(wp), intent(inout), optional :: matrices(:, :, :)
      real(wp) :: c, s, seen(6), at(6)
      integer :: i, j

      do i = 1, size(times)
         c = cos(physics%frame_rate*times(i))
         s = sin(physics%frame_rate*times(i))
         at = states(:, i)
         states(:, i) = turned(at)
         if (.not. present(matrices)) cycle
         seen = states(:, i)
         do j = 1, size(directions)
            matrices(:, j, i) = turned(matrices(:, j, i)) + directions(j)%frame_rate*(times(i)*[seen(2), -seen(1), &
               0.0_wp, seen(5), -seen(4), 0.0_wp] + [0.0_wp, 0.0_wp, 0.0_wp, seen(2), -seen(1), 0.0_wp])
         end do
      end do

   contains

      pure function turned(a) result(b)
         real(wp), intent(in) :: a(6)
         real(wp) :: b(6)

         b = [c*a(1) + s*a(2), c*a(2) - s*a(1), a(3), c*a(4) + s*a(5), c*a(5) - s*a(4), a(6)]
         b(4:5) = b(4:5) + physics%frame_rate*[b(2), -b(1)]
      end function turned
   end subroutine turn

end module kyvadlo_fit_motion
