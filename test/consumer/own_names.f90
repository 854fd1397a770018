!> A user's program has every plain word for itself beside `use kyvadlo`.
program own_names
   use kyvadlo
   implicit none
   double precision :: height, speed, phase, rise, locate, nome, modulus, quarter_period, acceleration, azimuth, value, &
      pair, error, fail, position(3), velocity(3), period, energy, momentum, tension, theta, sn, cn, dn, length, gravity, &
      state, advance
   integer, parameter :: real64 = kind(1d0)
   type(orbit_type) :: orbit
   type(kyvadlo_error_type), allocatable :: refusal

   length = 1
   gravity = 9.80665d0
   call new_orbit_from_heights(orbit, length, gravity, 0.25_real64, -0.75_real64, refusal)
   if (allocated(refusal)) error stop 'no orbit'
   period = orbit%period()
   energy = orbit%energy()
   momentum = orbit%momentum()
   modulus = orbit%modulus()
   nome = orbit%nome()
   quarter_period = orbit%quarter_period()
   call orbit%locate(period/3, position, velocity)
   height = orbit%height(period/3)
   rise = orbit%rise(period/3)
   speed = orbit%speed(period/3)
   phase = orbit%phase(period/3)
   azimuth = orbit%azimuth(period/3)
   acceleration = norm2(orbit%acceleration(period/3))
   tension = orbit%rod_force(period/3)
   call jacobi_functions(phase, modulus**2, sn, cn, dn)
   theta = theta_function(3, 0d0, nome)
   locate = norm2(position)
   value = sn**2 + cn**2
   pair = norm2(velocity)/speed
   state = sum(velocity**2)/2 + gravity*height
   advance = orbit%apsidal_advance()
   error = maxval(abs([locate - length, value - 1, pair - 1, (state - energy)/energy, rise - height - length]))
   fail = merge(1, 0, .not. (error <= 1d-12 .and. min(acceleration, tension, theta, dn, advance, azimuth, momentum, &
      quarter_period) > 0))
   if (fail > 0) error stop 'wrong numbers beside own names'
   print '(a)', 'every plain word is free'
end program own_names
