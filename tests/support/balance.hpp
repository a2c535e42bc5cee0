// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/net/cable_net.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/imbalance.hpp"
#include "taut/statics/tensions.hpp"

namespace taut::test {

/// Largest norm of an out-of-balance force at a node [N].
inline double largest_imbalance(const CableNet& net, const Eigen::VectorXd& lengths,
                                const Points& form) {
    return imbalance_of(net, lengths, form).largest;
}

/// Mean tension of the taut edges; 0 if all are slack [N].
inline double mean_tension(const CableNet& net, const Eigen::VectorXd& lengths,
                           const Points& form) {
    return imbalance_of(net, lengths, form).mean_tension;
}

/// Largest distance of a node between two forms [m].
inline double largest_distance(const Points& a, const Points& b) {
    return (a - b).colwise().norm().maxCoeff();
}

}  // namespace taut::test
