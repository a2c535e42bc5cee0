// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// The limit of --memory in WebAssembly, which no system keeps: an allocation that would need memory
// beyond it fails. The functions of ziglang's C library are weak symbols; these stand in their
// place, and work by two that nobody else calls. They do not end the program, as those of
// memory_glibc.cpp do: its end is an exception to JavaScript, which the cleanup of all functions on
// the way would catch.
#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "memory_limit.hpp"

extern "C" {
void* memalign(std::size_t alignment, std::size_t size);
void* reallocarray(void* old, std::size_t count, std::size_t size);
}

namespace {

bool has_failed = false;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

/// Memory that was allocated when so many pages were in use, or nothing.
void* within_limit(void* memory, std::size_t pages_before) {
    if (__builtin_wasm_memory_size(0) > pages_before && !taut::app::keeps_memory_limit()) {
        std::free(memory);
        memory = nullptr;
    }
    if (memory == nullptr) {
        errno = ENOMEM;
        has_failed = true;
    }
    return memory;
}

}  // namespace

bool taut::app::ran_out_of_memory() noexcept {
    return has_failed;
}

extern "C" void* aligned_alloc(std::size_t alignment, std::size_t size) {
    const std::size_t before = __builtin_wasm_memory_size(0);
    return within_limit(memalign(alignment, size), before);
}

extern "C" void* malloc(std::size_t size) {
    return aligned_alloc(alignof(std::max_align_t), size);
}

extern "C" void* calloc(std::size_t count, std::size_t size) {
    const bool is_possible = size == 0 || count <= std::numeric_limits<std::size_t>::max() / size;
    void* const memory = is_possible ? malloc(count * size) : nullptr;
    return memory == nullptr ? nullptr : std::memset(memory, 0, count * size);
}

extern "C" void* realloc(void* old, std::size_t size) {
    const std::size_t before = __builtin_wasm_memory_size(0);
    return within_limit(reallocarray(old, 1, size), before);
}

extern "C" int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
    if (alignment % sizeof(void*) != 0 || !std::has_single_bit(alignment)) {
        return EINVAL;
    }
    *memory = aligned_alloc(alignment, size);
    return *memory == nullptr ? ENOMEM : 0;
}
