// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

/// --memory: the memory that a command may take. The system enforces it: an allocation beyond it
/// fails, and the program ends with one line. A command known to need more is refused before its
/// work.
namespace taut::app {

/// From now on this process's writable memory stays within so much (Linux: RLIMIT_DATA).
/// @param text as parse_memory() takes it
/// @param threads that will work
/// @throws std::invalid_argument for other text and for 0 or less, where the program holds too much
///   before its work begins, and on systems without such a limit
void limit_memory(const std::string& text, int threads);

/// The limit, to end a message with: " (--memory is 1.5 GiB)", or nothing. Allocates nothing.
[[nodiscard]] std::string_view memory_limit_note() noexcept;

#ifdef __wasi__
/// Whether the memory of WebAssembly, which no system limits, is within the limit.
[[nodiscard]] bool keeps_memory_limit() noexcept;

/// Whether an allocation has failed. A library may have taken that for something else.
[[nodiscard]] bool ran_out_of_memory() noexcept;
#endif

/// Refuses what takes more than --memory allows, before the work.
/// @param bytes what the work holds, besides the program itself
/// @param what the work is, as in "the command needs 2.1 GiB for 100000 samples"
/// @throws std::invalid_argument
void require_memory(double bytes, std::string_view what);

}  // namespace taut::app
