// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "taut/net/cable_net.hpp"

namespace taut {

/// What the tension of each edge must keep to (m each) [N].
struct TensionLimits {
    Eigen::VectorXd lower;  ///< at least 0: no edge may go slack
    Eigen::VectorXd upper;  ///< may be infinite

    /// No edge slack, and no more.
    [[nodiscard]] static TensionLimits no_slack(const CableNet& net);
};

/// The force with which each support of a group is pulled must not exceed a limit.
struct ReactionLimit {
    std::string name;
    std::vector<int> supports;  ///< nodes
    double upper = 0.0;         ///< [N]
};

/// Loads that come later (wet concrete, say), and the limits then.
struct LoadCase {
    std::string name;
    Points loads;  ///< 3 x n, in place of the net's [N]
    TensionLimits tension;
};

/// What forces must keep to: the tensions of all edges (m), then the reactions of the supports of
/// all reaction limits [N].
struct ForceRange {
    Eigen::VectorXd lower;
    Eigen::VectorXd upper;

    /// Sum of what forces are beyond [N].
    [[nodiscard]] double violation(const Eigen::Ref<const Eigen::VectorXd>& forces) const;
};

/// What turning must keep to.
struct Limits {
    /// Of the edges that may be turned (k each): change of the unstressed length from where it
    /// stands now [m].
    Eigen::VectorXd shortest_stroke;
    Eigen::VectorXd longest_stroke;
    TensionLimits tension;
    std::vector<ReactionLimit> reactions;
    std::vector<LoadCase> load_cases;
};

/// Strokes of at most `stroke` either way, and no edge slack.
[[nodiscard]] Limits limits_of_stroke(const CableNet& net, size_t edges, double stroke);

/// @param edges that may be turned
/// @throws std::invalid_argument for limits of wrong size or not numbers, a lower one above its
///   upper, a stroke that leaves an edge without length, no stroke at all, a reaction limit that is
///   not positive or of a node that is no support
void check_limits(const CableNet& net, const std::vector<int>& edges, const Limits& limits);

}  // namespace taut
