# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# For Windows 10 and later by Debian's MinGW-w64, with all of its own libraries in what is linked.
# scripts/windows.sh sets TAUT_CROSS_ROOT, where what is built for Windows is installed: include/ and lib/.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES TAUT_CROSS_ROOT)
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_CROSSCOMPILING_EMULATOR wine)
set(CMAKE_C_FLAGS_INIT -D_WIN32_WINNT=0x0A00)
set(CMAKE_CXX_FLAGS_INIT "-D_WIN32_WINNT=0x0A00 -Wa,-mbig-obj")  # for more sections than its objects have
foreach(kind EXE SHARED MODULE)
    set(CMAKE_${kind}_LINKER_FLAGS_INIT -static)
endforeach()
list(APPEND CMAKE_PREFIX_PATH ${TAUT_CROSS_ROOT})
set(CMAKE_FIND_ROOT_PATH ${TAUT_CROSS_ROOT} /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
