# add_pfunit_ctest for machines without pFUnit: same arguments, same .pf files.
add_executable(pf2f90 ${CMAKE_CURRENT_LIST_DIR}/pf2f90.f90)
add_library(funit STATIC ${CMAKE_CURRENT_LIST_DIR}/funit.f90)
set_target_properties(funit PROPERTIES Fortran_MODULE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/funit)
target_include_directories(funit PUBLIC ${CMAKE_CURRENT_BINARY_DIR}/funit)
target_compile_options(funit PRIVATE -Wno-maybe-uninitialized)

function(add_pfunit_ctest name)
  cmake_parse_arguments(T "" "WORKING_DIRECTORY" "TEST_SOURCES;OTHER_SOURCES;LINK_LIBRARIES;LABELS" ${ARGN})
  foreach(pf IN LISTS T_TEST_SOURCES)
    cmake_path(GET pf STEM suite)
    cmake_path(ABSOLUTE_PATH pf)
    set(f90 ${CMAKE_CURRENT_BINARY_DIR}/${suite}.F90)
    add_custom_command(OUTPUT ${f90} COMMAND pf2f90 ${pf} ${f90} DEPENDS ${pf} pf2f90 VERBATIM)
    list(APPEND sources ${f90})
    string(APPEND calls "  call ${suite}_suite()\n")
  endforeach()
  file(CONFIGURE OUTPUT ${name}_driver.f90 CONTENT "module ${name}_suites
  implicit none (type)
contains
  subroutine suites()
${calls}  end subroutine
end module
program ${name}_driver
  use funit, only: run_suites
  use ${name}_suites, only: suites
  implicit none (type)
  call run_suites(suites)
end program
")
  add_executable(${name} ${CMAKE_CURRENT_BINARY_DIR}/${name}_driver.f90 ${sources} ${T_OTHER_SOURCES})
  set_target_properties(${name} PROPERTIES Fortran_MODULE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/mod/${name})
  target_link_libraries(${name} PRIVATE funit ${T_LINK_LIBRARIES})
  if(NOT T_WORKING_DIRECTORY)
    set(T_WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  endif()
  add_test(NAME ${name} COMMAND ${name} --verbose WORKING_DIRECTORY ${T_WORKING_DIRECTORY})
  set_tests_properties(${name} PROPERTIES LABELS "${T_LABELS}")
endfunction()
