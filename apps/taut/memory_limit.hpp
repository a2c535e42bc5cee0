// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// --memory: what a command may take. The system keeps it: an allocation beyond it fails, and the
/// program ends with its one line. Where it is known beforehand that it will not do, the command is
/// refused before the work.
namespace taut::app {

/// Bytes of "8GiB", "500 MB", "1.5GB".
/// @throws std::invalid_argument for other text, and for what is no more than 0 or beyond 2^60
[[nodiscard]] std::uint64_t parse_memory(std::string_view text);

/// From now on this process's writable memory stays within so much (Linux: RLIMIT_DATA).
/// @param text as parse_memory() takes it
/// @param threads that will work
/// @throws std::invalid_argument as parse_memory(), where the program holds too much before its
/// work
///   begins, and on systems that keep no such limit
void limit_memory(const std::string& text, int threads);

/// What the limit is, behind a message: " (--memory is 1.5 GiB)", or nothing. Asks for no memory.
[[nodiscard]] std::string_view memory_limit_note() noexcept;

/// Refuses what takes more than --memory allows, before the work.
/// @param bytes what the work holds, besides the program itself
/// @param what the work is, as in "the command needs 2.1 GiB for 100000 samples"
/// @throws std::invalid_argument
void require_memory(double bytes, std::string_view what);

}  // namespace taut::app
