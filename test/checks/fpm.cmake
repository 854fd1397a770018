# Builds and tests the core by fpm in a copy of what it needs.
#
#   cmake -DSOURCE=<top of the tree> -DWORK=<scratch folder> -DFPM=<program> -P fpm.cmake
file(REMOVE_RECURSE ${WORK})
file(COPY ${SOURCE}/fpm.toml ${SOURCE}/fpm DESTINATION ${WORK})
file(COPY ${SOURCE}/src/kinds.f90 ${SOURCE}/src/release.f90 ${SOURCE}/src/status.f90 ${SOURCE}/src/kyvadlo.F90 ${SOURCE}/src/arithmetic ${SOURCE}/src/elliptic ${SOURCE}/src/pendulum
  DESTINATION ${WORK}/src)
# With an instruction set that fuses products into sums, and no flag against it: the digits must hold all the same.
set(flags "-O2 -march=native")
foreach(command build test)
  execute_process(COMMAND ${FPM} ${command} --flag ${flags} WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
