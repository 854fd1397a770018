!> One translation unit for the arithmetic in pairs of numbers and its callers: the compiler sees both and inlines. The
!> unit files lie outside the folders that fpm reads; fpm compiles each source by itself.
#include "arithmetic/numbers.F90"
#include "arithmetic/two_part.F90"
#include "arithmetic/exact_sign.F90"
#include "arithmetic/cubic.F90"
