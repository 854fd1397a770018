!> One translation unit for the set-up of orbits with its own copy of the arithmetic in pairs, which the compiler
!> inlines: compiled by themselves the same files take 1.4 times as long for a set-up.
#include "pendulum/pairs.F90"
#include "pendulum/gaps.F90"
#include "pendulum/orbit.F90"
