# Installs kyvadlo into an empty prefix, moves the prefix, and builds and runs test/consumer against it.
#
#   cmake -DSOURCE=<top of the tree> -DWORK=<scratch folder> -DGENERATOR=<...> -DFLAGS=<Fortran flags> -DC_FLAGS=<...>
#         -DBUILD=<built tree>                      the static or shared libraries of that tree, or
#         -DSHARED=ON -DWITH_GSL=<ON or OFF>        a build of its own, shared and not optimised
#         -DDPKG_DEB=<program> [-DSHLIBDEPS=<...>]  what the Debian package would install, unpacked  -P consumer.cmake
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
if(SHARED)
  set(BUILD ${WORK}/build)
  run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} -G ${GENERATOR} -DBUILD_SHARED_LIBS=ON -DKYVADLO_BUILD_TESTS=OFF
    -DKYVADLO_WITH_GSL=${WITH_GSL} -DCMAKE_BUILD_TYPE=None "-DCMAKE_Fortran_FLAGS=${FLAGS} -O0" "-DCMAKE_C_FLAGS=${C_FLAGS}")
  run(${CMAKE_COMMAND} --build ${BUILD})
endif()
if(DPKG_DEB)
  # Everything is built. With Makefiles cpack would have make look at the whole tree once more; said to be Ninja's, it does not.
  run(${CMAKE_CPACK_COMMAND} --config ${BUILD}/CPackConfig.cmake -G DEB -B ${WORK}/package -D CPACK_CMAKE_GENERATOR=Ninja)
  file(GLOB package ${WORK}/package/*.deb)
  run(${DPKG_DEB} --info ${package})
  execute_process(COMMAND ${DPKG_DEB} --field ${package} Depends OUTPUT_VARIABLE depends COMMAND_ERROR_IS_FATAL ANY)
  if(SHLIBDEPS AND NOT depends MATCHES "libc6.*libgfortran")
    message(FATAL_ERROR "the package does not name the libraries that the program needs: ${depends}")
  endif()
  run(${DPKG_DEB} --extract ${package} ${WORK}/unpacked)
  file(RENAME ${WORK}/unpacked/usr ${WORK}/prefix)
else()
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first)
  file(RENAME ${WORK}/first ${WORK}/prefix)
endif()
if(NOT EXISTS ${WORK}/prefix/share/doc/kyvadlo/LICENSE)
  message(FATAL_ERROR "the licence is not installed")
endif()

run(${CMAKE_COMMAND} -S ${SOURCE}/test/consumer -B ${WORK}/consumer -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${WORK}/prefix
  "-DCMAKE_Fortran_FLAGS=${FLAGS}" "-DCMAKE_C_FLAGS=${C_FLAGS}" "-DCMAKE_CXX_FLAGS=${C_FLAGS}")
run(${CMAKE_COMMAND} --build ${WORK}/consumer)
run(${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/consumer --output-on-failure --no-tests=error)

# And one that knows no Fortran.
run(${CMAKE_COMMAND} -S ${SOURCE}/test/consumer/without_fortran -B ${WORK}/without_fortran -G ${GENERATOR}
  -DCMAKE_PREFIX_PATH=${WORK}/prefix "-DCMAKE_C_FLAGS=${C_FLAGS}")
run(${CMAKE_COMMAND} --build ${WORK}/without_fortran)
run(${WORK}/without_fortran/orbit_c)

# The same through pkg-config, where it is installed: Fortran with the run-time libraries of its compiler, C without; the C
# compiler is told of the C library's mathematics only.
find_program(PKG_CONFIG pkg-config)
find_program(GFORTRAN gfortran)
find_program(CC NAMES cc gcc)
file(GLOB_RECURSE pc ${WORK}/prefix/*/kyvadlo.pc)
if(PKG_CONFIG AND GFORTRAN)
  cmake_path(GET pc PARENT_PATH pc_folder)
  cmake_path(GET pc_folder PARENT_PATH libraries)
  set(ENV{PKG_CONFIG_PATH} ${pc_folder})
  set(static --static)
  if(SHARED)
    set(static "")
  endif()
  execute_process(COMMAND ${PKG_CONFIG} --cflags --libs ${static} kyvadlo OUTPUT_VARIABLE found COMMAND_ERROR_IS_FATAL ANY
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  foreach(source test/consumer/with_everything.f90 test/consumer/legacy.f examples/fortran77/periods.f)
    separate_arguments(flags UNIX_COMMAND "${FLAGS} ${found}")
    run(${GFORTRAN} -o ${WORK}/by_pkg_config ${SOURCE}/${source} ${flags} -Wl,-rpath,${libraries})
    run(${WORK}/by_pkg_config)
  endforeach()
  if(CC)
    separate_arguments(flags UNIX_COMMAND "${C_FLAGS} ${found}")
    run(${CC} -o ${WORK}/by_pkg_config_c ${SOURCE}/examples/c/orbit.c ${flags} -lm -Wl,-rpath,${libraries})
    run(${WORK}/by_pkg_config_c)
  endif()
endif()

# The shared libraries show nothing but our names: modules, the F77 names, and of C what kyvadlo.h declares.
find_program(NM nm)
if(SHARED AND NM)
  file(READ ${SOURCE}/src/interfaces/kyvadlo.h header)
  foreach(name kyvadlo_elliptic kyvadlo_core kyvadlo_c kyvadlo kyvadlo_slatec)
    file(GLOB_RECURSE library ${WORK}/prefix/*/lib${name}.so)
    execute_process(COMMAND ${NM} -D --defined-only ${library} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL "[A-Za-z_0-9.$]+\n" symbols "${symbols}")
    set(strange "")
    set(count 0)
    foreach(symbol IN LISTS symbols)
      string(STRIP "${symbol}" symbol)
      math(EXPR count "${count} + 1")
      if(symbol MATCHES "^kyvadlo_")
        if(NOT header MATCHES "[ *]${symbol}\\(")
          list(APPEND strange ${symbol})
        endif()
      elseif(NOT symbol MATCHES "^(__kyvadlo_[a-z0-9_]+_MOD_.*|kyv[a-z]+_|dr[cfdj]_)$")
        list(APPEND strange ${symbol})
      endif()
    endforeach()
    if(strange OR count LESS 4)
      message(FATAL_ERROR "lib${name}.so shows ${count} symbols, and should not show: ${strange}")
    endif()
    list(TRANSFORM symbols STRIP)
    list(APPEND all_symbols ${symbols})
  endforeach()
endif()

# And all that kyvadlo.h declares is there.
if(SHARED AND NM)
  string(REGEX MATCHALL "[ *]kyvadlo_[a-z0-9_]+\\(" declared "${header}")
  list(LENGTH declared count)
  foreach(name IN LISTS declared)
    string(REGEX REPLACE "[ *(]" "" name "${name}")
    if(NOT name IN_LIST all_symbols)
      message(FATAL_ERROR "kyvadlo.h declares ${name}, which no library defines")
    endif()
  endforeach()
  if(count LESS 50)
    message(FATAL_ERROR "only ${count} functions found in kyvadlo.h")
  endif()
endif()

# A SONAME of the major version, and the link that a linker looks for.
find_program(READELF readelf)
if(SHARED AND READELF)
  file(STRINGS ${SOURCE}/CMakeLists.txt version REGEX "^project\\(kyvadlo VERSION ")
  string(REGEX REPLACE ".*VERSION ([0-9]+)[.]([0-9.]+).*" "\\1" major "${version}")
  foreach(name kyvadlo_elliptic kyvadlo_core kyvadlo_c kyvadlo kyvadlo_slatec)
    file(GLOB_RECURSE library ${WORK}/prefix/*/lib${name}.so)
    execute_process(COMMAND ${READELF} -d ${library} OUTPUT_VARIABLE dynamic COMMAND_ERROR_IS_FATAL ANY)
    if(NOT dynamic MATCHES "SONAME[^\n]*\\[lib${name}[.]so[.]${major}\\]")
      message(FATAL_ERROR "lib${name}.so has no SONAME lib${name}.so.${major}: ${dynamic}")
    endif()
  endforeach()
endif()

# Python reaches the shared library through ctypes.
find_program(PYTHON3 python3)
if(SHARED AND PYTHON3)
  file(GLOB_RECURSE library ${WORK}/prefix/*/libkyvadlo_c.so)
  run(${PYTHON3} ${SOURCE}/examples/python/orbit.py ${library} ${WORK}/orbit.svg)
  # The page of examples shows it. (The sign of what is rounded to 0 may differ.)
  file(READ ${WORK}/orbit.svg picture)
  file(READ ${SOURCE}/doc/pictures/orbit_from_python.svg shown)
  string(REPLACE "-0.0000" "0.0000" picture "${picture}")
  string(REPLACE "-0.0000" "0.0000" shown "${shown}")
  if(NOT picture STREQUAL shown)
    message(FATAL_ERROR "doc/pictures/orbit_from_python.svg is not what examples/python/orbit.py draws: ${WORK}/orbit.svg")
  endif()
endif()

# The program, its manual page and its completion.
run(${WORK}/prefix/bin/kyvadlo eval K 0.5)
foreach(file share/man/man1/kyvadlo.1 share/bash-completion/completions/kyvadlo include/kyvadlo.h)
  if(NOT EXISTS ${WORK}/prefix/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()

# The programs that the pages show.
if(PKG_CONFIG AND GFORTRAN AND CC)
  execute_process(COMMAND sh ${SOURCE}/test/checks/snippets.sh ${SOURCE} programs ${WORK}/prefix "${FLAGS}" "${C_FLAGS}" "${static}"
    COMMAND_ERROR_IS_FATAL ANY)
endif()
