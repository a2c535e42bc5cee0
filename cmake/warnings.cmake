# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

add_library(taut_warnings INTERFACE)
# No -Wsign-conversion: Eigen counts with signed indices and the standard library does not.
target_compile_options(taut_warnings INTERFACE
    -Wall -Wextra -Wno-missing-field-initializers -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    -Wcast-qual -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
    $<$<BOOL:${TAUT_WARNINGS_AS_ERRORS}>:-Werror>)

# In sources that are compiled as one, a name of one hides that of another: only a build of each by itself shows it (preset debug, lint).
if(CMAKE_UNITY_BUILD)
    target_compile_options(taut_warnings INTERFACE -Wno-shadow)
endif()

# GCC 12 takes a text that is put before another for one that overlaps it (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(taut_warnings INTERFACE -Wno-restrict)
endif()

# Boost before 1.81 counts an enumeration down below its first value, which Clang 16 takes for an error.
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 16
    AND Boost_VERSION VERSION_LESS 1.81)
    target_compile_options(taut_warnings INTERFACE -Wno-enum-constexpr-conversion)
    # And Boost before 1.81 derives from what C++17 removed and libc++ no longer has unasked.
    target_compile_definitions(taut_warnings INTERFACE _LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION)
endif()
