# The flags of all our sources, as one interface target. Contraction and automatic vectorisation change the last digits
# (gfortran -O3 silently takes libmvec's 3.4-ulp sine), so both are off except in declared batch kernels.
set(kyvadlo_fortran_flags -std=f2018 -Wall -Wextra -Wimplicit-interface -Wno-maybe-uninitialized -Wno-compare-reals
  -ffp-contract=off -fno-tree-vectorize -fno-semantic-interposition)
set(kyvadlo_c_flags -Wall -Wextra -ffp-contract=off -fno-tree-vectorize -fno-semantic-interposition)

add_library(kyvadlo_flags INTERFACE)
target_compile_options(kyvadlo_flags INTERFACE
  $<$<COMPILE_LANG_AND_ID:Fortran,GNU>:${kyvadlo_fortran_flags}>
  $<$<COMPILE_LANG_AND_ID:C,GNU>:${kyvadlo_c_flags}>)

# kyvadlo_batch_kernel(source flag...)
#
# Declares a source (relative to the calling folder of src) a batch kernel: a loop over many points whose error bound was
# measured with vector instructions, and is tested against that bound. The flags come after those above and win:
#
#   kyvadlo_batch_kernel(positions_kernel.F90 -O3 -ftree-vectorize -finline-limit=2000)
function(kyvadlo_batch_kernel source)
  if(NOT ARGN)
    message(FATAL_ERROR "kyvadlo_batch_kernel(${source}): name the flags")
  endif()
  cmake_path(ABSOLUTE_PATH source)
  # The library targets are created in src, the program in src/driver: the property must be seen there.
  set_source_files_properties(${source} DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src
    PROPERTIES COMPILE_OPTIONS "${ARGN}")
endfunction()

# kyvadlo_fortran_target(target): our flags, and a folder of its own for the target's module files, which whoever links
# the target in this build also searches.
function(kyvadlo_fortran_target target)
  set(modules ${PROJECT_BINARY_DIR}/modules/${target})
  set_target_properties(${target} PROPERTIES Fortran_MODULE_DIRECTORY ${modules} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${modules}>)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:kyvadlo_flags>)
endfunction()
