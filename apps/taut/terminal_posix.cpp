// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "terminal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <exception>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <thread>

#include "ending.hpp"

namespace taut::app {
namespace {

std::array<int, 2> arrived{};  ///< a pipe: what the handler writes, the thread reads

/// Runs in whichever thread receives the signal, where next to nothing is allowed. Blocking the
/// signal in all threads but one would not help: a library may start its own before main().
void hand_over(int /*signal*/) {
    [[maybe_unused]] const auto written = ::write(arrived[1], "", 1);
}

/// Handles what arrives through the pipe, for as long as the program runs.
[[noreturn]] void hand_on_signals() {
    while (true) {
        char byte = 0;
        if (::read(arrived[0], &byte, 1) == 1) {
            interrupt();
        }
    }
}

}  // namespace

void prepare_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) == -1) {
            // open() gives the lowest free number, which is this one. Read-only, so that printing
            // fails and standard_output_works() shows it.
            [[maybe_unused]] const int opened = open("/dev/null", O_RDONLY);
        }
    }
    std::signal(SIGXFSZ, SIG_IGN);
    std::set_terminate(end_unexpectedly);
}

std::filesystem::path program_file() {
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error);
}

void write_now(std::string_view line) noexcept {
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, line.data(), line.size());
}

void restore_console() noexcept {}

bool is_watched() {
    return !is_silent() && isatty(STDERR_FILENO) == 1;
}

void Interruption::watch() {
    if (pipe(arrived.data()) != 0) {
        return;  // signals then end the program, as they do by default
    }
    try {
        std::thread(hand_on_signals).detach();
    } catch (const std::system_error&) {
        return;  // likewise
    }
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action{};
        sigaction(signal, nullptr, &action);
        if (action.sa_handler == SIG_IGN) {
            continue;  // as nohup wants it
        }
        action.sa_handler = hand_over;
        action.sa_flags = SA_RESTART;
        sigaction(signal, &action, nullptr);
    }
}

}  // namespace taut::app
