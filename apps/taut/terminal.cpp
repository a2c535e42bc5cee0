// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "terminal.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <string>

#include "taut/files/printable.hpp"

namespace taut::app {
namespace {

std::atomic<bool> silent{false};

}  // namespace

void be_silent() {
    silent = true;
}

bool is_silent() {
    return silent;
}

void print(std::string_view text) {
    if (silent) {
        return;
    }
    const std::string content = printable(text, "\n\t");
    // The stream remembers where this fails.
    static_cast<void>(std::fwrite(content.data(), 1, content.size(), stdout));
}

bool standard_output_works() {
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

void print_message(std::string_view kind, std::string_view line) noexcept {
    if (silent) {
        return;
    }
    try {
        constexpr size_t longest = 4000;  // bytes: an argument may be far longer
        std::string one_line(line.substr(0, longest));
        one_line += line.size() > longest ? "..." : "";
        std::ranges::replace(one_line, '\n', ' ');
        const std::string content = fmt::format("taut: {}: {}\n", kind, printable(one_line));
        if (kind == "error") {
            take_last_word();
        }
        static_cast<void>(std::fwrite(content.data(), 1, content.size(), stderr));
    } catch (const std::exception&) {
        static_cast<void>(std::fputs("taut: error: not enough memory\n", stderr));
    }
}

void print_in_place(std::string_view line) noexcept {
    static_cast<void>(std::fputs("\r\033[K", stderr));
    static_cast<void>(std::fwrite(line.data(), 1, line.size(), stderr));
    static_cast<void>(std::fflush(stderr));
}

}  // namespace taut::app
