// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

/// TAUT_PACKETS before a function has it compiled twice, and the machine chooses when the program
/// starts: with AVX, or with what every x86-64 has. Both give the same bits: AVX has no fused
/// multiplication and addition. Sanitizers do not bear such a choice.
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

/// Four numbers that the compiler computes with by instructions as wide as it may use. Taken from
/// memory, and put there, by std::memcpy: compilers do not agree on how a type of a smaller
/// alignment is told, and numbers may stand anywhere.
using Packet = double __attribute__((vector_size(32)));

}  // namespace taut
