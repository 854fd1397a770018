# Builds and tests the core by fpm in a copy of what it needs.
#
#   cmake -DSOURCE=<top of the tree> -DWORK=<scratch folder> -DFPM=<program> -P fpm.cmake
file(REMOVE_RECURSE ${WORK})
file(COPY ${SOURCE}/fpm.toml ${SOURCE}/fpm DESTINATION ${WORK})
file(COPY ${SOURCE}/src/kinds.f90 ${SOURCE}/src/release.f90 ${SOURCE}/src/status.f90 ${SOURCE}/src/kyvadlo.F90 ${SOURCE}/src/arithmetic ${SOURCE}/src/elliptic ${SOURCE}/src/pendulum
  DESTINATION ${WORK}/src)
# Built as doc/building.md says; tested with an instruction set that fuses products into sums, and no flag against it: the digits
# must hold all the same.
execute_process(COMMAND ${FPM} build --profile release --flag "-ffp-contract=off -fno-tree-vectorize"
  WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${FPM} test --flag "-O2 -march=native" WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
