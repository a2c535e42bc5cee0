// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/linearised_statics.hpp"
#include "estimation/observations.hpp"
#include "estimation/prior_knowledge.hpp"
#include "taut/identification/parameter_estimate.hpp"

namespace taut {

/// The net with all lengths unknown, where those of adjustable edges are, or where each edge has a
/// stiffness of its own, which acts as a length; else the net itself. docs/theory.md, (uncertain-parameters).
[[nodiscard]] CableNet net_to_fit(const CableNet& net,
                                  const std::vector<UncertainParameter>& uncertain);

/// Of the lengths of adjustable edges as these uncertain tell them (m), 0 for other edges; positive
/// where they are as good as known, too [m].
[[nodiscard]] Eigen::VectorXd adjustable_stds(const CableNet& net,
                                              const std::vector<UncertainParameter>& uncertain);

/// Everything that is told besides net and survey, of the net to fit.
/// @param stds of edges (m) whose lengths follow a normal prior of their own, where the net to fit
/// has
///   them unknown; 0: they follow the prior [m]
[[nodiscard]] PriorKnowledge knowledge_of(const CableNet& fit_net, const LengthPrior& prior,
                                          const std::vector<UncertainParameter>& uncertain,
                                          const Forces& forces, const Eigen::VectorXd& stds);

/// All uncertain of a net after a fit, in the order in which they were told.
/// @param statics linearised and inverted at the fit, of the net to fit
/// @param sites with the prior that the fit was made with
[[nodiscard]] std::vector<ParameterEstimate> parameter_estimates(const CableNet& net,
                                                                 const PriorKnowledge& knowledge,
                                                                 const LinearisedStatics& statics,
                                                                 const Observations& sites,
                                                                 const Iterate& fitted);

}  // namespace taut
