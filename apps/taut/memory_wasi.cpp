// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// What memory_glibc.cpp does for glibc, in WebAssembly, where the program keeps --memory itself:
// the linker puts these functions in front of those of the C library (--wrap).
#include <cstddef>

#include "memory_limit.hpp"
#include "terminal.hpp"

namespace {

void* or_end(void* memory, std::size_t size) {
    if ((memory == nullptr && size > 0) || !taut::app::keeps_memory_limit()) {
        taut::app::end_without_memory();
    }
    return memory;
}

}  // namespace

extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* old, std::size_t size);
void* __real_aligned_alloc(std::size_t alignment, std::size_t size);
int __real_posix_memalign(void** memory, std::size_t alignment, std::size_t size);

void* __wrap_malloc(std::size_t size) {
    return or_end(__real_malloc(size), size);
}

void* __wrap_calloc(std::size_t count, std::size_t size) {
    return or_end(__real_calloc(count, size), count > 0 ? size : 0);
}

void* __wrap_realloc(void* old, std::size_t size) {
    return or_end(__real_realloc(old, size), size);
}

void* __wrap_aligned_alloc(std::size_t alignment, std::size_t size) {
    return or_end(__real_aligned_alloc(alignment, size), size);
}

int __wrap_posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
    const int error = __real_posix_memalign(memory, alignment, size);
    or_end(error == 0 ? *memory : nullptr, size);
    return error;
}
}
