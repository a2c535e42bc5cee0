# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# A project that adds taut as a subdirectory wants the library and nothing else.
find_package(benchmark QUIET)
set(TAUT_WITH_BENCHMARKS OFF)
if(PROJECT_IS_TOP_LEVEL AND benchmark_FOUND)
    set(TAUT_WITH_BENCHMARKS ON)
endif()

option(TAUT_BUILD_APP "Build the command line program" ${PROJECT_IS_TOP_LEVEL})
option(TAUT_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(TAUT_BUILD_EXAMPLES "Build the examples" ${PROJECT_IS_TOP_LEVEL})
option(TAUT_BUILD_BENCHMARKS "Build the benchmarks (default: where Google Benchmark is found)" ${TAUT_WITH_BENCHMARKS})
option(TAUT_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)
