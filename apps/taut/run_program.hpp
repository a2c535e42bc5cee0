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
    using Commands = std::vector<void (*)(CLI::App&)>;  ///< functions that add one each

    std::string name;           ///< as it is called
    Commands commands;          ///< those that the help shows first, in this order
    Commands further_commands;  ///< those that it shows under a heading of their own
    /// Prints how a run ended.
    /// @param code 0, or that of the failure
    /// @param message one line; empty where code is 0
    /// @return the exit code
    int (*end)(int code, std::string_view message) noexcept = nullptr;
};

/// Runs the command that the arguments name. What it throws becomes one line.
/// @return what Program::end gives
[[nodiscard]] int run_program(const Program& program, int argc, char** argv) noexcept;

}  // namespace taut::app
