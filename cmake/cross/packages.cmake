# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Answers find_package() with what scripts/cross.sh has put into TAUT_CROSS_ROOT: those of the machine that
# compiles are for that machine. Set as CMAKE_PROJECT_TOP_LEVEL_INCLUDES. What has a package for CMake of its own
# there, NLopt and TBB, is found by that.

function(taut_provided target)
    if(NOT TARGET ${target})
        add_library(${target} INTERFACE IMPORTED GLOBAL)
        set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${TAUT_CROSS_ROOT}/include)
    endif()
endfunction()

macro(taut_provide_package method package)
    if("${package}" STREQUAL "Eigen3")
        taut_provided(Eigen3::Eigen)
        set(Eigen3_FOUND TRUE)
    elseif("${package}" STREQUAL "Boost")
        taut_provided(Boost::headers)
        file(STRINGS ${TAUT_CROSS_ROOT}/include/boost/version.hpp Boost_VERSION REGEX "define BOOST_VERSION ")
        string(REGEX REPLACE ".* ([0-9]+)([0-9][0-9][0-9])[0-9][0-9]$" "\\1.\\2" Boost_VERSION "${Boost_VERSION}")
        set(Boost_FOUND TRUE)
    elseif("${package}" STREQUAL "FastFloat")
        taut_provided(FastFloat::fast_float)
        set(FastFloat_FOUND TRUE)
    elseif("${package}" STREQUAL "fmt")
        taut_provided(fmt::fmt-header-only)
        set_target_properties(fmt::fmt-header-only PROPERTIES INTERFACE_COMPILE_DEFINITIONS FMT_HEADER_ONLY=1)
        set(fmt_FOUND TRUE)
    elseif("${package}" STREQUAL "nlohmann_json")
        taut_provided(nlohmann_json::nlohmann_json)
        set(nlohmann_json_FOUND TRUE)
    elseif("${package}" STREQUAL "CLI11")
        taut_provided(CLI11::CLI11)
        set(CLI11_FOUND TRUE)
    elseif("${package}" STREQUAL "pugixml")
        taut_provided(pugixml::pugixml)
        set_target_properties(pugixml::pugixml PROPERTIES INTERFACE_LINK_LIBRARIES ${TAUT_CROSS_ROOT}/lib/libpugixml.a)
        set(pugixml_FOUND TRUE)
    elseif("${package}" STREQUAL "TBB")
        find_package(Threads REQUIRED)  # for which its static package does not ask
    elseif("${package}" MATCHES "^(BLAS|LAPACK)$")
        # The OpenBLAS of the Python package scipy-openblas32, whose functions have a name in front.
        taut_provided(${package}::${package})
        file(GLOB openblas ${TAUT_CROSS_ROOT}/lib/libscipy_openblas*)
        set(renamed)
        foreach(function dgemm_ dgemv_ dtrmm_ dtrsm_ dpotrf_ dpotrs_ dpotri_ dsyevd_ openblas_get_num_threads openblas_set_num_threads)
            list(APPEND renamed ${function}=scipy_${function})
        endforeach()
        set_target_properties(${package}::${package} PROPERTIES
            INTERFACE_LINK_LIBRARIES ${openblas} INTERFACE_COMPILE_DEFINITIONS "${renamed}")
        set(${package}_FOUND TRUE)
    elseif("${package}" STREQUAL "Python" AND TAUT_PYTHON)
        # That for which the module is: its headers and its library. Python_EXECUTABLE and its version are given.
        add_executable(Python::Interpreter IMPORTED GLOBAL)
        set_target_properties(Python::Interpreter PROPERTIES IMPORTED_LOCATION ${Python_EXECUTABLE})
        foreach(library Module SABIModule)
            add_library(Python::${library} INTERFACE IMPORTED GLOBAL)
            set_target_properties(Python::${library} PROPERTIES
                INTERFACE_INCLUDE_DIRECTORIES ${TAUT_PYTHON}/include INTERFACE_LINK_LIBRARIES ${TAUT_PYTHON}/libpython.a)
        endforeach()
        set(Python_INCLUDE_DIRS ${TAUT_PYTHON}/include)
        set(Python_INTERPRETER_ID Python)
        set(Python_FOUND TRUE)
    endif()
endmacro()
cmake_language(SET_DEPENDENCY_PROVIDER taut_provide_package SUPPORTED_METHODS FIND_PACKAGE)
set(TAUT_VALIJSON_INCLUDE_DIR ${TAUT_CROSS_ROOT}/include CACHE PATH "")
