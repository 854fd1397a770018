# cmake --install: libraries, program, module files, package files, licence.
include(CMakePackageConfigHelpers)

# All that is installed, for install_all_or_nothing.cmake and `./bootstrap table`.
add_custom_target(kyvadlo_to_install)
foreach(target kyvadlo_elliptic kyvadlo_core kyvadlo_c kyvadlo kyvadlo_slatec kyvadlo_driver kyvadlo_data kyvadlo_pages)
  if(TARGET ${target})
    add_dependencies(kyvadlo_to_install ${target})
  endif()
endforeach()

# Module files can be read by the compiler that wrote them only, so they lie in a folder named after it.
set(KYVADLO_MODDIR ${CMAKE_INSTALL_INCLUDEDIR}/kyvadlo/${CMAKE_Fortran_COMPILER_ID}-${CMAKE_Fortran_COMPILER_VERSION}
  CACHE STRING "Folder of the installed .mod files, relative to the prefix")
# Where a shared library lies, as the loader says it.
set(origin "$ORIGIN")
if(APPLE)
  set(origin "@loader_path")
endif()
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/kyvadlo)

set(installed_targets kyvadlo_elliptic kyvadlo_core kyvadlo_c kyvadlo)
foreach(target IN LISTS installed_targets)
  set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${KYVADLO_MODDIR}>)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/modules/${target}/ DESTINATION ${KYVADLO_MODDIR} FILES_MATCHING PATTERN "*.mod")
endforeach()
if(TARGET kyvadlo_gsl AND CMAKE_Fortran_COMPILER_ID STREQUAL "LLVMFlang")   # which reads all that its modules use
  install(DIRECTORY ${PROJECT_BINARY_DIR}/modules/kyvadlo_gsl/ DESTINATION ${KYVADLO_MODDIR} FILES_MATCHING PATTERN "*.mod")
endif()
# Shared libraries show our names only, and nothing of what they are made of.
if(BUILD_SHARED_LIBS AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
  set(names ${PROJECT_SOURCE_DIR}/cmake/public_names.ld)
  foreach(target IN LISTS installed_targets ITEMS kyvadlo_slatec)
    if(TARGET ${target})
      target_link_options(${target} PRIVATE LINKER:--version-script=${names})
      set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${names})
    endif()
  endforeach()
endif()
target_include_directories(kyvadlo_c INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
install(TARGETS ${installed_targets} EXPORT kyvadlo_targets)
# Where the loader looks for our shared libraries is the same in the build tree as installed: CMake would else keep room for
# the installed path by colons, and an empty element means the current folder, whoever owns it.
file(RELATIVE_PATH libraries_from_program ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
foreach(target IN LISTS installed_targets ITEMS kyvadlo_slatec kyvadlo_driver kyvadlo_data)
  if(TARGET ${target})
    set_target_properties(${target} PROPERTIES BUILD_WITH_INSTALL_RPATH ON)
    if(BUILD_SHARED_LIBS)
      set_target_properties(${target} PROPERTIES INSTALL_RPATH "${origin}"
        LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin/${libraries_from_program})
    endif()
  endif()
endforeach()
if(TARGET kyvadlo_driver)
  if(BUILD_SHARED_LIBS)
    set_target_properties(kyvadlo_driver PROPERTIES INSTALL_RPATH "${origin}/${libraries_from_program}")
  endif()
  install(TARGETS kyvadlo_driver)
  if(TARGET kyvadlo_data)
    if(BUILD_SHARED_LIBS)
      file(RELATIVE_PATH libraries_from_data ${CMAKE_INSTALL_FULL_LIBEXECDIR}/kyvadlo ${CMAKE_INSTALL_FULL_LIBDIR})
      set_target_properties(kyvadlo_data PROPERTIES INSTALL_RPATH "${origin}/${libraries_from_data}")
    endif()
    install(TARGETS kyvadlo_data DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/kyvadlo)
  endif()
endif()

install(EXPORT kyvadlo_targets NAMESPACE kyvadlo:: DESTINATION ${package_dir})
# What the static libraries need of Fortran's run-time libraries.
set(kyvadlo_runtime ${CMAKE_Fortran_IMPLICIT_LINK_LIBRARIES})
list(FILTER kyvadlo_runtime INCLUDE REGEX "^(gfortran|quadmath|m)$")
list(REMOVE_DUPLICATES kyvadlo_runtime)
configure_package_config_file(cmake/kyvadlo-config.cmake.in ${PROJECT_BINARY_DIR}/kyvadlo-config.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/kyvadlo-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/kyvadlo-config.cmake ${PROJECT_BINARY_DIR}/kyvadlo-config-version.cmake
  DESTINATION ${package_dir})

# pkg-config: kyvadlo for everything, kyvadlo_core for the exact motion and the elliptic functions, kyvadlo_c for those from C
# and Fortran 77; the latter two without GSL. Paths are relative to the .pc file, so that
# the tree may be moved; what only the static libraries need is private: GSL, and for callers in C the run-time libraries of
# Fortran.
file(RELATIVE_PATH pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
set(pc_libs_private ${kyvadlo_runtime})
if(KYVADLO_WITH_OPENMP AND OpenMP_Fortran_FOUND)
  list(APPEND pc_libs_private ${OpenMP_Fortran_LIB_NAMES})
endif()
list(TRANSFORM pc_libs_private PREPEND "-l")
list(JOIN pc_libs_private " " pc_libs_private)
set(pc_gsl "")
if(KYVADLO_WITH_GSL)
  set(pc_gsl "gsl lapack")
endif()
function(kyvadlo_pkg_config pc_name pc_libs pc_requires_private)
  configure_file(cmake/kyvadlo.pc.in ${PROJECT_BINARY_DIR}/${pc_name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${pc_name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()
kyvadlo_pkg_config(kyvadlo "-lkyvadlo -lkyvadlo_c -lkyvadlo_core -lkyvadlo_elliptic" "${pc_gsl}")
kyvadlo_pkg_config(kyvadlo_core "-lkyvadlo_core -lkyvadlo_elliptic" "")
kyvadlo_pkg_config(kyvadlo_c "-lkyvadlo_c -lkyvadlo_core -lkyvadlo_elliptic" "")
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
