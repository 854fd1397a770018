!> The elliptic functions of kyvadlo: kinds, arrays, complements, set-up once.
program elliptic_functions
   use, intrinsic :: iso_fortran_env, only: real32, real64, real128
   use kyvadlo, only: cubic_roots, elliptic_f, elliptic_k, elliptic_kc, elliptic_pi, jacobi_evaluate, jacobi_type, new_jacobi, &
      theta_derivative, theta_function
   implicit none
   type(jacobi_type) :: jacobi
   real(real64) :: sn(3), cn(3), dn(3), roots(3)
   integer :: count

   ! One name for three kinds
   print '(a, es13.5, es20.12, es40.31)', 'K(1/2) =', elliptic_k(0.5_real32), elliptic_k(0.5_real64), elliptic_k(0.5_real128)

   ! Elemental: arrays as well as single values
   print '(a, 3f17.12)', 'F(phi, 1/2) =', elliptic_f([0.5_real64, 1.0_real64, 100.0_real64], 0.5_real64)

   ! Next to m = 1 give 1 - m, which m itself cannot hold
   print '(a, f18.12)', 'K for 1-m = 1e-300:', elliptic_kc(1e-300_real64)

   ! The parameter set up once, many arguments
   jacobi = new_jacobi(0.5_real64)
   call jacobi_evaluate(jacobi, [0.5_real64, 1.0_real64, 100.0_real64], sn, cn, dn)
   print '(a, 3f17.12)', 'sn(u, 1/2) =', sn

   ! Principal value, for a characteristic above 1
   print '(a, f17.12)', 'Pi(1.5, 1/2) =', elliptic_pi(1.5_real64, 0.5_real64)

   ! A theta function and its derivative, on the real line and off it
   print '(a, 2f17.12)', 'theta_1(1, 0.1), derivative:', theta_function(1, 1.0_real64, 0.1_real64), &
      theta_derivative(1, 1.0_real64, 0.1_real64)
   print '(a, 2f17.12)', 'theta_3(1+i, 0.1) =', theta_function(3, (1.0_real64, 1.0_real64), 0.1_real64)

   ! x**3 - 3 x**2 + 3 x - 1 has one root, three times
   call cubic_roots(1.0_real64, -3.0_real64, 3.0_real64, -1.0_real64, roots, count)
   print '(i0, a, f4.1)', count, ' root:', roots(:count)
end program elliptic_functions
