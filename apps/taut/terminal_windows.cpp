// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "terminal.hpp"

#include <io.h>
#include <windows.h>

#include <exception>
#include <filesystem>
#include <string>
#include <string_view>

#include "ending.hpp"

namespace taut::app {
namespace {

constexpr int standard_error = 2;
UINT earlier_code_page = 0;  ///< of the console, which outlives this program

/// Runs in a thread of its own, at Ctrl-C, Ctrl-Break and when the console is closed.
BOOL WINAPI hand_over(DWORD event) {
    interrupt();
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

std::filesystem::path program_file() {
    std::wstring name(32'768, L'\0');  // the longest that Windows has
    name.resize(GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())));
    return name;
}

void write_now(std::string_view line) noexcept {
    [[maybe_unused]] const int written =
        _write(standard_error, line.data(), static_cast<unsigned>(line.size()));
}

void restore_console() noexcept {
    if (earlier_code_page != 0) {
        SetConsoleOutputCP(earlier_code_page);
    }
}

bool is_watched() {
    return !is_silent() && _isatty(standard_error) != 0;
}

void Interruption::watch() {
    SetConsoleCtrlHandler(hand_over, TRUE);
}

}  // namespace taut::app
