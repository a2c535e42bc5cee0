// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "estimation/observations.hpp"
#include "estimation/statics_model.hpp"
#include "numerics/random_numbers.hpp"

namespace taut {

/// Observations and priors that agree with an iterate: a step from there only restores balance.
[[nodiscard]] Observations satisfied(const StaticsModel& model, const Observations& observations,
                                     const Iterate& iterate);

/// Independent numbers of the standard normal distribution.
[[nodiscard]] Eigen::VectorXd standard_normals(Eigen::Index count, RandomNumbers& random);

/// (perturbed): observations and priors with new errors.
/// @param blur variances of the additional length deviations, (blurred-law), (own-stiffness) (m_I)
[[nodiscard]] Observations perturbed(const CableNet& net, const Observations& observations,
                                     const Eigen::VectorXd& blur, RandomNumbers& random);

/// (length-trend): draws what the prior means have in common.
[[nodiscard]] Observations with_drawn_mean(const Observations& observations, RandomNumbers& random);

/// The same, given the length deviations (m_I) and their prior variances (m_I), from its
/// conditional distribution.
[[nodiscard]] Observations with_mean_given(const Observations& observations,
                                           const Eigen::VectorXd& variances,
                                           const Eigen::VectorXd& deviations,
                                           RandomNumbers& random);

/// With the few numbers alone that most of what the prior means have in common depends on: the
/// determinant takes a solution for each.
[[nodiscard]] Observations with_leading_means(const Observations& observations);

}  // namespace taut
