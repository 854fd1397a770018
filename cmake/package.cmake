# cpack: a Debian package of what `cmake --install` installs. Its version is the project's, its dependencies are read from the
# program and the shared libraries where dpkg-shlibdeps and file are installed.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME kyvadlo)
set(CPACK_PACKAGE_CONTACT "The kyvadlo maintainers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION_FILE ${PROJECT_SOURCE_DIR}/cmake/package_description.txt)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES OFF)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gfortran, pkg-config")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "gnuplot-nox")
if(KYVADLO_WITH_GSL AND NOT BUILD_SHARED_LIBS)
  # Who links the static libraries links GSL too.
  string(APPEND CPACK_DEBIAN_PACKAGE_RECOMMENDS ", libgsl-dev, liblapack-dev")
endif()
find_program(KYVADLO_SHLIBDEPS dpkg-shlibdeps)
find_program(KYVADLO_FILE file)   # CPack calls it before
mark_as_advanced(KYVADLO_SHLIBDEPS KYVADLO_FILE)
if(KYVADLO_SHLIBDEPS AND KYVADLO_FILE)
  set(kyvadlo_package_dependencies ON)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  # The shared libraries of this very package.
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src)
endif()
include(CPack)
