!> Turning heights and gaps by this library, in three kinds, for `kyvadlo study`.
module kyvadlo_study_roots_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use kyvadlo_cubic_real32, only: cubic_roots
   use kyvadlo_orbit_real32, only: new_orbit_from_energy, orbit_type
#include "study_roots_ours.inc"
end module kyvadlo_study_roots_real32

module kyvadlo_study_roots_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_cubic_real64, only: cubic_roots
   use kyvadlo_orbit_real64, only: new_orbit_from_energy, orbit_type
#include "study_roots_ours.inc"
end module kyvadlo_study_roots_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_study_roots_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128
   use kyvadlo_cubic_real128, only: cubic_roots
   use kyvadlo_orbit_real128, only: new_orbit_from_energy, orbit_type
#include "study_roots_ours.inc"
end module kyvadlo_study_roots_real128
#endif

module kyvadlo_study_roots_ours
   use kyvadlo_study_roots_real32
   use kyvadlo_study_roots_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_study_roots_real128
#endif
   implicit none
   public
end module kyvadlo_study_roots_ours
