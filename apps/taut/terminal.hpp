// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/core.h>

#include <filesystem>
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

/// The file of this program; empty where the system does not say.
[[nodiscard]] std::filesystem::path program_file();

/// Ends the program, its streams flushed, without waiting for the threads of libraries: one may try
/// for ever to get memory that a limit does not leave.
[[noreturn]] void leave(int code);

/// Ends the program at once with a line and exit code 1, temporary files removed.
[[noreturn]] void end_without_memory();

/// From now on the calling thread prints why the program ends. end_without_memory() then prints
/// nothing: neither in other threads that run out of memory meanwhile, nor in this one afterwards.
void take_last_word() noexcept;

/// From now on nothing is printed: another process does that.
void be_silent();
[[nodiscard]] bool is_silent();

/// Writes to standard output, control characters as printable() has them. standard_output_works()
/// gives whether that succeeded.
void print(std::string_view text);

template <class... Values>
void say(fmt::format_string<Values...> format, Values&&... values) {
    print(fmt::format(format, std::forward<Values>(values)...));
}

/// Flushes standard output.
/// @return false where anything could not be written
[[nodiscard]] bool standard_output_works();

/// Prints the line "taut: error: ..." on standard error; nothing where that is closed or full.
/// @param kind "error", "warning", "note"
void print_message(std::string_view kind, std::string_view line) noexcept;

/// Whether standard error is a terminal, and this process prints.
[[nodiscard]] bool is_watched();

/// Replaces the last line of standard error.
void print_in_place(std::string_view line) noexcept;

/// What SIGINT, SIGTERM and SIGHUP do. By default they end a command at once with exit code 130;
/// its outputs appear in one piece or not at all, so nothing is left half done. A command that
/// polls stop_request() can end in its own way, and a second signal ends it at once.
class Interruption {
public:
    /// Call once. Signals that are ignored stay so.
    static void watch();

    /// Whether a signal requested a stop of a command that called stop_request().
    [[nodiscard]] static bool is_requested();

    /// From now on the first signal only requests a stop.
    /// @return a function that gives whether it came
    [[nodiscard]] static std::function<bool()> stop_request();
};

/// Sampling was interrupted and its samples were kept: the message names the file.
class SampleInterrupted : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace taut::app
