# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# What taut needs from outside. Imported targets: their headers count as system headers.
# cmake/tautConfig.cmake.in repeats those that a static library still needs when it is linked.
find_package(Eigen3 3.4 REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(TBB 2021 REQUIRED)
find_package(fmt 9 REQUIRED)
# Clang 19 and the GCC that made Debian's libfmt give one of its templates two names.
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    set(TAUT_FMT fmt::fmt-header-only)
else()
    set(TAUT_FMT fmt::fmt)
endif()
find_package(NLopt 2.7 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(pugixml 1.13 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(TAUT_OPENBLAS REQUIRED IMPORTED_TARGET openblas)
pkg_check_modules(TAUT_LAPACKE REQUIRED IMPORTED_TARGET lapacke)
pkg_check_modules(TAUT_HDF5 REQUIRED IMPORTED_TARGET hdf5)

if(TAUT_BUILD_APP)
    find_package(CLI11 2.1 REQUIRED)
endif()
if(TAUT_BUILD_TESTS)
    find_package(GTest 1.12 REQUIRED)
    find_package(rapidcheck REQUIRED)
endif()
if(TAUT_BUILD_BENCHMARKS)
    find_package(benchmark REQUIRED)
endif()
