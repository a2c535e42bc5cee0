# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# Installs taut into a fresh prefix, then configures, builds and runs the consumer against it.
set(prefix ${CONSUMER_BINARY_DIR}/prefix)
set(build ${CONSUMER_BINARY_DIR}/build)
file(REMOVE_RECURSE ${prefix} ${build})

function(run)
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} --install ${TAUT_BINARY_DIR} --prefix ${prefix} --config ${CONFIG})
run(${CMAKE_COMMAND} -S ${CONSUMER_SOURCE_DIR} -B ${build} -G ${GENERATOR}
    -DCMAKE_PREFIX_PATH=${prefix}
    -DCMAKE_BUILD_TYPE=${CONFIG}
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
    -DCMAKE_CXX_FLAGS=${CXX_FLAGS}
    -DTAUT_EXPECTED_VERSION=${VERSION})
run(${CMAKE_COMMAND} --build ${build} --config ${CONFIG})
run(${build}/consumer ${VERSION})
