# What is installed is what was built, whichever command built it: where a file is missing (as behind
# `cmake --build build/release --target kyvadlo_driver`) it is built before the first one is installed.
set(files "")
foreach(target kyvadlo_elliptic kyvadlo_core kyvadlo_c kyvadlo kyvadlo_slatec kyvadlo_driver kyvadlo_data)
  list(APPEND files "\"$<$<TARGET_EXISTS:${target}>:$<TARGET_FILE:$<TARGET_NAME_IF_EXISTS:${target}>>>\"")
endforeach()
if(NOT CMAKE_CROSSCOMPILING)
  list(APPEND files ${PROJECT_BINARY_DIR}/share/kyvadlo.1)
endif()
list(JOIN files " " files)
install(CODE "
foreach(file IN ITEMS ${files})
  if(file AND NOT EXISTS \"\${file}\")
    execute_process(COMMAND \"${CMAKE_COMMAND}\" --build \"${PROJECT_BINARY_DIR}\" --target kyvadlo_to_install
      COMMAND_ERROR_IS_FATAL ANY)
    break()
  endif()
endforeach()")
