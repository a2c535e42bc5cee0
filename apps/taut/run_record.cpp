// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "run_record.hpp"

#include <fmt/chrono.h>
#include <fmt/core.h>

#include <ctime>
#include <string_view>

namespace taut::app {
namespace {

std::string& command_line() {
    static std::string line;
    return line;
}

std::string quoted(std::string_view word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=+.,:/@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos) {
        return std::string(word);
    }
    std::string result = "'";
    for (const char c : word) {
        if (c == '\'') {
            result += R"('\'')";
        } else {
            result += c;
        }
    }
    result += '\'';
    return result;
}

}  // namespace

void remember_command_line(int argc, const char* const* argv) {
    command_line() = "taut";
    for (int i = 1; i < argc; ++i) {
        command_line() += ' ';
        command_line() += quoted(argv[i]);
    }
}

RunRecord run_record() {
    return {.date = fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr))),
            .command = command_line()};
}

}  // namespace taut::app
