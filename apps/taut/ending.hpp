// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

/// How the program ends on systems with threads and signals: what terminal_posix.cpp and
/// terminal_windows.cpp share, and what each of them has for it.
namespace taut::app {

/// Ends the program with a line on standard error, temporary files removed.
[[noreturn]] void end_at_once(std::string_view line, int code);

/// Handles an exception that cannot propagate. Where memory is short, destructors of libraries may
/// ask for more, and must not throw.
[[noreturn]] void end_unexpectedly();

/// What a signal does, of any thread that may allocate: see Interruption.
void interrupt();

/// Of each system: writes to standard error at once.
void write_now(std::string_view line) noexcept;

/// Of each system: undoes what prepare_streams() did to a console that outlives the program.
void restore_console() noexcept;

}  // namespace taut::app
