!> Every elliptic function by its name, in three kinds: for the tests that go through all of them.
module elliptic_values_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use kyvadlo
#include "elliptic_values.inc"
end module elliptic_values_real32

module elliptic_values_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo
#include "elliptic_values.inc"
end module elliptic_values_real64

#ifndef KYVADLO_NO_REAL128
module elliptic_values_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo
#include "elliptic_values.inc"
end module elliptic_values_real128
#endif

module every_elliptic_value
   use elliptic_values_real32
   use elliptic_values_real64
#ifndef KYVADLO_NO_REAL128
   use elliptic_values_real128
#endif
   implicit none
   public

   type :: elliptic_function_type
      character(len=16) :: name
      integer :: arguments
   end type elliptic_function_type

   type(elliptic_function_type), parameter :: elliptic_functions(*) = [ &
      elliptic_function_type('rc', 2), elliptic_function_type('rf', 3), elliptic_function_type('rd', 3), &
      elliptic_function_type('rj', 4), elliptic_function_type('rg', 3), elliptic_function_type('cel', 4), &
      elliptic_function_type('el1', 2), elliptic_function_type('el2', 4), elliptic_function_type('el3', 3), &
      elliptic_function_type('K', 1), elliptic_function_type('Kc', 1), elliptic_function_type('E', 1), &
      elliptic_function_type('Ec', 1), elliptic_function_type('D', 1), elliptic_function_type('Dc', 1), &
      elliptic_function_type('B', 1), elliptic_function_type('Bc', 1), elliptic_function_type('Pi', 2), &
      elliptic_function_type('Pic', 2), elliptic_function_type('F', 2), elliptic_function_type('Fc', 2), &
      elliptic_function_type('Einc', 2), elliptic_function_type('Eincc', 2), elliptic_function_type('Dinc', 2), &
      elliptic_function_type('Dincc', 2), elliptic_function_type('Binc', 2), elliptic_function_type('Bincc', 2), &
      elliptic_function_type('Piinc', 3), elliptic_function_type('Piincc', 3), elliptic_function_type('zeta', 2), &
      elliptic_function_type('zetac', 2), elliptic_function_type('heuman', 2), elliptic_function_type('heumanc', 2), &
      elliptic_function_type('nome', 1), elliptic_function_type('nomec', 1), elliptic_function_type('jacobi', 2), &
      elliptic_function_type('jacobic', 2), elliptic_function_type('ratios', 2), elliptic_function_type('ratiosc', 2), &
      elliptic_function_type('theta', 3), elliptic_function_type('theta_slope', 3), &
      elliptic_function_type('theta_complex', 4), elliptic_function_type('cubic', 4)]

end module every_elliptic_value
