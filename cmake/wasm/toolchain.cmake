# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# WebAssembly with WASI, by the Clang, the C library and the sources of libc++ that the Python package
# ziglang carries. scripts/app.sh sets TAUT_ZIG, that package's folder, and TAUT_CROSS_ROOT, where what is
# built for WebAssembly is installed: include/ and lib/.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES TAUT_ZIG TAUT_CROSS_ROOT)
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})  # Platform/WASI.cmake
set(CMAKE_SYSTEM_NAME WASI)
set(CMAKE_SYSTEM_PROCESSOR wasm32)

set(CMAKE_C_COMPILER ${TAUT_ZIG}/zig cc)
# Not c++, which would bring a libc++ without exceptions.
set(CMAKE_CXX_COMPILER ${TAUT_ZIG}/zig cc)
set(CMAKE_AR ${TAUT_ZIG}/zig)
set(CMAKE_RANLIB ${TAUT_ZIG}/zig)

string(CONCAT machine
    "-target wasm32-wasi -mcpu=generic+exception_handling+simd128 -fno-sanitize=all"
    " -D_WASI_EMULATED_SIGNAL -D_WASI_EMULATED_PROCESS_CLOCKS -D_WASI_EMULATED_MMAN -D_WASI_EMULATED_GETPID")
set(CMAKE_C_FLAGS_INIT "${machine}")
# -w: of sizes of 32 bits; the other builds warn.
string(CONCAT CMAKE_CXX_FLAGS_INIT
    "${machine} -w -fwasm-exceptions -nostdinc++ -include ${CMAKE_CURRENT_LIST_DIR}/runtime/config_site.h"
    " -I${TAUT_ZIG}/lib/libcxx/include -I${TAUT_ZIG}/lib/libcxxabi/include")
# long double has 128 bits there, in software: Boost.Math would take most of the time of posterior samples.
string(APPEND CMAKE_CXX_FLAGS_INIT " -DBOOST_MATH_PROMOTE_DOUBLE_POLICY=false")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,--stack,4194304 -Wl,-s")
if(EXISTS ${TAUT_CROSS_ROOT}/lib/libc++.a)
    set(CMAKE_CXX_STANDARD_LIBRARIES ${TAUT_CROSS_ROOT}/lib/libc++.a)
endif()
