// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// How work of taut is called: without the interpreter's lock, with the number of threads that was
// set, and so that Ctrl-C ends it.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "taut/progress.hpp"

namespace taut::python {

namespace nb = nanobind;

/// How many each call uses; 0: all of the machine.
/// @throws nb::value_error below 0
void set_threads(int threads);
[[nodiscard]] int threads();
/// @param limit of each call: bytes, or text as in 8GiB; nothing: none
/// @throws nb::value_error, std::invalid_argument for 0 or less, and for other text
void set_memory_limit(const std::optional<std::variant<double, std::string>>& limit);
[[nodiscard]] std::optional<double> memory_limit();

/// While one lives in the main thread, Ctrl-C is noticed by stop_requested(), and raised as
/// KeyboardInterrupt by whoever asks Python for signals afterwards.
class InterruptScope {
public:
    InterruptScope();
    ~InterruptScope();
    InterruptScope(const InterruptScope&) = delete;
    InterruptScope& operator=(const InterruptScope&) = delete;

    [[nodiscard]] static bool stop_requested();

private:
    bool m_is_installed = false;
};

/// Calls a function of Python with the interpreter's lock.
/// @param callback called with stage, done and total; None: progress is not reported
/// @throws nb::type_error for what cannot be called
[[nodiscard]] Progress progress_to(nb::object callback);

/// @throws nb::python_error of KeyboardInterrupt where that is why the work ended early
void raise_pending_signals();

/// By Python's warnings.
void warn(const std::string& warning);

void with_given_threads(const std::function<void()>& work);

/// Does short work without the interpreter's lock, with the threads that were set.
template <class Work>
auto without_lock(Work&& work) {
    const nb::gil_scoped_release unlocked;
    std::optional<std::invoke_result_t<Work>> result;
    with_given_threads([&] { result.emplace(work()); });
    return *std::move(result);
}

/// Does long work, which takes a Progress: as above, and Ctrl-C ends it.
template <class Work>
auto interruptible(const nb::object& callback, Work&& work)
    -> std::invoke_result_t<Work, Progress> {
    using Result = std::invoke_result_t<Work, Progress>;
    const Progress progress = progress_to(callback);
    std::optional<Result> result;
    try {
        const InterruptScope interrupts;
        const nb::gil_scoped_release unlocked;
        with_given_threads([&] { result.emplace(work(progress)); });
    } catch (const Interrupted&) {
        raise_pending_signals();
        throw;
    }
    raise_pending_signals();
    return *std::move(result);
}

}  // namespace taut::python
