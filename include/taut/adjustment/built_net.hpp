// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// A net as it stands, and how well that is known: where turning begins.
struct BuiltNet {
    CableNet net;  ///< with the lengths as identified or set; its nodes are the form that follows
    /// Draws of the unstressed lengths of all edges, one a column (m x draws) [m]; none: limits are
    /// held for the estimate alone.
    Eigen::MatrixXd length_draws;
    std::string no_draws_since;  ///< why there are none, in words
};

/// What an identification found, in the frame of the net whatever that of the survey: lengths as
/// identified, those of adjustable edges as told unless the survey contradicts them, supports and
/// all else as identified; its nodes in equilibrium, its loads those of `net`, self-weight
/// included.
/// @throws std::invalid_argument where these find no equilibrium, or are no net
[[nodiscard]] CableNet net_as_identified(const CableNet& net, std::span<const IdentifiedEdge> edges,
                                         std::span<const UnknownEstimate> unknowns,
                                         std::span<const BoundaryOutlier> boundary_outliers);

/// The same with draws, where they can be relied on and nothing but lengths was unknown.
[[nodiscard]] BuiltNet built_net_of(const CableNet& net, const Identification& identification);

/// Puts the draws of an identification with the net, or why they are of no use.
/// @param turned the net with what was turned, as told
/// @param unknowns besides lengths of interior edges
/// @throws std::invalid_argument where draws leave an edge no length
void add_draws(BuiltNet& built, const CableNet& turned, const PosteriorDraws& draws,
               std::span<const UnknownEstimate> unknowns);

}  // namespace taut
