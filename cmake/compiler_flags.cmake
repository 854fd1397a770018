# CMake 3.25 does not know how flang hands options to the linker.
if(CMAKE_Fortran_COMPILER_ID STREQUAL "LLVMFlang" AND NOT CMAKE_Fortran_LINKER_WRAPPER_FLAG)
  set(CMAKE_Fortran_LINKER_WRAPPER_FLAG "-Wl,")
  set(CMAKE_Fortran_LINKER_WRAPPER_FLAG_SEP ",")
endif()

# The flags of all our sources, as one interface target. Contraction and automatic vectorisation change the last digits
# (gfortran -O3 silently takes libmvec's 3.4-ulp sine), so both are off except in declared batch kernels.
set(kyvadlo_flags_GNU -ffp-contract=off -fno-tree-vectorize -fno-semantic-interposition)
set(kyvadlo_flags_LLVMFlang -ffp-contract=off)
set(kyvadlo_flags_Clang -ffp-contract=off)
set(kyvadlo_flags_AppleClang -ffp-contract=off)
set(kyvadlo_flags_IntelLLVM -fp-model=precise -ffp-contract=off)
set(kyvadlo_flags_NVHPC -Mnofma -Kieee)
set(kyvadlo_fortran_flags ${kyvadlo_flags_${CMAKE_Fortran_COMPILER_ID}} ${kyvadlo_processor_flags})
set(kyvadlo_c_flags ${kyvadlo_flags_${CMAKE_C_COMPILER_ID}} ${kyvadlo_processor_flags})
if(CMAKE_Fortran_COMPILER_ID STREQUAL "GNU")
  list(PREPEND kyvadlo_fortran_flags -std=f2018 -Wall -Wextra -Wimplicit-interface -Wno-maybe-uninitialized -Wno-compare-reals)
  # gfortran 14 says it of every local variable of a type with allocatable components, whose descriptor it copies.
  if(CMAKE_Fortran_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
    list(APPEND kyvadlo_fortran_flags -Wno-uninitialized)
  endif()
elseif(NOT kyvadlo_flags_${CMAKE_Fortran_COMPILER_ID})
  message(WARNING "kyvadlo does not know how to switch contraction (fused multiply-add) off in ${CMAKE_Fortran_COMPILER_ID}: "
    "see cmake/compiler_flags.cmake, and believe the tests only")
endif()
if(CMAKE_C_COMPILER_ID STREQUAL "GNU")
  list(PREPEND kyvadlo_c_flags -Wall -Wextra)
endif()

add_library(kyvadlo_flags INTERFACE)
target_compile_options(kyvadlo_flags INTERFACE
  $<$<COMPILE_LANGUAGE:Fortran>:${kyvadlo_fortran_flags}>
  $<$<COMPILE_LANGUAGE:C>:${kyvadlo_c_flags}>)
target_compile_definitions(kyvadlo_flags INTERFACE
  $<$<NOT:$<BOOL:${KYVADLO_WITH_REAL128}>>:KYVADLO_NO_REAL128>)
# The C parts watch their stack and their buffers; addresses are bound when a program starts and cannot be written after that.
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  target_compile_options(kyvadlo_flags INTERFACE $<$<COMPILE_LANGUAGE:C>:-fstack-protector-strong>
    $<$<AND:$<COMPILE_LANGUAGE:C>,$<NOT:$<CONFIG:Debug>>>:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>)
  target_link_options(kyvadlo_flags INTERFACE LINKER:-z,relro LINKER:-z,now)
endif()

# kyvadlo_batch_kernel(source flag...)
#
# Declares a source (relative to the calling folder of src) a batch kernel: a loop over many points whose error bound was
# measured with vector instructions, and is tested against that bound. The flags come after those above and win:
#
#   kyvadlo_batch_kernel(positions_kernel.F90 -O3 -ftree-vectorize -finline-limit=2000)
#
# Builds whose speed is of no matter (those that only try an installation, the sanitizers) set KYVADLO_KERNEL_OPTIMISATION
# to -O0 or -O1, which comes last: kernels take a third of the time of a build.
function(kyvadlo_batch_kernel source)
  if(NOT ARGN)
    message(FATAL_ERROR "kyvadlo_batch_kernel(${source}): name the flags")
  endif()
  cmake_path(ABSOLUTE_PATH source)
  # The library targets are created in src, the program in src/driver: the property must be seen there.
  set_source_files_properties(${source} DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src
    PROPERTIES COMPILE_OPTIONS "${ARGN};${KYVADLO_KERNEL_OPTIMISATION}")
endfunction()

# kyvadlo_fortran_target(target): our flags, and a folder of its own for the target's module files, which whoever links
# the target in this build also searches.
function(kyvadlo_fortran_target target)
  set(modules ${PROJECT_BINARY_DIR}/modules/${target})
  set_target_properties(${target} PROPERTIES Fortran_MODULE_DIRECTORY ${modules} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${modules}>)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:kyvadlo_flags>)
endfunction()
