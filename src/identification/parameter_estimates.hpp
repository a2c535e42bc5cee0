// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "estimation/prior_knowledge.hpp"
#include "taut/identification/parameter_estimate.hpp"

namespace taut {

/// The net with all lengths to be identified, where those of adjustable edges are uncertain, each
/// edge has a stiffness of its own, which acts as a length, or runs slide; else the net itself.
/// Where runs slide, with the lengths that have slid. docs/theory.md, (uncertain-parameters),
/// (slips).
[[nodiscard]] CableNet net_to_fit(const CableNet& net,
                                  const std::vector<UncertainParameter>& uncertain);

/// Prior standard deviations of the lengths of adjustable edges (m), 0 for other edges; positive
/// even where a length is exact [m].
[[nodiscard]] Eigen::VectorXd adjustable_stds(const CableNet& net,
                                              const std::vector<UncertainParameter>& uncertain);

/// All knowledge besides net and survey, for the net to fit.
/// @param stds of edges (m) with a normal prior of their own; 0: they follow the prior [m]
[[nodiscard]] PriorKnowledge knowledge_of(const CableNet& fit_net, const LengthPrior& prior,
                                          const std::vector<UncertainParameter>& uncertain,
                                          const Forces& forces, const Eigen::VectorXd& stds);

/// Estimates of all uncertain parameters after a fit, in the order given.
/// @param sites observations of the fit
[[nodiscard]] std::vector<ParameterEstimate> parameter_estimates(const CableNet& net,
                                                                 const PriorKnowledge& knowledge,
                                                                 const LinearisedFit& fitted,
                                                                 const Observations& sites);

/// An elastic support that is not where it should stand without load.
struct DisplacedSupport {
    int node = -1;
    double distance = 0.0;  ///< from its place [m]
    double std_dev = 0.0;   ///< the largest of a coordinate [m]
};

/// Elastic supports with a coordinate that its prior does not allow, docs/theory.md
/// (displaced-support). An error of a support's stiffness shows as one, too.
[[nodiscard]] std::vector<DisplacedSupport> displaced_supports(
    const CableNet& net, std::span<const ParameterEstimate> estimates);

}  // namespace taut
