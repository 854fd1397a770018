!> The gaps of an orbit in three-part numbers, from a start in real64: the source of kyvadlo_gaps_real64.
module kyvadlo_gaps_double_double
   use, intrinsic :: iso_fortran_env, only: wp => real64, cp => real64
   use kyvadlo_numbers_real64, only: is_finite, is_nan
   use kyvadlo_status, only: error_type, fail, code_domain
   use kyvadlo_three_part
#define exact_input
#include "gaps.inc"
#include "gaps_energy.inc"
#include "gaps_state.inc"
end module kyvadlo_gaps_double_double
