// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "taut/export/adjustment.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Limits of the tension of each edge (m each) [N].
struct TAUT_ADJUSTMENT_EXPORT TensionLimits {
    /// Of a cable at least 0: it may not go slack. Of a strut any, or -infinite.
    Eigen::VectorXd lower;
    Eigen::VectorXd upper;  ///< may be infinite

    /// No cable may go slack and no strut buckle, and no upper limit.
    [[nodiscard]] static TensionLimits no_slack(const CableNet& net);
};

/// Upper limit of the force with which the net pulls at each support of a group.
struct ReactionLimit {
    std::string name;           ///< for messages
    std::vector<int> supports;  ///< nodes
    double upper = 0.0;         ///< [N]
};

/// Later loads (wet concrete, say), and the limits under them.
struct LoadCase {
    std::string name;       ///< for LimitBreach::load_case
    Points loads;           ///< 3 x n, in place of the net's [N]
    TensionLimits tension;  ///< under these loads
};

/// How far an edge may be turned from where it is.
struct StrokeRange {
    int edge = 0;           ///< index in the net
    double shortest = 0.0;  ///< 0 or less [m]
    double longest = 0.0;   ///< 0 or more [m]
};

/// A limit of tension: a force, or a part of the breaking load of each edge.
struct TensionBound {
    double value = 0.0;    ///< [N], or the part, 0 to 1
    bool is_part = false;  ///< whether it is a part
};

/// Limits of the tension of all edges, or of a group. A bound that is not given is left as it is.
struct TensionRange {
    std::optional<TensionBound> least = {};  ///< 0 or more; of a group of struts any force
    std::optional<TensionBound> most = {};   ///< above `least`
    std::optional<std::string> group = {};   ///< of edges of the net; empty: all cables
};

/// Upper limit of the force at all supports, or at those of a group of edges.
struct ReactionBound {
    double upper = 0.0;                     ///< [N]
    std::optional<std::string> group = {};  ///< of edges of the net; empty: all supports
};

/// Loads that come on top of the net's own later.
struct AddedLoads {
    std::string name;  ///< for LimitBreach::load_case
    Points loads;      ///< 3 x n [N]
};

/// Limits of all forces under one set of loads: the tensions of all edges (m), then the reactions
/// of the supports of all reaction limits [N].
struct TAUT_ADJUSTMENT_EXPORT ForceRange {
    Eigen::VectorXd lower;  ///< -infinite for reactions
    Eigen::VectorXd upper;  ///< may be infinite

    /// Sum of the excesses over the limits [N].
    /// @param forces as many as limits, not checked
    [[nodiscard]] double violation(const Eigen::Ref<const Eigen::VectorXd>& forces) const;
};

/// What a plan must keep to.
struct TAUT_ADJUSTMENT_EXPORT Limits {
    /// Of the adjustable edges (k): lower limit of the change of the unstressed length from now on,
    /// 0 or less [m].
    Eigen::VectorXd shortest_stroke;
    Eigen::VectorXd longest_stroke;        ///< its upper limit, 0 or more (k) [m]
    TensionLimits tension;                 ///< under the net's own loads
    std::vector<ReactionLimit> reactions;  ///< under the net's own loads, and under later ones
    std::vector<LoadCase> load_cases;      ///< each with its own limits of tensions

    /// Whether there are limits other than strokes and no slack cable under the net's own loads.
    /// @param net that the limits are of, not checked
    [[nodiscard]] bool has_forces(const CableNet& net) const;
};

/// Strokes of at most `stroke` either way, and no edge slack.
/// @param edges that may be turned
/// @param stroke 0 or more; checked by check_limits() [m]
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT Limits stroke_limits(const CableNet& net,
                                                          const std::vector<int>& edges,
                                                          double stroke);

/// Checks that limits are consistent.
/// @param edges that may be turned, indices of the net: not checked
/// @throws std::invalid_argument for limits of wrong size or not numbers, a lower limit not below
///   its upper, a range of strokes without 0 or that leaves an edge a tenth of its length or less,
///   a reaction limit that is not positive or of a node that is no support
TAUT_ADJUSTMENT_EXPORT void check_limits(const CableNet& net, const std::vector<int>& edges,
                                         const Limits& limits);

}  // namespace taut
