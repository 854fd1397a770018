!> The motion of a fit with its derivatives along given changes of the numbers that determine it, in closed form or by
!> the variational equations.
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
      integer, parameter :: block = 256
      real(wp) :: weights(8, size(directions)), felt, position(3, block), velocity(3, block)
      real(wp), allocatable :: changes(:, :, :)
      integer, allocatable :: wanted(:)
      integer :: c, i, n

      felt = gravity_felt(physics)
      if (present(matrices)) then
         call new_derivatives_from_state(derivatives, physics%length, felt, physics%position, physics%velocity, error)
      else
         call new_orbit_from_state(orbit, physics%length, felt, physics%position, physics%velocity, error)
      end if
      failed = allocated(error)
      if (failed) return
      if (present(matrices)) then
         call weigh_columns(physics, directions, weights)
         wanted = pack([(c, c=1, 8)], any(abs(weights) > 0, 2))
         allocate (changes(6, size(wanted), block))
      end if
      do i = 1, size(times), block
         n = min(block, size(times) - i + 1)
         if (present(matrices)) then
            call derivatives%evaluate(times(i:i + n - 1), position(:, :n), velocity(:, :n), changes(:, :, :n), wanted)
            call combine(size(wanted), size(directions), size(matrices, 1), n, changes, weights(wanted, :), &
               matrices(:, :, i:i + n - 1))
         else
            call orbit%locate(times(i:i + n - 1), position(:, :n), velocity(:, :n))
         end if
         states(1:3, i:i + n - 1) = position(:, :n)
         states(4:6, i:i + n - 1) = velocity(:, :n)
      end do
   end subroutine exact_states

   !> What of the columns of position, velocity, length and gravity felt makes up each direction.
   pure subroutine weigh_columns(physics, directions, weights)
      type(physics_type), intent(in) :: physics
      type(direction_type), intent(in) :: directions(:)
      real(wp), intent(out) :: weights(:, :)             !! (8, p)
      real(wp) :: r, a, dr, da
      integer :: j

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
   end subroutine weigh_columns

   !> Changes along the directions, of positions alone or with the velocities. Most weights are zero.
   pure subroutine combine(columns, directions, rows, times, changes, weights, matrices)
      integer, intent(in) :: columns, directions, times
      integer, intent(in) :: rows                                !! 3 or 6
      real(wp), intent(in) :: changes(6, columns, times), weights(columns, directions)
      real(wp), intent(out) :: matrices(rows, directions, times)
      real(wp) :: filled(columns, directions), x, y, z
      integer :: entries(columns, directions), count(directions), c, e, first, j, k

      count = 0
      do j = 1, directions
         do c = 1, columns
            if (.not. abs(weights(c, j)) > 0) cycle
            count(j) = count(j) + 1
            entries(count(j), j) = c
            filled(count(j), j) = weights(c, j)
         end do
      end do
      do first = 1, rows, 3
         do k = 1, times
            do j = 1, directions
               x = 0
               y = 0
               z = 0
               do e = 1, count(j)
                  c = entries(e, j)
                  x = x + filled(e, j)*changes(first, c, k)
                  y = y + filled(e, j)*changes(first + 1, c, k)
                  z = z + filled(e, j)*changes(first + 2, c, k)
               end do
               matrices(first, j, k) = x
               matrices(first + 1, j, k) = y
               matrices(first + 2, j, k) = z
            end do
         end do
      end do
   end subroutine combine

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
         if (.not. allocated(error)) call run%advance(times, positions, velocities, tensions, works(:, 1), &
            works(:, 2), error)
      end if
      call run%finish()
      failed = allocated(error)
      if (failed) return
      states(1:3, :) = positions
      states(4:6, :) = velocities
   end subroutine integrated_states

end module kyvadlo_fit_motion
