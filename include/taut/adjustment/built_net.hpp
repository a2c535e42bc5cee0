// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "taut/export/adjustment.hpp"
#include "taut/identification/result.hpp"
#include "taut/identification/trust.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/model_perturbation.hpp"

namespace taut {

/// A net as it stands, and how well that is known: where turning begins.
struct BuiltNet {
    CableNet net;  ///< with the lengths as identified or set; its nodes are the form that follows
    /// Draws of the unstressed lengths of all edges, one a column (m x draws) [m]; none: limits are
    /// held for the estimate alone.
    Eigen::MatrixXd length_draws;
    /// What else differs from `net` in each draw, but for lengths; none: nothing does.
    std::vector<ModelPerturbation> perturbations;
    std::string no_draws_since;  ///< why there are none, in words
    /// Why the identification failed its tests, and what to do about it; empty where it did not.
    std::string failed_since;
};

/// What an identification found, in the frame of the net whatever that of the survey: lengths as
/// identified, those of adjustable edges as told unless the survey contradicts them, supports and
/// all else as identified; its nodes in equilibrium, its loads those of `net`, self-weight
/// included.
/// @param net with what was turned since: turned_net()
/// @param edges, uncertain, boundary_outliers of an identification of this net; their indices are
///   not checked
/// @throws std::invalid_argument where these find no equilibrium, or are no net (NetError)
/// @throws std::out_of_range for an unknown of a group that the net does not have
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT CableNet
net_as_identified(const CableNet& net, std::span<const IdentifiedEdge> edges,
                  std::span<const ParameterEstimate> uncertain,
                  std::span<const BoundaryOutlier> boundary_outliers);

/// What speaks most against a failed identification, and what to do about it, for
/// BuiltNet::failed_since; empty where it did not fail.
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::string failure_of(const Trust& trust);

/// The same with draws, where they can be relied on.
/// @param net as designed: what was turned since is in the identification
/// @param identification of this net, which is not checked
/// @throws std::invalid_argument as net_as_identified() and add_draws()
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT BuiltNet built_net_of(const CableNet& net,
                                                           const Identification& identification);

/// Puts the draws of an identification with the net, or why they are of no use.
/// @param built gets the draws, or the reason
/// @param turned the net with what was turned, as told
/// @param draws of this net, whose sizes are not checked
/// @param uncertain of the identification: draws of an older version hold lengths alone
/// @throws std::invalid_argument where draws leave an edge no length
TAUT_ADJUSTMENT_EXPORT void add_draws(BuiltNet& built, const CableNet& turned,
                                      const PosteriorDraws& draws,
                                      std::span<const ParameterEstimate> uncertain);

}  // namespace taut
