// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "terminal.hpp"

#include <io.h>
#include <windows.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>

#include "taut/files/file.hpp"

namespace taut::app {
namespace {

constexpr int standard_error = 2;
std::atomic<bool> last_word_is_taken{false};
UINT earlier_code_page = 0;  ///< of the console, which outlives this program
std::atomic<bool> orderly{false};
std::atomic<bool> requested{false};

void write_now(std::string_view line) {
    [[maybe_unused]] const int written =
        _write(standard_error, line.data(), static_cast<unsigned>(line.size()));
}

void restore_console() {
    if (earlier_code_page != 0) {
        SetConsoleOutputCP(earlier_code_page);
    }
}

[[noreturn]] void end_at_once(std::string_view line, int code) {
    remove_temporary_files();
    restore_console();
    write_now(line);
    std::_Exit(code);
}

/// Handles an exception that cannot propagate.
[[noreturn]] void end_unexpectedly() {
    try {
        if (const std::exception_ptr thrown = std::current_exception()) {
            std::rethrow_exception(thrown);
        }
    } catch (const std::bad_alloc&) {
        end_without_memory();
    } catch (const std::exception& error) {
        print_message("error", fmt::format("internal error: {}", error.what()));
        end_at_once("", numerical_failure);
    }
    end_at_once("taut: error: internal error\n", numerical_failure);
}

/// Runs in a thread of its own, at Ctrl-C, Ctrl-Break and when the console is closed.
BOOL WINAPI hand_over(DWORD event) {
    if (!orderly || requested.exchange(true)) {
        end_at_once(is_silent() ? "" : "taut: error: interrupted\n", interrupted);
    }
    if (event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT) {
        Sleep(INFINITE);  // Windows ends the program when this returns, or some seconds later
    }
    return TRUE;
}

}  // namespace

void prepare_streams() {
    earlier_code_page = GetConsoleOutputCP();
    SetConsoleOutputCP(CP_UTF8);
    // Colours and lines that are replaced, as other systems have them.
    const HANDLE console = GetStdHandle(STD_ERROR_HANDLE);
    if (DWORD mode = 0; GetConsoleMode(console, &mode) != 0) {
        SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
    }
    std::set_terminate(end_unexpectedly);
}

void take_last_word() noexcept {
    last_word_is_taken = true;
}

void end_without_memory() {
    if (!last_word_is_taken) {
        write_now("taut: error: not enough memory\n");  // --memory is for Linux
    }
    end_at_once("", numerical_failure);
}

std::filesystem::path program_file() {
    std::wstring name(32'768, L'\0');  // the longest that Windows has
    name.resize(GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())));
    return name;
}

void leave(int code) {
    std::fflush(nullptr);
    restore_console();
    std::_Exit(code);
}

bool is_watched() {
    return !is_silent() && _isatty(standard_error) != 0;
}

void Interruption::watch() {
    SetConsoleCtrlHandler(hand_over, TRUE);
}

bool Interruption::is_requested() {
    return requested;
}

std::function<bool()> Interruption::stop_request() {
    orderly = true;
    return [] { return requested.load(); };
}

}  // namespace taut::app
