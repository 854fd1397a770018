!> The numbers that determine an orbit of a study, exact in binary, and the orbit they give in each of three kinds.
module kyvadlo_study_start
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   private
   public :: study_start_type

   !> What every method is given. Built-in orbits need 24 binary digits, so that all kinds are asked the same question.
   type :: study_start_type
      real(real64) :: length = 1, gravity = 1  !! l [m], g [m/s2]
      logical :: by_rises = .false.
      real(real64) :: first = 0, second = 0    !! l - z1, l + z2; or l + z1, l + z2 if by_rises [m]
   end type study_start_type
end module kyvadlo_study_start

module kyvadlo_study_start_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use kyvadlo_orbit_real32, only: new_orbit_from_gaps, new_orbit_from_rises, orbit_type
#include "study_start.inc"
end module kyvadlo_study_start_real32

module kyvadlo_study_start_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_orbit_real64, only: new_orbit_from_gaps, new_orbit_from_rises, orbit_type
#include "study_start.inc"
end module kyvadlo_study_start_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_study_start_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_orbit_real128, only: new_orbit_from_gaps, new_orbit_from_rises, orbit_type
#include "study_start.inc"
end module kyvadlo_study_start_real128
#endif

module kyvadlo_study_set_up
   use kyvadlo_study_start
   use kyvadlo_study_start_real32
   use kyvadlo_study_start_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_study_start_real128
#endif
   implicit none
   public
end module kyvadlo_study_set_up
