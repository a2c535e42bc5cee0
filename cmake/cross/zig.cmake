# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# For Linux with an older C library than this machine's, by the Clang, the C library and the libc++ that the Python
# package ziglang carries. scripts/wheels.sh sets TAUT_ZIG, that package's folder; TAUT_ZIG_TARGET, such as
# x86_64-linux-gnu.2.28; and TAUT_CROSS_ROOT, where what is built for that machine is installed: include/ and lib/.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES TAUT_ZIG TAUT_ZIG_TARGET TAUT_CROSS_ROOT)
set(CMAKE_C_COMPILER ${TAUT_ZIG}/zig cc)
set(CMAKE_CXX_COMPILER ${TAUT_ZIG}/zig c++)
# Zig's own default would check for undefined behaviour.
set(CMAKE_C_FLAGS_INIT "-target ${TAUT_ZIG_TARGET} -fno-sanitize=all")
set(CMAKE_CXX_FLAGS_INIT "-target ${TAUT_ZIG_TARGET} -fno-sanitize=all -w")
list(APPEND CMAKE_PREFIX_PATH ${TAUT_CROSS_ROOT})
