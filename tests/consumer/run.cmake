# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# Builds a user's project. KIND static: against the libraries of TAUT_BINARY_DIR, installed, with the
# compiler that built them. KIND flags: with every compiler of COMPILERS, and with flags that change how
# Eigen and the standard library lay out memory. KIND shared: taut as a part of the consumer's project,
# with shared libraries, each source by itself, so that it must include what it uses; then these, installed.
set(prefix ${CONSUMER_BINARY_DIR}/prefix)
file(REMOVE_RECURSE ${CONSUMER_BINARY_DIR})

# Input files of the programs in the documentation.
set(example ${CONSUMER_BINARY_DIR}/example)
file(COPY ${TAUT_SOURCE_DIR}/tests/data/released/0.1.0/net.json
    ${TAUT_SOURCE_DIR}/tests/data/released/0.1.0/survey.csv DESTINATION ${example})

function(run)
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(configure build compiler flags)
    run(${CMAKE_COMMAND} -S ${CONSUMER_SOURCE_DIR} -B ${build} -G ${GENERATOR} --log-level=WARNING
        -DCMAKE_PREFIX_PATH=${prefix}
        -DCMAKE_CXX_COMPILER=${compiler}
        "-DCMAKE_CXX_FLAGS=${CXX_FLAGS} ${flags}"
        -DREADME=${TAUT_SOURCE_DIR}/README.md
        -DTAUT_EXPECTED_VERSION=${VERSION}
        ${ARGN})
endfunction()

# Libraries that a program loads, and symbols that a plugin with taut exports.
function(check_loaded build)
    execute_process(COMMAND ldd ${build}/consumer_core OUTPUT_VARIABLE loaded COMMAND_ERROR_IS_FATAL ANY)
    if(loaded MATCHES "hdf5|curl|krb5|ldap|pugixml|clarabel|taut_(adjustment|io|report)")
        message(FATAL_ERROR "with taut::core alone this is loaded:\n${loaded}")
    endif()
    if(KIND STREQUAL "shared")
        return()
    endif()
    execute_process(COMMAND nm -D --defined-only -C ${build}/plugin.so
        OUTPUT_VARIABLE shown COMMAND_ERROR_IS_FATAL ANY)
    if(NOT shown MATCHES "plugin_iterations" OR shown MATCHES "taut|clarabel|rust")
        message(FATAL_ERROR "a plugin shows what it is made of:\n${shown}")
    endif()
endfunction()

function(build_and_run name compiler flags)
    cmake_path(GET compiler FILENAME compiler_name)
    message(STATUS "consumer: ${name}, ${compiler_name} ${flags}")
    set(build ${CONSUMER_BINARY_DIR}/${name}_${compiler_name})
    configure(${build} ${compiler} "${flags}" ${ARGN})
    run(${CMAKE_COMMAND} --build ${build})
    run(${build}/consumer ${VERSION})
    run(${build}/consumer_core)
    run(${CMAKE_COMMAND} -E chdir ${example} ${build}/shown_in_README)
    run(${CMAKE_COMMAND} -E chdir ${example} ${build}/shown_in_linking)
    if(NOT flags AND NOT CXX_FLAGS)
        check_loaded(${build})
    endif()
endfunction()

# The compiler commands of docs/linking.md, on the programs that it shows.
function(run_shown_commands)
    file(READ ${TAUT_SOURCE_DIR}/docs/linking.md text)
    foreach(language cpp c)
        string(REGEX MATCH "```${language}\n([^`]*)```" snippet "${text}")
        file(CONFIGURE OUTPUT ${example}/program.${language} CONTENT "${CMAKE_MATCH_1}" @ONLY)
        string(REGEX MATCH "```sh\n([^`]* program\\.${language} [^`]*)```(.*)" snippet "${text}")
        string(REPLACE "PREFIX" ${prefix} command "${CMAKE_MATCH_1}")
        run(${CMAKE_COMMAND} -E chdir ${example} bash -euo pipefail -c "${command}./program")
    endforeach()
endfunction()

if(KIND STREQUAL "shared")
    list(GET COMPILERS -1 compiler)  # the other one than that of the tests, where there are two
    build_and_run(subproject ${compiler} ""
        -DTAUT_SOURCE_DIR=${TAUT_SOURCE_DIR}
        -DTAUT_INSTALL=ON -DBUILD_SHARED_LIBS=ON)
    cmake_path(GET compiler FILENAME compiler_name)
    set(build ${CONSUMER_BINARY_DIR}/subproject_${compiler_name})
    file(STRINGS ${build}/CMakeCache.txt cached REGEX "^CMAKE_BUILD_TYPE:[A-Z]+=.+")
    if(cached)
        message(FATAL_ERROR "a part of the project set what is the whole's: ${cached}")
    endif()
    run(${CMAKE_COMMAND} --install ${build} --prefix ${prefix})
    foreach(compiler ${COMPILERS})
        build_and_run(shared ${compiler} "")
    endforeach()
    return()
endif()

run(${CMAKE_COMMAND} --install ${TAUT_BINARY_DIR} --prefix ${prefix} --config ${CONFIG})
if(NOT CXX_FLAGS)
    run_shown_commands()
endif()
list(GET COMPILERS 0 own_compiler)
if(KIND STREQUAL "static")
    build_and_run(plain ${own_compiler} "")
    return()
endif()
foreach(compiler ${COMPILERS})
    if(compiler STREQUAL own_compiler)
        build_and_run(native ${compiler} "-march=native")
        build_and_run(asan ${compiler} "-fsanitize=address")
    else()
        build_and_run(plain ${compiler} "")
        build_and_run(avx2 ${compiler} "-mavx2 -mfma")
    endif()

    # A std::vector with checks has another layout: it must not link, with a message that says why.
    cmake_path(GET compiler FILENAME compiler_name)
    set(build ${CONSUMER_BINARY_DIR}/debug_containers_${compiler_name})
    configure(${build} ${compiler} "-D_GLIBCXX_DEBUG")
    execute_process(COMMAND ${CMAKE_COMMAND} --build ${build} --target consumer
        RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(NOT failed OR NOT said MATCHES "compiled_for_libstdcxx_debug_eigen")
        message(FATAL_ERROR "with -D_GLIBCXX_DEBUG expected a link that fails and says why, got:\n${said}")
    endif()
endforeach()
