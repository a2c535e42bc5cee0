// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Imbalance of a form for given lengths and loads.
struct TAUT_CORE_EXPORT Imbalance {
    double largest = 0.0;  ///< out-of-balance force at a free node, |h_s| [N]
    /// Over the taut cables; where none is taut, the mean size of the forces of struts [N].
    double mean_tension = 0.0;

    /// largest / mean_tension; infinite if forces act and no edge is taut.
    [[nodiscard]] double share() const;
};

/// The imbalance of a form with these lengths.
/// @param unstressed_lengths l_0 of all edges (m) [m]
/// @param form coordinates of all nodes (3 x n) [m]
/// @throws std::invalid_argument as out_of_balance_forces()
[[nodiscard]] TAUT_CORE_EXPORT Imbalance
imbalance_of(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
             const Eigen::Ref<const Points>& form);

}  // namespace taut
