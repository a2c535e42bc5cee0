// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/identification/posterior_draws.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The interval ends at the order statistics of rank p (draws + 1), p = 0.025 and 0.975: so another
/// draw of the same posterior falls within with 95 %, however few there are, docs/theory.md
/// (drawn).
/// @param values one a draw, at least two, which is not checked
[[nodiscard]] TAUT_CORE_EXPORT DrawnEstimate
estimate_of(const Eigen::Ref<const Eigen::VectorXd>& values);

/// The same of the tension of an edge: a cable's is never below 0.
[[nodiscard]] TAUT_CORE_EXPORT DrawnEstimate
tension_of(const CableNet& net, int edge, const Eigen::Ref<const Eigen::VectorXd>& forces);

/// What tensions and missing nodes follow from draws.
/// @param draws at least two, not checked
/// @param missing free nodes of the net, not checked
[[nodiscard]] TAUT_CORE_EXPORT DrawnSummary summary_of(const PosteriorDraws& draws,
                                                       const CableNet& net,
                                                       const std::vector<int>& missing);

}  // namespace taut
