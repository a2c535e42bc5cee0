// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "estimation/prior_knowledge.hpp"
#include "taut/identification/result.hpp"

namespace taut {

// A net whose runs slide, docs/theory.md (slips): the fit has lengths as marked and slips, a result
// has the lengths between nodes as they are, and what each stretch from clamp to clamp has.

/// Covariance of the lengths between their nodes of some edges, in their order [m2].
/// @param sites observations of the fit
[[nodiscard]] Eigen::MatrixXd covariance_between_nodes(const LinearisedFit& fitted,
                                                       const Observations& sites,
                                                       const std::vector<int>& edges);

/// Adds what slid to the lengths of edges, and sets the stretches but for their means.
/// @param result with the lengths as marked and the slips of the fit
/// @param net as given, with its lengths as marked
void take_up_slips(Identification& result, const CableNet& net, const PriorKnowledge& knowledge,
                   const LinearisedFit& fitted, const Observations& sites);

/// Sets deviations and tensions of the stretches by those of their edges.
void set_stretch_means(Identification& result, const CableNet& net);

/// "12", or where it slides "12 or another of the cable that slides from 10 to 14": an error of
/// such a cable's length is that of no single edge.
[[nodiscard]] std::string edge_or_cable(const CableNet& net, int edge);

/// Standard deviation of an edge's length between its nodes before the survey [m].
/// @param prior_std of its length as marked [m]
[[nodiscard]] double std_before(const Identification& result, int edge, double prior_std);

}  // namespace taut
