// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "taut/adjustment/form_target.hpp"

namespace taut::app {

/// What a form is to come near, as it was told.
struct TargetOptions {
    std::string target;  ///< a form or a surface; empty: the nodes of the net
    std::string unit = "m";
    std::string weights;
    std::string node_weights;  ///< file
    std::string objective = "rms";

    void add_to(CLI::App& command);

    /// Says on standard error what of a surface is left out, and which nodes are beyond its border.
    /// @throws InputError, std::invalid_argument
    [[nodiscard]] FormTarget read(const CableNet& net) const;

private:
    [[nodiscard]] FormTarget read_places(const CableNet& net) const;
};

}  // namespace taut::app
