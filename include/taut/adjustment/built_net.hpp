// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
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
/// outliers; and with the posterior samples, where these are reliable. Lengths of adjustable edges
/// are as given unless the survey contradicts them. The nodes are in equilibrium, in the frame of
/// `net`; its loads include its self-weight. Runs slide from where they were found, with
/// CableRun::likely_friction where none is given.
/// @param net as designed: the identification holds what was turned since
/// @param identification of this net, which is not checked
/// @throws std::invalid_argument where these find no equilibrium, or are no net (NetError), and for
///   samples in which an edge has no positive length
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT BuiltNet built_net_of(const CableNet& net,
                                                           const Identification& identification);

}  // namespace taut
