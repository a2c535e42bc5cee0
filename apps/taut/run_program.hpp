// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace taut::app {

/// What a program is made of.
struct Program {
    std::string name;                           ///< as it is called
    std::vector<void (*)(CLI::App&)> commands;  ///< what adds each, in the order of the help
    /// Tells how a run ended, and gives the exit code.
    /// @param code 0, or that of the failure, @param message one line; empty where code is 0
    int (*end)(int code, std::string_view message) noexcept = nullptr;
};

/// Runs the command that the arguments name. Whatever it throws is told.
/// @return what Program::end gives
[[nodiscard]] int run_program(const Program& program, int argc, char** argv) noexcept;

}  // namespace taut::app
