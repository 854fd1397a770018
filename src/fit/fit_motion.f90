!> The motion of a fit with its derivatives along given changes of the numbers that determine it, in closed form or by
!> the
!> variational equations.
module kyvadlo_fit_motion
   use kyvadlo_derivatives_real64, only: derivatives_type, new_derivatives_from_state
   use kyvadlo_fit_physics, only: direction_type, gravity_felt, physics_type
   use kyvadlo_integrator, only: integration_type, new_integration
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_state_real64, only: new_orbit_from_state
   use kyvadlo_status, only: error_type
   implicit none
   private
   public :: find_states

contains

   !> States at ascending times, relative to the pivot and in resting axes, and their derivatives along directions.
   subroutine find_states(physics, directions, times, states, failed, matrices)
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)          !! (p)
      real(wp), intent(in) :: times(:)                           !! (n)
      real(wp), intent(out), contiguous :: states(:, :)                      !! (6, n)
      logical, intent(out) :: failed
      real(wp), intent(out), optional, contiguous :: matrices(:, :, :) !! (6, p, n); (3, p, n): of positions alone

      failed = .not. (physics%length > 0 .and. physics%gravity > 0)
      if (failed) return
      ! A try a billion times as fast as a pendulum swings explains nothing.
      failed = norm2(physics%velocity) > 1e9_wp*sqrt(physics%gravity*physics%length)
      if (failed) return
      if (size(times) == 0) return
      ! An absent array is not handed on: gfortran would form its bounds from what its descriptor never held.
      if (physics%is_exact .and. present(matrices)) then
         call exact_states(physics, directions, times, states, failed, matrices)
      else if (physics%is_exact) then
         call exact_states(physics, directions, times, states, failed)
      else if (present(matrices)) then
         call integrated_states(physics, directions, times, states, failed, matrices)
      else
         call integrated_states(physics, directions, times, states, failed)
      end if
      if (failed) return
      failed = .not. all(abs(states(:, size(times))) <= huge(1.0_wp))
   end subroutine find_states

   subroutine exact_states(physics, directions, times, states, failed, matrices)
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)
      real(wp), intent(in) :: times(:)
      real(wp), intent(out), contiguous :: states(:, :)
      logical, intent(out) :: failed
      real(wp), intent(out), optional, contiguous :: matrices(:, :, :)
      type(derivatives_type) :: derivatives
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      integer, parameter :: block = 64
      real(wp) :: weights(8, size(directions)), felt, r, a, dr, da, w
      real(wp) :: position(3, block), velocity(3, block), columns(6, 8, block)
      integer :: entries(8, size(directions)), filled(size(directions)), c, i, j, k, n, at

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
         ! Most are zero.
         filled(j) = 0
         do c = 1, 8
            if (.not. abs(weights(c, j)) > 0) cycle
            filled(j) = filled(j) + 1
            entries(filled(j), j) = c
         end do
      end do
      do i = 1, size(times), block
         n = min(block, size(times) - i + 1)
         call derivatives%evaluate(times(i:i + n - 1), position(:, :n), velocity(:, :n), columns(:, :, :n), &
            [1, 2, 3, 4, 5, 6, 7, 8])
         do k = 1, n
            at = i + k - 1
            states(1:3, at) = position(:, k)
            states(4:6, at) = velocity(:, k)
            do j = 1, size(directions)
               matrices(:, j, at) = 0
               do c = 1, filled(j)
                  w = weights(entries(c, j), j)
                  matrices(1, j, at) = matrices(1, j, at) + w*columns(1, entries(c, j), k)
                  matrices(2, j, at) = matrices(2, j, at) + w*columns(2, entries(c, j), k)
                  matrices(3, j, at) = matrices(3, j, at) + w*columns(3, entries(c, j), k)
                  if (size(matrices, 1) == 3) cycle
                  matrices(4:6, j, at) = matrices(4:6, j, at) + w*columns(4:6, entries(c, j), k)
               end do
            end do
         end do
      end do
   end subroutine exact_states

   subroutine integrated_states(physics, directions, times, states, failed, matrices)
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)
      real(wp), intent(in) :: times(:)
      real(wp), intent(out), contiguous :: states(:, :)
      logical, intent(out) :: failed
      real(wp), intent(out), optional, contiguous :: matrices(:, :, :)
      type(integration_type) :: run
      type(error_type), allocatable :: error
      real(wp), allocatable :: positions(:, :), velocities(:, :), tensions(:), works(:, :), whole(:, :, :)
      real(wp), parameter :: most_steps = 2e6_wp
      integer :: n

      n = size(times)
      allocate (positions(3, n), velocities(3, n), tensions(n), works(n, 2))
      if (present(matrices)) then
         call new_integration(run, physics%effects, physics%length, physics%gravity, physics%position, &
            physics%velocity, physics%tolerance, error, with_work=.false., most_steps=most_steps, &
            changes=directions%change)
         allocate (whole(6, size(directions), n))
         if (.not. allocated(error)) call run%advance(times, positions, velocities, tensions, works(:, 1), &
            works(:, 2), error, matrices=whole)
         if (.not. allocated(error)) matrices = whole(:size(matrices, 1), :, :)
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
   end subroutine integrated_states

end module kyvadlo_fit_motion
