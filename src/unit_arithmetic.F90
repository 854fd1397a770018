!> One translation unit for the arithmetic in pairs of numbers and its callers, and for Carlson's integrals: the
!> compiler sees all and inlines. The unit files lie outside the folders that fpm reads; fpm compiles each source by
!> itself.
#include "arithmetic/numbers.F90"
#include "arithmetic/two_part.F90"
#include "arithmetic/exact_sign.F90"
#include "arithmetic/cubic.F90"
#include "elliptic/carlson_rc.F90"
#include "elliptic/carlson_rf.F90"
#include "elliptic/carlson_rd.F90"
#include "elliptic/carlson_rj_positive.F90"
#include "elliptic/carlson_rj_principal.F90"
#include "elliptic/carlson_rj.F90"
