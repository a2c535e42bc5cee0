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

/// A net as it stands, and how well that is known: the start of a plan.
struct BuiltNet {
    CableNet net;  ///< with the estimated lengths; its nodes are in equilibrium
    /// Posterior samples of the unstressed lengths of all edges (m x draws) [m]. Without samples a
    /// plan keeps its limits for the estimate alone.
    Eigen::MatrixXd length_draws;
    /// How each sample differs from `net` besides lengths; empty: in nothing.
    std::vector<ModelPerturbation> perturbations;
    std::string no_draws_because;  ///< why there are no samples, in words
    /// Why the identification failed its checks, and what to do about it; empty where it passed.
    std::string failed_because;
    /// Unstressed lengths by what turnbuckles show: neither what slid to adjustable edges nor the
    /// small errors that were estimated (m); empty: those of `net` [m].
    Eigen::VectorXd shown_lengths = {};
};

/// The net with all that an identification estimated: lengths, uncertain parameters, boundary
/// outliers. Lengths of adjustable edges are as given unless the survey contradicts them. The nodes
/// are in equilibrium, in the frame of `net`; its loads include its self-weight. Runs slide from
/// where they were found, with CableRun::likely_friction where none is given. Without
/// samples.
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

/// net_as_identified() with the posterior samples, where these are reliable.
/// @param net as designed: the identification holds what was turned since
/// @param identification of this net, which is not checked
/// @throws std::invalid_argument as net_as_identified() and add_draws()
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT BuiltNet built_net_of(const CableNet& net,
                                                           const Identification& identification);

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
