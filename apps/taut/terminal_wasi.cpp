// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// WebAssembly has one thread and no signals: whoever runs it ends it from outside.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "memory_limit.hpp"
#include "terminal.hpp"

namespace taut::app {

void prepare_streams() {}

void take_last_word() noexcept {}

void end_without_memory() {
    const std::string_view note = memory_limit_note();
    std::fprintf(stderr, "taut: error: not enough memory%.*s\n", static_cast<int>(note.size()),
                 note.data());
    leave(numerical_failure);
}

std::filesystem::path program_file() {
    return {};
}

void leave(int code) {
    std::fflush(nullptr);
    std::_Exit(code);
}

/// Lines of progress are asked for by the variable TAUT_PROGRESS, which whoever shows them sets.
bool is_watched() {
    return !is_silent() && std::getenv("TAUT_PROGRESS") != nullptr;
}

void Interruption::watch() {}

bool Interruption::is_requested() {
    return false;
}

std::function<bool()> Interruption::stop_request() {
    return [] { return false; };
}

}  // namespace taut::app
