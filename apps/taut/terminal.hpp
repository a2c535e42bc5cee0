// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/core.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace taut::app {

/// The exit code after SIGINT, as shells have it.
inline constexpr int interrupted = 130;
/// The others.
inline constexpr int numerical_failure = 1;
inline constexpr int wrong_input = 2;

/// Makes standard streams that are closed lead nowhere, so that no file that is opened later is
/// taken for one of them, and lets a write beyond the largest file that is allowed fail (EFBIG)
/// rather than end the program. Where an exception cannot be thrown on, for want of memory, the
/// program ends with a line and exit code 1. Call first.
void prepare_streams();

/// Ends the program, its streams flushed, without waiting for the threads of libraries: one may try
/// for ever to get memory that a limit does not leave.
[[noreturn]] void leave(int code);

/// Ends the program at once with a line and exit code 1, temporary files removed.
[[noreturn]] void end_without_memory();

/// From now on the calling thread tells why the program ends, and end_without_memory() nothing: of
/// threads that come to no memory meanwhile, and of this one once it has told.
void take_last_word() noexcept;

/// From now on nothing is told and printed: another process does.
void be_silent();
[[nodiscard]] bool is_silent();

/// Writes to standard output, control characters as printable() has them. Whether that went well is
/// told by standard_output_works().
void print(std::string_view text);

template <class... Values>
void say(fmt::format_string<Values...> format, Values&&... values) {
    print(fmt::format(format, std::forward<Values>(values)...));
}

/// Flushes standard output. @return false where anything could not be written
[[nodiscard]] bool standard_output_works();

/// The line "taut: error: ..." on standard error; nothing where that is closed or full.
/// @param kind "error", "warning", "note"
void tell(std::string_view kind, std::string_view line) noexcept;

/// Whether standard error is shown to somebody.
[[nodiscard]] bool is_watched();

/// Takes the place of the line that standard error shows last.
void tell_in_place(std::string_view line) noexcept;

/// What SIGINT, SIGTERM and SIGHUP do. A command that says nothing is ended at once with exit code
/// 130; its outputs appear in one piece or not at all, so nothing is left half done. A command that
/// asks for stop_request() is told by it, and ended at once by a second signal.
class Interruption {
public:
    /// Call once. Signals that are ignored stay so.
    static void watch();

    /// Whether a signal requested a stop of a command that asked for stop_request().
    [[nodiscard]] static bool is_requested();

    /// From now on the first signal does no more than to request a stop: whether it came.
    [[nodiscard]] static std::function<bool()> stop_request();
};

/// Sampling was interrupted and what is done was kept: the message tells where.
class SampleInterrupted : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace taut::app
