# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# taut_add_tests(<room> <file>...) makes the program test_<room> and gives it to ctest as one test: a
# process takes 0.1 s, most of what a small test takes.
# Includes: public headers, private ones as "<room>/name.hpp", helpers as "support/name.hpp".
function(taut_add_tests room)
    if(NOT ARGN)
        return()
    endif()
    set(target test_${room})
    add_executable(${target} ${ARGN})
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
    target_compile_definitions(${target} PRIVATE TAUT_TEST_DATA_DIR="${PROJECT_SOURCE_DIR}/tests/data")
    target_link_libraries(${target} PRIVATE
        taut::taut taut_warnings
        GTest::gmock_main rapidcheck rapidcheck_gtest
        nlohmann_json::nlohmann_json ${TAUT_FMT}
        PkgConfig::TAUT_HDF5)
    # Tests are compiled far longer than they run: little optimisation, and what all of them read once.
    # With sanitizers none, which halves the time. The linker then takes what tests and libraries both
    # make of a template from the libraries, whose files it reads first, and not the slow code of the tests.
    set(optimisation -O1)
    if(CMAKE_CXX_FLAGS MATCHES "-fsanitize" AND NOT APPLE)
        set(optimisation -O0)
        get_property(libraries GLOBAL PROPERTY TAUT_LIBRARIES)
        list(TRANSFORM libraries REPLACE "(.+)" "$<TARGET_FILE:\\1>")
        target_link_options(${target} PRIVATE LINKER:--whole-archive ${libraries} LINKER:--no-whole-archive)
    endif()
    # Templates take most of a test's compilation, optimisation little: -O0 saves GCC 4 % of the time.
    target_compile_options(${target} PRIVATE ${optimisation}
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    if(NOT room STREQUAL "version")
        target_precompile_headers(${target} REUSE_FROM test_version)
    endif()
    add_test(NAME ${room} COMMAND ${target} --gtest_brief=1)
    set_tests_properties(${room} PROPERTIES TIMEOUT 5400 LABELS ${room} ENVIRONMENT "RC_PARAMS=seed=1")
endfunction()
