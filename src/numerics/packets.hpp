// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

/// TAUT_PACKETS before a function compiles it twice: with AVX, and for every x86-64. The machine
/// chooses when the program starts. Both give the same bits, since AVX has no fused multiply-add.
/// Sanitizers do not support such a choice.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TAUT_PACKETS
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(undefined_behavior_sanitizer)
#define TAUT_PACKETS
#endif
#endif
#if !defined(TAUT_PACKETS)
#if defined(__x86_64__) && defined(__gnu_linux__)
#define TAUT_PACKETS [[gnu::target_clones("avx", "default")]]
#else
#define TAUT_PACKETS
#endif
#endif

namespace taut {

/// Four numbers that the compiler processes with the widest instructions it may use. Load and store
/// them by std::memcpy: numbers may have any alignment, and compilers disagree on how to declare a
/// vector type of smaller alignment.
using Packet = double __attribute__((vector_size(32)));

}  // namespace taut
