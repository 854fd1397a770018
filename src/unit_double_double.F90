!> One translation unit for the set-up of orbits in double-double arithmetic with its own copy of that arithmetic, which
!> the compiler inlines.
#include "pendulum/double_doubles.F90"
#include "pendulum/double_double_numbers.f90"
#include "pendulum/double_double_angle.F90"
#include "pendulum/three_part.f90"
#include "pendulum/gaps_double_double.F90"
#include "pendulum/double_double_constants.f90"
#include "pendulum/double_double_orbit.F90"
