// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Not all libraries survive a malloc that finds no memory: HDF5 1.10 reads through the null
// pointer, or ends the process silently. So the program puts its own allocation functions in front
// of those of the C library, for all of its libraries, and ends with a message where one fails.

#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstdlib>  // defines __GLIBC__

#include "terminal.hpp"

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TAUT_MALLOC_IS_ANOTHERS
#endif
#endif

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && \
    !defined(TAUT_MALLOC_IS_ANOTHERS)

// glibc's own, under the names that it exports for this use. The whole family is replaced: memory
// of one allocator must not go to the free() of another, which may be preloaded.
// NOLINTBEGIN(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp,readability-identifier-naming)
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);
}
// NOLINTEND(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp,readability-identifier-naming)

namespace {

void* or_end(void* memory, std::size_t size) {
    if (memory == nullptr && size > 0) {
        taut::app::end_without_memory();
    }
    return memory;
}

}  // namespace

extern "C" void* malloc(std::size_t size) noexcept {
    return or_end(__libc_malloc(size), size);
}

// NOLINTBEGIN(readability-inconsistent-declaration-parameter-name): those of stdlib.h are reserved
extern "C" void* calloc(std::size_t count, std::size_t size) noexcept {
    return or_end(__libc_calloc(count, size), count > 0 ? size : 0);
}

extern "C" void* realloc(void* old, std::size_t size) noexcept {
    return or_end(__libc_realloc(old, size), size);
}

extern "C" void free(void* memory) noexcept {
    __libc_free(memory);
}

extern "C" void* memalign(std::size_t alignment, std::size_t size) noexcept {
    return or_end(__libc_memalign(alignment, size), size);
}

extern "C" void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    return or_end(__libc_memalign(alignment, size), size);
}

extern "C" int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
    if (alignment % sizeof(void*) != 0 || !std::has_single_bit(alignment)) {
        return EINVAL;
    }
    *memory = or_end(__libc_memalign(alignment, size), size);
    return 0;
}
// NOLINTEND(readability-inconsistent-declaration-parameter-name)

#endif
