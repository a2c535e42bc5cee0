# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# A project that adds taut as a subdirectory wants the library and nothing else.
find_package(benchmark QUIET)
set(TAUT_WITH_BENCHMARKS OFF)
if(PROJECT_IS_TOP_LEVEL AND benchmark_FOUND)
    set(TAUT_WITH_BENCHMARKS ON)
endif()

find_program(TAUT_NODE NAMES node nodejs DOC "Node.js, which bundles the viewer of reports")
find_program(TAUT_NPM npm DOC "npm, which installs the viewer's locked packages")
set(TAUT_WITH_VIEWER OFF)
if(TAUT_NODE AND TAUT_NPM)
    execute_process(COMMAND ${TAUT_NODE} --version OUTPUT_VARIABLE node_version OUTPUT_STRIP_TRAILING_WHITESPACE)
    string(REPLACE "v" "" node_version "${node_version}")
    if(node_version VERSION_GREATER_EQUAL 18)
        set(TAUT_WITH_VIEWER ${PROJECT_IS_TOP_LEVEL})
    endif()
endif()

option(TAUT_INSTALL "Install the library, and the program where it is built" ${PROJECT_IS_TOP_LEVEL})
option(TAUT_BUILD_APP "Build the command line program" ${PROJECT_IS_TOP_LEVEL})
option(TAUT_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(TAUT_TESTS_BY_PROGRAM "Give ctest the tests of a room as one test: with the sanitizers most of the time goes into starting processes" OFF)
option(TAUT_BUILD_EXAMPLES "Build the examples" ${PROJECT_IS_TOP_LEVEL})
option(TAUT_BUILD_BENCHMARKS "Build the benchmarks (default: where Google Benchmark is found)" ${TAUT_WITH_BENCHMARKS})
set(TAUT_CLARABEL_DEFAULT OFF)
if(PROJECT_IS_TOP_LEVEL)
    set(TAUT_CLARABEL_DEFAULT AUTO)
endif()
set(TAUT_WITH_CLARABEL ${TAUT_CLARABEL_DEFAULT} CACHE STRING
    "Build the conic solver for the paper's SOCP: ON, OFF, or AUTO (where cargo is recent enough)")
option(TAUT_BUILD_FUZZERS "Build the fuzzers of the readers (needs Clang)" OFF)
option(TAUT_BUILD_VIEWER "Build the viewer of reports into the library (default: where Node.js and npm are found)" ${TAUT_WITH_VIEWER})
if(PROJECT_IS_TOP_LEVEL AND NOT TAUT_BUILD_VIEWER)
    message(WARNING "Reports are left out of this build: they take Node.js 18 or later and npm, or TAUT_BUILD_VIEWER is off")
endif()
option(TAUT_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)
