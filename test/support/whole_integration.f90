!> The whole motion in one call, for tests.
module whole_integration
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_effects, only: effects_type
   use kyvadlo_integrator, only: integration_type, new_integration
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_status, only: error_type
   implicit none
   private
   public :: integrate

contains

   !> The whole motion in one call: new_integration, advance, finish.
   subroutine integrate(effects, length, gravity, start_position, start_velocity, times, tolerance, positions, &
      velocities, tensions, drag_work, pivot_work, error)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: length, gravity                    !! [m], [m/s2]
      real(wp), intent(in) :: start_position(3), start_velocity(3) !! Relative to the pivot [m], [m/s]
      real(wp), intent(in) :: times(:)                           !! (n) ascending from 0 [s]
      real(wp), intent(in) :: tolerance                          !! Of the error of a step
      real(wp), intent(out) :: positions(:, :), velocities(:, :) !! (3, n)
      real(wp), intent(out) :: tensions(:)                       !! (n)
      real(wp), intent(out) :: drag_work(:), pivot_work(:)       !! (n)
      type(error_type), allocatable, intent(out) :: error
      type(integration_type) :: run

      drag_work = quiet_nan_real64
      pivot_work = drag_work
      tensions = drag_work
      positions = quiet_nan_real64
      velocities = positions
      call new_integration(run, effects, length, gravity, start_position, start_velocity, tolerance, error)
      if (.not. allocated(error)) &
         call run%advance(times, positions, velocities, tensions, drag_work, pivot_work, error)
      call run%finish()
   end subroutine integrate

end module whole_integration
