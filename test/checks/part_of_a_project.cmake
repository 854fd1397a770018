# The two projects of doc/building.md that take kyvadlo in as a part: built as they stand there, without a build type, which must
# stay so; nothing of kyvadlo is installed with them, and no program of it is built.
#
#   cmake -DSOURCE=<top of the tree> -DWORK=<scratch folder> -DGENERATOR=<...> -P part_of_a_project.cmake
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/kyvadlo)
foreach(name CMakeLists.txt cmake src doc examples)
  file(CREATE_LINK ${SOURCE}/${name} ${WORK}/kyvadlo/${name} SYMBOLIC)
endforeach()
file(READ ${SOURCE}/doc/building.md page)
foreach(name part fetched)
  string(FIND "${page}" "`${name}/CMakeLists.txt`:\n\n```cmake\n" begin)
  if(begin EQUAL -1)
    message(FATAL_ERROR "doc/building.md shows no ${name}/CMakeLists.txt")
  endif()
  string(SUBSTRING "${page}" ${begin} -1 project)
  string(REGEX REPLACE "^[^\n]*\n\n```cmake\n" "" project "${project}")
  string(FIND "${project}" "```" end)
  string(SUBSTRING "${project}" 0 ${end} project)
  file(WRITE ${WORK}/kyvadlo/${name}/CMakeLists.txt "${project}
if(CMAKE_BUILD_TYPE OR DEFINED CACHE{BUILD_SHARED_LIBS} OR TARGET kyvadlo_driver)
  message(FATAL_ERROR \"the build type, the kind of libraries or the targets of the project were touched\")
endif()
install(TARGETS swing)
")
  set(build ${WORK}/${name})
  run(${CMAKE_COMMAND} -S ${WORK}/kyvadlo/${name} -B ${build} -G ${GENERATOR} -DKYVADLO_WITH_GSL=OFF -DKYVADLO_WITH_REAL128=OFF
    -DKYVADLO_KERNEL_OPTIMISATION=-O0 -DCMAKE_Fortran_FLAGS=-O0
    -DCMAKE_INSTALL_PREFIX=${WORK}/prefix)
  run(${CMAKE_COMMAND} --build ${build} --target swing)
  execute_process(COMMAND ${build}/swing OUTPUT_VARIABLE swing COMMAND_ERROR_IS_FATAL ANY)
  if(NOT swing MATCHES "next 1[.]108027 s")
    message(FATAL_ERROR "swing of ${name} prints ${swing}")
  endif()
  file(REMOVE_RECURSE ${WORK}/prefix)
  run(${CMAKE_COMMAND} --install ${build})
  file(GLOB_RECURSE installed RELATIVE ${WORK}/prefix ${WORK}/prefix/*)
  if(NOT installed STREQUAL "bin/swing")
    message(FATAL_ERROR "with ${name} were installed: ${installed}")
  endif()
endforeach()
