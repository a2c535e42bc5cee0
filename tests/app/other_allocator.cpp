// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// An allocator as LD_PRELOAD brings one into any program: it never frees, and ends the process
// where it is handed memory that is not its own.

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace {

constexpr std::size_t arena_size = std::size_t{1} << 28U;
alignas(4096) char arena[arena_size];
std::atomic<std::size_t> used{0};

/// The size of each piece stands before it.
void* take(std::size_t size, std::size_t alignment) {
    const std::size_t room = size + alignment + sizeof(std::size_t);
    const std::size_t begin = used.fetch_add(room);
    if (begin + room > arena_size) {
        errno = ENOMEM;
        return nullptr;
    }
    std::size_t place = begin + sizeof(std::size_t);
    place += (alignment - place % alignment) % alignment;
    std::memcpy(arena + place - sizeof(std::size_t), &size, sizeof size);
    return arena + place;
}

bool is_own(const void* memory) {
    const auto* const byte = static_cast<const char*>(memory);
    return byte >= arena && byte < arena + arena_size;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) noexcept {
    return take(size, alignof(std::max_align_t));
}

void free(void* memory) noexcept {
    if (memory != nullptr && !is_own(memory)) {
        std::abort();
    }
}

void* calloc(std::size_t count, std::size_t size) noexcept {
    return take(count * size, alignof(std::max_align_t));  // the arena begins as zeros
}

void* realloc(void* old, std::size_t size) noexcept {
    void* const memory = malloc(size);
    if (old != nullptr && memory != nullptr) {
        if (!is_own(old)) {
            std::abort();
        }
        std::size_t old_size = 0;
        std::memcpy(&old_size, static_cast<char*>(old) - sizeof old_size, sizeof old_size);
        std::memcpy(memory, old, old_size < size ? old_size : size);
    }
    return memory;
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
    return take(size, alignment);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    return take(size, alignment);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
    *memory = take(size, alignment);
    return *memory == nullptr ? ENOMEM : 0;
}
}
