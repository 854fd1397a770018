# add_pfunit_ctest for machines without pFUnit: the same arguments, the same .pf files, one executable and one ctest a call.
#
#   add_pfunit_ctest(name TEST_SOURCES a.pf b.pf [OTHER_SOURCES ...] [LINK_LIBRARIES ...] [WORKING_DIRECTORY dir] [LABELS ...])
add_executable(pf2f90 ${CMAKE_CURRENT_LIST_DIR}/pf2f90.f90)
target_link_libraries(pf2f90 PRIVATE kyvadlo_flags)
set_target_properties(pf2f90 PROPERTIES Fortran_MODULE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/pf2f90.modules)

add_library(funit STATIC)
target_sources(funit PRIVATE ${CMAKE_CURRENT_LIST_DIR}/funit.f90 ${CMAKE_CURRENT_LIST_DIR}/funit_record.f90
  ${CMAKE_CURRENT_LIST_DIR}/funit_values.F90)
set_target_properties(funit PROPERTIES Fortran_MODULE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/funit.modules)
target_include_directories(funit PUBLIC ${CMAKE_CURRENT_BINARY_DIR}/funit.modules)
target_link_libraries(funit PRIVATE kyvadlo_flags)
# gfortran reads elements of polymorphic arrays with the alignment of the widest type, which no processor minds.
target_compile_options(funit PRIVATE $<$<COMPILE_LANG_AND_ID:Fortran,GNU>:-fno-sanitize=alignment>)
if(CMAKE_Fortran_COMPILER_ID STREQUAL "LLVMFlang")
  add_library(wide_functions OBJECT ${CMAKE_CURRENT_LIST_DIR}/wide_functions.c)
  target_link_libraries(funit PUBLIC $<TARGET_OBJECTS:wide_functions> m)
endif()

function(add_pfunit_ctest name)
  cmake_parse_arguments(PARSE_ARGV 1 T "" "WORKING_DIRECTORY" "TEST_SOURCES;OTHER_SOURCES;LINK_LIBRARIES;LABELS")
  pfunit_standin_program(${name} TEST_SOURCES ${T_TEST_SOURCES} OTHER_SOURCES ${T_OTHER_SOURCES}
    LINK_LIBRARIES ${T_LINK_LIBRARIES})
  if(NOT T_WORKING_DIRECTORY)
    set(T_WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  endif()
  add_test(NAME ${name} COMMAND ${name} --verbose WORKING_DIRECTORY ${T_WORKING_DIRECTORY})
  set_tests_properties(${name} PROPERTIES LABELS "${T_LABELS}")
endfunction()

# The executable alone.
function(pfunit_standin_program name)
  cmake_parse_arguments(PARSE_ARGV 1 T "" "" "TEST_SOURCES;OTHER_SOURCES;LINK_LIBRARIES")
  set(declarations "")
  set(calls "")
  set(generated "")
  foreach(pf IN LISTS T_TEST_SOURCES)
    cmake_path(GET pf STEM suite)
    cmake_path(ABSOLUTE_PATH pf)
    set(f90 ${CMAKE_CURRENT_BINARY_DIR}/${suite}.F90)
    add_custom_command(OUTPUT ${f90} COMMAND pf2f90 ${pf} ${f90} DEPENDS ${pf} pf2f90 VERBATIM)
    list(APPEND generated ${f90})
    string(APPEND declarations "      subroutine ${suite}_suite()\n      end subroutine\n")
    string(APPEND calls "      call ${suite}_suite()\n")
  endforeach()
  file(CONFIGURE OUTPUT ${name}_driver.f90 CONTENT "module ${name}_suites
   implicit none (type, external)
   interface
${declarations}   end interface
contains
   subroutine suites()
${calls}   end subroutine
end module
program ${name}_driver
   use funit, only: run_suites
   use ${name}_suites, only: suites
   implicit none (type, external)
   call run_suites(suites)
end program
")
  add_executable(${name} ${CMAKE_CURRENT_BINARY_DIR}/${name}_driver.f90 ${generated} ${T_OTHER_SOURCES})
  set_target_properties(${name} PROPERTIES Fortran_MODULE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${name}.modules)
  target_link_libraries(${name} PRIVATE funit kyvadlo_flags ${T_LINK_LIBRARIES})
  # gfortran 12 takes the assignment to an unallocated array, `x = arguments(1, :)`, for the use of one.
  target_compile_options(${name} PRIVATE $<$<COMPILE_LANG_AND_ID:Fortran,GNU>:-Wno-uninitialized>)
endfunction()
