# One interface target with the flags of all our Fortran. Contraction and automatic vectorisation change the last
# digits (gfortran -O3 silently takes libmvec's 3.4-ulp sine), so both are off except in declared batch kernels.
add_library(kyvadlo_flags INTERFACE)
target_compile_options(kyvadlo_flags INTERFACE
  $<$<COMPILE_LANG_AND_ID:Fortran,GNU>:-std=f2018 -Wall -Wextra -Wimplicit-interface
    -Wno-maybe-uninitialized -Wno-compare-reals -ffp-contract=off -fno-tree-vectorize>
  $<$<COMPILE_LANG_AND_ID:C,GNU>:-Wall -Wextra -ffp-contract=off>)
