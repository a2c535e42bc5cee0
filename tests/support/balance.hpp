// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/net/cable_net.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/tensions.hpp"

namespace taut::test {

/// Largest norm of an out-of-balance force at a node [N].
inline double largest_imbalance(const CableNet& net, const Eigen::VectorXd& lengths,
                                const Points& form) {
    const Eigen::VectorXd forces = out_of_balance_forces(net, lengths, form);
    return forces.reshaped(3, net.free_node_count()).colwise().norm().maxCoeff();
}

/// Mean tension of the taut edges; 0 where all are slack [N].
inline double mean_tension(const CableNet& net, const Eigen::VectorXd& lengths,
                           const Points& form) {
    const Eigen::VectorXd tension = tensions(net, lengths, form);
    const auto taut_count = (tension.array() > 0.0).count();
    return taut_count > 0 ? tension.sum() / static_cast<double>(taut_count) : 0.0;
}

/// Largest distance of a node between two forms [m].
inline double largest_distance(const Points& a, const Points& b) {
    return (a - b).colwise().norm().maxCoeff();
}

}  // namespace taut::test
