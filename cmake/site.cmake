# The target site: the pages, the API and a pendulum to start by mouse as static HTML, in site/ of the build folder. FORD 6 carries
# its style with it; later ones load it from the network.
#
#   pip install ford==6.2.5 latex2mathml
find_program(KYVADLO_FORD ford)
mark_as_advanced(KYVADLO_FORD)
# The first Python that has latex2mathml: that of CMake, of the shell, or beside FORD.
find_package(Python3 COMPONENTS Interpreter QUIET)
cmake_path(GET KYVADLO_FORD PARENT_PATH folder)
set(kyvadlo_site_python "")
foreach(python IN ITEMS ${Python3_EXECUTABLE} python3 ${folder}/python3)
  execute_process(COMMAND ${python} -c "import latex2mathml" RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if(status EQUAL 0)
    set(kyvadlo_site_python ${python})
    break()
  endif()
endforeach()
if(KYVADLO_FORD AND kyvadlo_site_python)
  set(kyvadlo_make_site ${kyvadlo_site_python} ${PROJECT_SOURCE_DIR}/doc/site/make_site.py --top ${PROJECT_SOURCE_DIR}
    --build ${PROJECT_BINARY_DIR} --ford ${KYVADLO_FORD} --program $<TARGET_FILE:kyvadlo_driver> --version ${PROJECT_VERSION})
  add_custom_target(site COMMAND ${kyvadlo_make_site} COMMENT "Writing the site" VERBATIM)
  add_dependencies(site kyvadlo_driver)
else()
  add_custom_target(site COMMAND ${CMAKE_COMMAND} -E echo "The site takes FORD and latex2mathml: pip install ford==6.2.5 latex2mathml"
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()
