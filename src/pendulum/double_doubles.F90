!> The arithmetic in pairs for the double-double motion: a copy of `kyvadlo_two_part` that is compiled in one unit with
!> its set-up (`src/unit_double_double.F90`).
module kyvadlo_double_doubles
   use, intrinsic :: iso_fortran_env, only: pk => real64
#include "../arithmetic/two_part.inc"
end module kyvadlo_double_doubles
