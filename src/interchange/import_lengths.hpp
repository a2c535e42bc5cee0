// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/interchange/net_import.hpp"

namespace taut {

/// What makes edges of the lines of a structure.
struct ImportedLengths {
    Eigen::VectorXd axial_stiffness;       ///< [N]
    std::vector<TensionLaw> tension_laws;  ///< as in CableNetData
    std::vector<int> tension_law;
    Eigen::VectorXd unstressed;    ///< [m]
    double force_unit = 1.0;       ///< [N]
    std::vector<bool> is_pressed;  ///< whether the file has each edge in compression
    Eigen::VectorXd sag_weight;    ///< as in CableNetData; empty if no cable sags [N/m]
};

/// Axial stiffnesses, the file's unit of force and unstressed lengths. The report says what was
/// taken from where.
/// @throws InputError and std::invalid_argument as import_net()
[[nodiscard]] ImportedLengths import_lengths(const ImportedStructure& structure,
                                             const ImportSettings& settings, ImportReport& report);

}  // namespace taut
