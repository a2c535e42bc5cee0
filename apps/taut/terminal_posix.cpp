// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "terminal.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>
#include <thread>

#include "memory_limit.hpp"
#include "taut/files/file.hpp"

namespace taut::app {
namespace {

/// The thread that ends the program, and whether take_last_word() claimed the line that says why.
std::atomic<std::thread::id> ending{};
std::atomic<bool> last_word_is_taken{false};
constexpr int long_enough = 1000;  ///< wait for the other thread [ms]

std::atomic<bool> orderly{false};
std::atomic<bool> requested{false};
std::array<int, 2> arrived{};  ///< a pipe: what the handler writes, the thread reads

/// Runs in whichever thread receives the signal, where next to nothing is allowed. Blocking the
/// signal in all threads but one would not help: a library may start its own before main().
void hand_over(int /*signal*/) {
    [[maybe_unused]] const auto written = ::write(arrived[1], "", 1);
}

[[noreturn]] void end_at_once(std::string_view line, int code) {
    remove_temporary_files();
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, line.data(), line.size());
    _exit(code);
}

/// "taut: error: not enough memory", with the limit where there is one. Asks for no memory.
class NoMemoryLine {
public:
    NoMemoryLine() {
        for (const std::string_view part : {std::string_view("taut: error: not enough memory"),
                                            memory_limit_note(), std::string_view("\n")}) {
            m_size += part.copy(m_text.data() + m_size, m_text.size() - m_size);
        }
    }
    [[nodiscard]] std::string_view view() const { return {m_text.data(), m_size}; }

private:
    std::array<char, 128> m_text{};
    size_t m_size = 0;
};

/// Handles an exception that cannot propagate. Where memory is short, destructors of libraries may
/// ask for more, and must not throw.
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

/// Handles what arrives through the pipe, for as long as the program runs.
[[noreturn]] void hand_on_signals() {
    while (true) {
        char byte = 0;
        if (::read(arrived[0], &byte, 1) == 1 && (!orderly || requested.exchange(true))) {
            end_at_once(is_silent() ? "" : "taut: error: interrupted\n", interrupted);
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

void take_last_word() noexcept {
    std::thread::id first{};
    if (!ending.compare_exchange_strong(first, std::this_thread::get_id()) &&
        first != std::this_thread::get_id()) {
        poll(nullptr, 0, long_enough);  // the other prints its line, and ends this thread
    }
    last_word_is_taken = true;
}

void end_without_memory() {
    const NoMemoryLine line;
    std::thread::id first{};
    if (!ending.compare_exchange_strong(first, std::this_thread::get_id())) {
        if (first == std::this_thread::get_id()) {  // an orderly end asks for memory, too
            if (!last_word_is_taken) {
                [[maybe_unused]] const auto written =
                    ::write(STDERR_FILENO, line.view().data(), line.view().size());
            }
            _exit(numerical_failure);
        }
        // Another thread ends the program, unless it waits for something this one holds.
        poll(nullptr, 0, long_enough);
    }
    end_at_once(last_word_is_taken ? "" : line.view(), numerical_failure);
}

std::filesystem::path program_file() {
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error);
}

void leave(int code) {
    std::fflush(nullptr);
    _exit(code);
}

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

bool Interruption::is_requested() {
    return requested;
}

std::function<bool()> Interruption::stop_request() {
    orderly = true;
    return [] { return requested.load(); };
}

}  // namespace taut::app
