// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "taut/export/adjustment.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// What the tension of each edge must keep to (m each) [N].
struct TAUT_ADJUSTMENT_EXPORT TensionLimits {
    Eigen::VectorXd lower;  ///< at least 0: no edge may go slack
    Eigen::VectorXd upper;  ///< may be infinite

    /// No edge slack, and no more.
    [[nodiscard]] static TensionLimits no_slack(const CableNet& net);
};

/// The force with which each support of a group is pulled must not exceed a limit.
struct ReactionLimit {
    std::string name;           ///< for messages
    std::vector<int> supports;  ///< nodes
    double upper = 0.0;         ///< [N]
};

/// Loads that come later (wet concrete, say), and the limits then.
struct LoadCase {
    std::string name;       ///< as LimitBreach::load_case tells it
    Points loads;           ///< 3 x n, in place of the net's [N]
    TensionLimits tension;  ///< under these loads
};

/// What forces must keep to under one set of loads: the tensions of all edges (m), then the
/// reactions of the supports of all reaction limits [N].
struct TAUT_ADJUSTMENT_EXPORT ForceRange {
    Eigen::VectorXd lower;  ///< of reactions -infinite
    Eigen::VectorXd upper;  ///< may be infinite

    /// Sum of what forces are beyond [N].
    /// @param forces as many as limits, not checked
    [[nodiscard]] double violation(const Eigen::Ref<const Eigen::VectorXd>& forces) const;
};

/// What turning must keep to.
struct TAUT_ADJUSTMENT_EXPORT Limits {
    /// Of the edges that may be turned (k each): change of the unstressed length from where it
    /// stands now [m].
    Eigen::VectorXd shortest_stroke;
    Eigen::VectorXd longest_stroke;        ///< 0 or more, likewise (k) [m]
    TensionLimits tension;                 ///< under the net's own loads
    std::vector<ReactionLimit> reactions;  ///< under the net's own loads, and under later ones
    std::vector<LoadCase> load_cases;      ///< each with its own limits of tensions

    /// Whether more is limited than strokes, and that no edge goes slack under the net's own loads.
    [[nodiscard]] bool has_forces() const;
};

/// Strokes of at most `stroke` either way, and no edge slack.
/// @param edges how many may be turned
/// @param stroke 0 or more; check_limits() looks [m]
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT Limits limits_of_stroke(const CableNet& net, size_t edges,
                                                             double stroke);

/// Whether turning can keep to limits.
/// @param edges that may be turned, indices of the net: not checked
/// @throws std::invalid_argument for limits of wrong size or not numbers, a lower one not
///   below its upper, a range of strokes without 0 or that leaves an edge a tenth of its length or
///   less, a reaction limit that is not positive or of a node that is no support
TAUT_ADJUSTMENT_EXPORT void check_limits(const CableNet& net, const std::vector<int>& edges,
                                         const Limits& limits);

}  // namespace taut
