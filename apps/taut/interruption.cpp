// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interruption.hpp"

#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <thread>

namespace taut::app {
namespace {

constexpr int interrupted = 130;

std::stop_source& source() {
    static std::stop_source the_source;
    return the_source;
}

std::atomic<bool> orderly{false};

}  // namespace

void Interruption::watch() {
    source();
    // Every thread inherits the mask, so the signals reach none but the one that waits for them.
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        sigaddset(&signals, signal);
    }
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::thread([signals] {
        while (true) {
            int signal = 0;
            sigwait(&signals, &signal);
            if (!orderly || source().stop_requested()) {
                _exit(interrupted);
            }
            source().request_stop();
        }
    }).detach();
}

std::stop_token Interruption::stop_token() {
    orderly = true;
    return source().get_token();
}

}  // namespace taut::app
