# The target api_pages: pages of every public procedure and type, by FORD, in api/ of the build folder. Version 6 carries its
# style with it; later ones load it from the network.
#
#   pip install ford==6.2.5
find_program(KYVADLO_FORD ford)
mark_as_advanced(KYVADLO_FORD)
if(KYVADLO_FORD)
  configure_file(doc/ford.md.in ${PROJECT_BINARY_DIR}/ford.md @ONLY)
  set(kyvadlo_run_ford ${CMAKE_COMMAND} -DFORD=${KYVADLO_FORD} -DPROJECT=${PROJECT_BINARY_DIR}/ford.md
    -DOUTPUT=${PROJECT_BINARY_DIR}/api -P ${PROJECT_SOURCE_DIR}/cmake/run_ford.cmake)
  add_custom_target(api_pages COMMAND ${kyvadlo_run_ford} COMMENT "Writing the pages of the API" VERBATIM)
endif()
