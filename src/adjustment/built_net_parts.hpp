// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "taut/adjustment/built_net.hpp"
#include "taut/export/adjustment.hpp"

namespace taut {

/// built_net_of() without samples.
/// @param net with what was turned since: turned_net()
/// @param edges, uncertain, boundary_outliers of an identification of this net; their indices are
///   not checked
/// @throws std::invalid_argument where these find no equilibrium, or are no net (NetError)
/// @throws std::out_of_range for an uncertain parameter of a group that the net does not have
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT BuiltNet
net_as_identified(const CableNet& net, std::span<const IdentifiedEdge> edges,
                  std::span<const ParameterEstimate> uncertain,
                  std::span<const BoundaryOutlier> boundary_outliers);

/// Length of an edge less that of the design; of an adjustable one as its turnbuckle shows it: what
/// was turned since, and a gross error that was found [m].
[[nodiscard]] inline double turned_from_design(const CableNet& designed, const BuiltNet& built,
                                               int edge) {
    const Eigen::VectorXd& lengths =
        built.shown_lengths.size() > 0 ? built.shown_lengths : built.net.unstressed_lengths();
    return lengths(edge) - designed.unstressed_lengths()(edge);
}

/// The worst finding of a failed identification and its remedy, for BuiltNet::failed_because; empty
/// where it did not fail.
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::string failure_of(const Trust& trust);

/// Adds the posterior samples of an identification to the net, or the reason why they are unusable.
/// @param built gets the samples, or the reason
/// @param turned the net with what was turned, as given
/// @param draws of this net; their sizes are not checked
/// @param uncertain of the identification: samples of an older version hold lengths alone
/// @throws std::invalid_argument for samples in which an edge has no positive length
TAUT_ADJUSTMENT_EXPORT void add_draws(BuiltNet& built, const CableNet& turned,
                                      const PosteriorDraws& draws,
                                      std::span<const ParameterEstimate> uncertain);

}  // namespace taut
