# Compiles the libraries with -fsanitize=thread in a folder of their own and runs many_threads there.
#
#   cmake -DSOURCE=<top of the tree> -DWORK=<scratch folder> -DGENERATOR=<...> -P thread_sanitizer.cmake
set(flags "-fsanitize=thread -O1 -g")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=None
  "-DCMAKE_Fortran_FLAGS=${flags}" "-DCMAKE_C_FLAGS=${flags}" -DKYVADLO_BUILD_TESTS=ON -DKYVADLO_WITH_GSL=OFF
  -DKYVADLO_WITH_OPENMP=OFF -DKYVADLO_WITH_NETCDF=OFF COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK} --target many_threads --parallel ${cores}
  COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
execute_process(COMMAND ${WORK}/test/threads/many_threads COMMAND_ERROR_IS_FATAL ANY)
