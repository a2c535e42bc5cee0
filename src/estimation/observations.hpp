// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/net/cable_net.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// What is known of form and lengths apart from the statics: independent normal distributions.
/// docs/theory.md, (observation) and (prior).
struct Observations {
    Points form;               ///< 3 x n, as measured; anything where the weight is 0 [m]
    Points weights;            ///< 3 x n, 1 / variance of each measured coordinate, else 0 [1/m2]
    Eigen::VectorXd mean;      ///< m_I, prior mean of the length deviations [m]
    Eigen::VectorXd variance;  ///< m_I, prior variance, positive [m2]
};

/// A form and length deviations that need not be in equilibrium.
struct Iterate {
    Points form;                 ///< 3 x n [m]
    Eigen::VectorXd deviations;  ///< m_I [m]
};

/// The nominal form and no length deviation.
[[nodiscard]] Iterate nominal_iterate(const CableNet& net);

/// Standard deviation of each coordinate (3 x n), no smaller than a ten millionth of the net's mean
/// edge length, which stands for that of an exact one: far above rounding errors, far below any
/// instrument's, and no harder on the factorisation than it bears [m].
[[nodiscard]] Points with_noise_floor(const CableNet& net, const Survey& survey);

/// A survey without the targets that are rejected (one flag a node), and length deviations of mean
/// zero and one standard deviation.
[[nodiscard]] Observations observe(const CableNet& net, const Survey& survey, const Points& noise,
                                   const std::vector<bool>& rejected, double length_std);

}  // namespace taut
