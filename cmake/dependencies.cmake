# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# What taut needs from outside. Imported targets: their headers count as system headers.
# cmake/tautConfig.cmake.in repeats those that a static library still needs when it is linked.
include(CheckCXXSourceCompiles)

# Either major version: their version files accept no range over both.
find_package(Eigen3 3.4 QUIET)
if(NOT Eigen3_FOUND)
    find_package(Eigen3 5 REQUIRED)
endif()
find_package(Boost 1.74 REQUIRED)
find_package(FastFloat REQUIRED)  # std::from_chars of a double, which libc++ has from 20 on
find_package(fmt 9 REQUIRED)
# Clang 19 and the GCC that made Debian's libfmt give one of its templates two names; for another machine there is none.
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang" OR CMAKE_CROSSCOMPILING)
    set(TAUT_FMT fmt::fmt-header-only)
else()
    set(TAUT_FMT fmt::fmt)
endif()
set(TAUT_TBB)
if(TAUT_WITH_TBB)
    find_package(TBB 2021 REQUIRED)
    set(TAUT_TBB TBB::tbb)
else()
    add_compile_definitions(TAUT_WITHOUT_TBB)
endif()
if(TAUT_WITH_NLOPT)
    # Debian has it twice, in nlopt and nlopt_cxx, and CMake 4 looks into the second first.
    set(CMAKE_FIND_PACKAGE_SORT_ORDER NAME)
    set(CMAKE_FIND_PACKAGE_SORT_DIRECTION ASC)
    find_package(NLopt 2.7 REQUIRED)
    unset(CMAKE_FIND_PACKAGE_SORT_ORDER)
    unset(CMAKE_FIND_PACKAGE_SORT_DIRECTION)
endif()
find_package(nlohmann_json 3.11 REQUIRED)
# Headers alone; the name of its target changes from version to version.
find_path(TAUT_VALIJSON_INCLUDE_DIR valijson/validator.hpp REQUIRED)
find_package(pugixml 1.13 REQUIRED)
if(TAUT_WITH_BLAS)
    find_package(BLAS REQUIRED)
    find_package(LAPACK REQUIRED)
endif()
set(TAUT_HAS_METIS ${TAUT_WITH_METIS})
if(TAUT_HAS_METIS AND NOT TARGET taut::metis)
    message(FATAL_ERROR "TAUT_WITH_METIS is on, and METIS was not found: metis.h and its library")
endif()
if(TAUT_WITH_HDF5)
    find_package(PkgConfig REQUIRED)
    pkg_check_modules(TAUT_HDF5 REQUIRED IMPORTED_TARGET hdf5)
endif()

if(TAUT_WITH_XLSX)
    find_package(PkgConfig REQUIRED)
    pkg_check_modules(TAUT_MINIZIP REQUIRED IMPORTED_TARGET minizip)
endif()

# How this BLAS is kept to one thread (src/numerics/serial_blas.cpp): by a function of its own.
set(TAUT_BLAS_THREADS "")
if(TAUT_WITH_BLAS)
    set(CMAKE_REQUIRED_LIBRARIES BLAS::BLAS)
    check_cxx_source_compiles([[
        extern "C" void openblas_set_num_threads(int);
        int main() { openblas_set_num_threads(1); }]] TAUT_FOUND_OPENBLAS)
    check_cxx_source_compiles([[
        extern "C" int MKL_Set_Num_Threads_Local(int);
        int main() { MKL_Set_Num_Threads_Local(1); }]] TAUT_FOUND_MKL)
    unset(CMAKE_REQUIRED_LIBRARIES)
    if(TAUT_FOUND_OPENBLAS)
        set(TAUT_BLAS_THREADS TAUT_BLAS_IS_OPENBLAS)
    elseif(TAUT_FOUND_MKL)
        set(TAUT_BLAS_THREADS TAUT_BLAS_IS_MKL)
    endif()
endif()

if(TAUT_BUILD_APP)
    find_package(CLI11 2.1 REQUIRED)
endif()
if(TAUT_BUILD_MPI)
    set(MPI_CXX_SKIP_MPICXX ON)
    find_package(MPI 3.1 REQUIRED COMPONENTS CXX)
endif()
if(TAUT_BUILD_TESTS)
    foreach(part TBB BLAS HDF5 NLOPT XLSX)
        if(NOT TAUT_WITH_${part})
            message(FATAL_ERROR "the tests are of the whole: TAUT_WITH_${part} is off")
        endif()
    endforeach()
    find_package(GTest 1.12 REQUIRED)
    find_package(rapidcheck REQUIRED)
endif()
if(TAUT_BUILD_BENCHMARKS)
    find_package(benchmark REQUIRED)
endif()
