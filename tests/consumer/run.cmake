# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# Installs taut into a fresh prefix, then configures, builds and runs the consumer against it: as taut
# was built, with flags that change how Eigen and the standard library lay out memory, and by
# pkg-config.
set(prefix ${CONSUMER_BINARY_DIR}/prefix)
file(REMOVE_RECURSE ${CONSUMER_BINARY_DIR})

function(run)
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(configure build flags)
    run(${CMAKE_COMMAND} -S ${CONSUMER_SOURCE_DIR} -B ${build} -G ${GENERATOR}
        -DCMAKE_PREFIX_PATH=${prefix}
        -DCMAKE_BUILD_TYPE=${CONFIG}
        -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
        "-DCMAKE_CXX_FLAGS=${CXX_FLAGS} ${flags}"
        -DTAUT_EXPECTED_VERSION=${VERSION})
endfunction()

function(build_and_run name flags)
    message(STATUS "consumer built with '${flags}'")
    set(build ${CONSUMER_BINARY_DIR}/${name})
    configure(${build} "${flags}")
    run(${CMAKE_COMMAND} --build ${build} --config ${CONFIG})
    run(${build}/consumer ${VERSION})
endfunction()

run(${CMAKE_COMMAND} --install ${TAUT_BINARY_DIR} --prefix ${prefix} --config ${CONFIG})
build_and_run(plain "")
if(NOT CXX_FLAGS MATCHES "-fsanitize")  # a library with sanitizers needs a consumer with the same
    build_and_run(native "-march=native")
    build_and_run(avx2 "-mavx2 -mfma")
    build_and_run(asan "-fsanitize=address")

    # A std::vector with checks is another one: that must not link, and the message tell why.
    set(build ${CONSUMER_BINARY_DIR}/debug_containers)
    configure(${build} "-D_GLIBCXX_DEBUG")
    execute_process(COMMAND ${CMAKE_COMMAND} --build ${build} --config ${CONFIG}
        RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(NOT failed OR NOT said MATCHES "compiled_for_libstdcxx_debug_eigen")
        message(FATAL_ERROR "with -D_GLIBCXX_DEBUG expected a link that fails and says why, got:\n${said}")
    endif()
endif()
