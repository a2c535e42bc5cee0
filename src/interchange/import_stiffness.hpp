// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "taut/interchange/net_import.hpp"

namespace taut {

/// Axial stiffnesses or tension laws of the edges, and how they came about, in words.
struct ImportedStiffness {
    Eigen::VectorXd values;  ///< [N], or in the file's unit of force, see in_force_unit
    bool in_force_unit = false;
    std::string source;
    std::vector<TensionLaw> laws;  ///< one a diameter
    std::vector<int> law_of_edge;  ///< as CableNetData::tension_law

    /// Tension over strain of an edge.
    /// @param force_unit of the file [N]
    [[nodiscard]] double tension(Eigen::Index edge, double strain, double force_unit) const;
    /// The strain at a tension.
    [[nodiscard]] double strain(Eigen::Index edge, double tension, double force_unit) const;
};

/// From the settings, else from the file's EA, else from its E [GPa] and r [m].
/// @throws InputError where neither gives one, or a diameter is missing or not positive
/// @throws std::invalid_argument for settings that are not positive, or exclude each other
[[nodiscard]] ImportedStiffness stiffness_of(const ImportedStructure& structure,
                                             const ImportSettings& settings);

}  // namespace taut
