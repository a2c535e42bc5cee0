// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "terminal.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <string_view>
#include <thread>

namespace taut::app {
namespace {

std::atomic<bool> orderly{false};
std::atomic<bool> requested{false};
std::array<int, 2> arrived{};  ///< a pipe: what the handler writes, the thread reads

/// Runs in whichever thread the signal meets, where next to nothing is allowed. To block the signal
/// in all threads but one is no way out: OpenBLAS starts its own before main().
void hand_over(int /*signal*/) {
    [[maybe_unused]] const auto written = ::write(arrived[1], "", 1);
}

[[noreturn]] void end_at_once() {
    constexpr std::string_view line = "taut: error: interrupted\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, line.data(), line.size());
    _exit(interrupted);
}

}  // namespace

bool is_watched() {
    return isatty(STDERR_FILENO) == 1;
}

void Interruption::watch() {
    if (pipe(arrived.data()) != 0) {
        return;  // signals then end the program, as they do by default
    }
    std::thread([] {
        while (true) {
            char byte = 0;
            if (::read(arrived[0], &byte, 1) != 1) {
                continue;
            }
            if (!orderly || requested.exchange(true)) {
                end_at_once();
            }
        }
    }).detach();
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

std::function<bool()> Interruption::stop_request() {
    orderly = true;
    return [] { return requested.load(); };
}

}  // namespace taut::app
