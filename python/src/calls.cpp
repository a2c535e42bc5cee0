// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "calls.hpp"

#include <atomic>
#include <csignal>
#include <memory>
#include <string>
#include <utility>

#include "taut/memory.hpp"
#include "taut/net/units.hpp"
#include "taut/threads.hpp"

namespace taut::python {
namespace {

std::atomic<int> given_threads = 0;
std::atomic<double> given_memory = 0.0;  ///< [bytes]; 0: any

/// One process has one handler of a signal.
std::atomic<bool> was_interrupted = false;
PyOS_sighandler_t pythons_handler = nullptr;

void on_interrupt(int signal) {
    was_interrupted = true;
    pythons_handler(signal);  // it notes the signal, and Python raises it when it runs again
}

bool is_main_thread() {
    const nb::object threading = nb::module_::import_("threading");
    return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

}  // namespace

void set_threads(int threads) {
    if (threads < 0) {
        throw nb::value_error(
            ("threads: got " + std::to_string(threads) + ", expected 0 (all) or more").c_str());
    }
    given_threads = threads;
}

int threads() {
    return given_threads;
}

void set_memory_limit(const std::optional<std::variant<double, std::string>>& limit) {
    if (!limit) {
        given_memory = 0.0;
        return;
    }
    const auto* const text = std::get_if<std::string>(&*limit);
    const double bytes = text != nullptr ? parse_memory(*text) : std::get<double>(*limit);
    if (!(bytes > 0.0)) {
        throw nb::value_error("limit: expected more than 0 bytes, or None");
    }
    given_memory = bytes;
}

std::optional<double> memory_limit() {
    const double bytes = given_memory;
    return bytes > 0.0 ? std::optional(bytes) : std::nullopt;
}

InterruptScope::InterruptScope() {
    // Python takes signals in its main thread alone.
    if (!is_main_thread()) {
        return;
    }
    was_interrupted = false;
    const PyOS_sighandler_t before = PyOS_getsig(SIGINT);
    if (before == SIG_IGN || before == SIG_DFL || before == SIG_ERR || before == on_interrupt) {
        return;
    }
    pythons_handler = before;
    PyOS_setsig(SIGINT, on_interrupt);
    m_is_installed = true;
}

InterruptScope::~InterruptScope() {
    if (m_is_installed) {
        PyOS_setsig(SIGINT, pythons_handler);
        was_interrupted = false;
    }
}

bool InterruptScope::stop_requested() {
    return was_interrupted;
}

Progress progress_to(nb::object callback) {
    if (!callback.is_none() && PyCallable_Check(callback.ptr()) == 0) {
        throw nb::type_error(("progress: got " +
                              nb::cast<std::string>(callback.type().attr("__name__")) +
                              ", expected a function of stage, done and total")
                                 .c_str());
    }
    Progress progress{.report = {}, .stop_requested = InterruptScope::stop_requested};
    if (callback.is_none()) {
        return progress;
    }
    // Copies of a std::function are made and destroyed without the interpreter's lock, which the
    // last one has to take.
    const std::shared_ptr<nb::object> shared(new nb::object(std::move(callback)),
                                             [](nb::object* held) {
                                                 const nb::gil_scoped_acquire locked;
                                                 delete held;
                                             });
    progress.report = [shared](std::string_view stage, int done, int total) {
        const nb::gil_scoped_acquire locked;
        (*shared)(std::string(stage), done, total);
    };
    return progress;
}

void raise_pending_signals() {
    if (PyErr_CheckSignals() != 0) {
        throw nb::python_error();
    }
}

void warn(const std::string& warning) {
    nb::module_::import_("warnings").attr("warn")(warning, nb::arg("stacklevel") = 2);
}

void with_given_threads(const std::function<void()>& work) {
    std::function<void()> within = work;
    if (const double bytes = given_memory; bytes > 0.0) {
        within = [&, bytes] { with_memory(bytes, work); };
    }
    if (const int threads = given_threads; threads > 0) {
        with_threads(threads, within);
    } else {
        within();
    }
}

}  // namespace taut::python
