// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "taut/adjustment/form_target.hpp"

namespace taut::app {

/// The target form, as given.
struct TargetOptions {
    std::string target;  ///< a form or a surface; empty: the nodes of the net
    std::string unit = "m";
    std::string weights;
    std::string node_weights;  ///< file
    std::string objective = "rms";

    void add_to(CLI::App& command);

    /// Warns of triangles of a surface that are not used, and of nodes outside its border.
    /// @throws InputError, std::invalid_argument
    [[nodiscard]] FormTarget read(const CableNet& net) const;

private:
    [[nodiscard]] FormTarget read_places(const CableNet& net) const;
};

}  // namespace taut::app
