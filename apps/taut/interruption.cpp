// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interruption.hpp"

#include <semaphore.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string_view>
#include <thread>

namespace taut::app {
namespace {

/// Never destroyed: the thread that watches lives to the end of the process.
std::stop_source& source() {
    static auto& the_source = *new std::stop_source;
    return the_source;
}

std::atomic<bool> orderly{false};
sem_t arrived;

/// Runs in whichever thread the signal meets, where next to nothing is allowed. To block the signal
/// in all threads but one is no way out: OpenBLAS starts its own before main().
void hand_over(int /*signal*/) {
    sem_post(&arrived);
}

[[noreturn]] void end_at_once() {
    constexpr std::string_view line = "taut: error: interrupted\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, line.data(), line.size());
    _exit(interrupted);
}

}  // namespace

void Interruption::watch() {
    source();
    sem_init(&arrived, 0, 0);
    std::thread([] {
        while (true) {
            if (sem_wait(&arrived) != 0) {
                continue;
            }
            if (!orderly || source().stop_requested()) {
                end_at_once();
            }
            source().request_stop();
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

std::stop_token Interruption::stop_token() {
    orderly = true;
    return source().get_token();
}

}  // namespace taut::app
