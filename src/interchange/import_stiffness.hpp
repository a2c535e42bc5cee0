// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "taut/interchange/net_import.hpp"

namespace taut {

/// Axial stiffnesses of the edges, and how they came about, in words.
struct ImportedStiffness {
    Eigen::VectorXd values;  ///< [N], or in the file's unit of force where so told
    bool in_force_unit = false;
    std::string source;
};

/// From the settings, else from the file's EA, else from its E [GPa] and r [m].
/// @throws InputError where neither gives one, or a diameter is missing or not positive
/// @throws std::invalid_argument for settings that are not positive, or exclude each other
[[nodiscard]] ImportedStiffness stiffness_of(const ImportedStructure& structure,
                                             const ImportSettings& settings);

}  // namespace taut
