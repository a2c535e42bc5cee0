// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// While it is loaded, before main(), OpenBLAS starts a thread for each processor but one. Where it
// gets none, it prints lines of its own and raises SIGINT. The program uses none of these threads
// (numerics/serial_blas.hpp). OpenBLAS counts the processors that the process may run on, so this
// file makes that one processor until all libraries are loaded.
#include <cstdlib>  // defines __GLIBC__

#if defined(__linux__) && defined(__GLIBC__)
#include <sys/syscall.h>
#include <unistd.h>

// What runs before any library is ready, a sanitizer's included, may use next to nothing.
// NOLINTBEGIN(cppcoreguidelines-avoid-c-arrays,cppcoreguidelines-avoid-non-const-global-variables)
namespace {

constexpr long words = 128;  // of a set of 8192 processors
unsigned long allowed[words];
long allowed_bytes = 0;  ///< 0: left as they are

[[gnu::no_sanitize("address", "thread", "undefined")]] void keep_to_one_processor() {
    allowed_bytes = syscall(SYS_sched_getaffinity, 0, sizeof allowed, allowed);
    for (long word = 0; word < words && allowed_bytes > 0; ++word) {
        if (allowed[word] != 0) {
            unsigned long one[words] = {};
            one[word] = allowed[word] & (~allowed[word] + 1);  // the lowest bit
            if (syscall(SYS_sched_setaffinity, 0, allowed_bytes, one) != 0) {
                allowed_bytes = 0;
            }
            return;
        }
    }
}

/// Before the constructors of the program's own objects, and behind those of all libraries.
[[gnu::constructor(101)]] void use_all_processors() {
    if (allowed_bytes > 0) {
        syscall(SYS_sched_setaffinity, 0, allowed_bytes, allowed);
    }
}

/// Before the constructors of all libraries.
[[gnu::section(".preinit_array"), gnu::used]] void (*const at_first)() = keep_to_one_processor;

}  // namespace
// NOLINTEND(cppcoreguidelines-avoid-c-arrays,cppcoreguidelines-avoid-non-const-global-variables)
#endif
