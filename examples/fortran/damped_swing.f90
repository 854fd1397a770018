!> A pendulum of 1 m in a thin oil: what has no closed form is integrated, block by block.
program damped_swing
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo, only: kyvadlo_error_type
   use kyvadlo_effects, only: effects_type
   use kyvadlo_integrator, only: integration_type, new_integration
   implicit none
   integer, parameter :: samples = 4
   type(effects_type) :: effects
   type(integration_type) :: run
   type(kyvadlo_error_type), allocatable :: error
   real(wp) :: time(samples), position(3, samples), velocity(3, samples), tension(samples)
   real(wp) :: drag_work(samples), pivot_work(samples), momentum, energy
   integer :: block, i

   ! Every effect is off unless it is given; here a drag force over mass and speed of 0.05/s.
   effects%linear_drag = 0.05_wp
   call new_integration(run, effects, length=1.0_wp, gravity=9.80665_wp, position=[0.6_wp, 0.0_wp, -0.8_wp], &
      velocity=[0.0_wp, 1.5_wp, 0.0_wp], tolerance=1e-12_wp, error=error)
   if (allocated(error)) error stop error%message

   print '(a)', '    t [s]      z [m]   momentum/exp(-t/20)   energy - work'
   do block = 0, 1
      time = [(5.0_wp*(samples*block + i), i=1, samples)]
      call run%advance(time, position, velocity, tension, drag_work, pivot_work, error)
      if (allocated(error)) error stop error%message
      do i = 1, samples
         momentum = position(1, i)*velocity(2, i) - position(2, i)*velocity(1, i)
         energy = dot_product(velocity(:, i), velocity(:, i))/2 + 9.80665_wp*position(3, i)
         print '(f9.1, f11.6, f22.11, f16.9)', time(i), position(3, i), momentum*exp(time(i)/20), energy - drag_work(i)
      end do
   end do
   print '(i0, a)', run%steps, ' steps'
   call run%finish()
end program damped_swing
