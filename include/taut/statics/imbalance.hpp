// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/net/cable_net.hpp"

namespace taut {

/// How far a form is from the equilibrium of its lengths and loads.
struct Imbalance {
    double largest = 0.0;       ///< out-of-balance force at a free node, |h_s| [N]
    double mean_tension = 0.0;  ///< over the taut edges; 0 where all are slack [N]

    /// largest / mean_tension; infinite where forces act and no edge is taut.
    [[nodiscard]] double share() const;
};

/// @param form coordinates of all nodes (3 x n) [m]
/// @throws std::invalid_argument as out_of_balance_forces()
[[nodiscard]] Imbalance imbalance(const CableNet& net,
                                  const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                  const Eigen::Ref<const Points>& form);

}  // namespace taut
