# Runs FORD and fails if it warns, or if the pages do not hold what they must.
#
#   cmake -DFORD=<program> -DPROJECT=<project file> -DOUTPUT=<folder of the pages> -P run_ford.cmake
cmake_path(GET OUTPUT PARENT_PATH folder)
execute_process(COMMAND ${FORD} ${PROJECT} WORKING_DIRECTORY ${folder} RESULT_VARIABLE status
  OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT status EQUAL 0 OR output MATCHES "[Ww]arning|[Ee]rror:|Traceback")
  message(FATAL_ERROR "${output}")
endif()
file(READ ${OUTPUT}/interface/carlson_rf.html page)
if(NOT page MATCHES "NaN")
  message(FATAL_ERROR "the page of carlson_rf does not show its docstring")
endif()
message(STATUS "the pages begin at ${OUTPUT}/index.html")
