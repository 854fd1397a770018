# What this compiler can do, and what it must not be told: found out at configure, said in one sentence.
include(CheckSourceCompiles)
include(CheckCCompilerFlag)

# Flags that turn (x + big) - big into x: motionless orbits, in silence.
string(TOUPPER "${CMAKE_BUILD_TYPE}" configuration)
foreach(language Fortran C)
  set(given " ${CMAKE_${language}_FLAGS} ${CMAKE_${language}_FLAGS_${configuration}} ")
  if(given MATCHES " (-Ofast|-ffast-math|-funsafe-math-optimizations|-fassociative-math|-freciprocal-math|-ffinite-math-only) ")
    message(FATAL_ERROR "kyvadlo cannot be compiled with ${CMAKE_MATCH_1} (in CMAKE_${language}_FLAGS, or FFLAGS, CFLAGS): its "
      "sums of two parts, (x + big) - big, would lose their digits in silence. Take the flag away; -O3 is as fast.")
  endif()
endforeach()

# The x87 unit keeps more digits than a number has and rounds them when it likes: on 32-bit x86 SSE must do the arithmetic.
check_source_compiles(C "#include <float.h>
#if FLT_EVAL_METHOD != 0
#error not every operation is rounded to its type
#endif
int main(void) { return 0; }" KYVADLO_ROUNDS_EVERY_OPERATION)
set(kyvadlo_processor_flags "")
if(NOT KYVADLO_ROUNDS_EVERY_OPERATION)
  check_c_compiler_flag("-msse2 -mfpmath=sse" KYVADLO_HAS_SSE)
  if(NOT KYVADLO_HAS_SSE)
    message(FATAL_ERROR "This compiler computes with more digits than its types have (FLT_EVAL_METHOD is not 0) and knows no "
      "-msse2 -mfpmath=sse: kyvadlo's digits would be garbage. Build for a processor that rounds every operation.")
  endif()
  message(STATUS "x87 arithmetic is replaced by SSE: -msse2 -mfpmath=sse")
  set(kyvadlo_processor_flags -msse2 -mfpmath=sse)
endif()

# Quadruple precision: a kind of 113 binary digits with all its functions. (On ppc64le the kind may have 106; flang 19 has the
# kind and cannot link its square root.)
check_source_compiles(Fortran "program quad
  use, intrinsic :: iso_fortran_env, only: real128
  implicit none
  real(kind=merge(real128, -1, digits(1.0_real128) == 113)) :: x
  real(real128), parameter :: pi = acos(-1.0_real128), root = sqrt(2.0_real128)
  read *, x
  print *, sqrt(x), log(x), exp(x), atan2(x, pi), x**root, sinh(x), hypot(x, root)
end program quad" KYVADLO_HAS_REAL128 SRC_EXT f90)
option(KYVADLO_WITH_REAL128 "Build everything in quadruple precision too" ${KYVADLO_HAS_REAL128})
if(KYVADLO_WITH_REAL128 AND NOT KYVADLO_HAS_REAL128)
  message(FATAL_ERROR "KYVADLO_WITH_REAL128 is ON, but ${CMAKE_Fortran_COMPILER_ID} ${CMAKE_Fortran_COMPILER_VERSION} has no real "
    "kind of 113 binary digits (or cannot link its functions). Say -DKYVADLO_WITH_REAL128=OFF, or take gfortran.")
elseif(NOT KYVADLO_WITH_REAL128)
  message(STATUS "no quadruple precision: --kind quad, `kyvadlo study` and kyvadlo-bench are left out")
endif()
