// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "ending.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <new>
#include <thread>

#include "memory_limit.hpp"
#include "taut/files/file.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

/// The thread that ends the program, and whether take_last_word() claimed the line that says why.
std::atomic<std::thread::id> ending{};
std::atomic<bool> last_word_is_taken{false};
constexpr std::chrono::seconds long_enough{1};  ///< to wait for the other thread

std::atomic<bool> orderly{false};
std::atomic<bool> requested{false};

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

}  // namespace

void end_at_once(std::string_view line, int code) {
    remove_temporary_files();
    restore_console();
    write_now(line);
    std::_Exit(code);
}

void end_unexpectedly() {
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

void interrupt() {
    if (!orderly || requested.exchange(true)) {
        end_at_once(is_silent() ? "" : "taut: error: interrupted\n", interrupted);
    }
}

void take_last_word() noexcept {
    std::thread::id first{};
    if (!ending.compare_exchange_strong(first, std::this_thread::get_id()) &&
        first != std::this_thread::get_id()) {
        // The other prints its line, and ends this thread.
        std::this_thread::sleep_for(long_enough);
    }
    last_word_is_taken = true;
}

void end_without_memory() {
    const NoMemoryLine line;
    std::thread::id first{};
    if (!ending.compare_exchange_strong(first, std::this_thread::get_id())) {
        if (first == std::this_thread::get_id()) {  // an orderly end asks for memory, too
            if (!last_word_is_taken) {
                write_now(line.view());
            }
            std::_Exit(numerical_failure);
        }
        // Another thread ends the program, unless it waits for something this one holds.
        std::this_thread::sleep_for(long_enough);
    }
    end_at_once(last_word_is_taken ? "" : line.view(), numerical_failure);
}

void leave(int code) {
    std::fflush(nullptr);
    restore_console();
    std::_Exit(code);
}

bool Interruption::is_requested() {
    return requested;
}

std::function<bool()> Interruption::stop_request() {
    orderly = true;
    return [] { return requested.load(); };
}

}  // namespace taut::app
