// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/LU>

#include "taut/sampling/length_prior.hpp"
#include "taut/statics/form_sensitivity.hpp"
#include "taut/survey/survey.hpp"

namespace taut::test {

/// (J' S J + I / prior.std_dev()^2)^-1, the textbook's posterior covariance of the interior lengths
/// (m_I x m_I) of a linear model, dense: J is dr/dl at a form, S the weights of what was surveyed.
inline Eigen::MatrixXd dense_posterior(const CableNet& net, const Eigen::VectorXd& lengths,
                                       const Points& form, const Survey& survey,
                                       const LengthPrior& prior) {
    const Eigen::MatrixXd J = FormSensitivity(net, lengths, form).columns(net.interior_edges());
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(J.rows());
    for (const int node : survey.surveyed) {
        weights.segment<3>(Eigen::Index{3} * net.free_index(node)) =
            survey.noise_std.col(node).cwiseAbs2().cwiseInverse();
    }
    Eigen::MatrixXd precision = J.transpose() * weights.asDiagonal() * J;
    precision.diagonal().array() += 1.0 / (prior.std_dev() * prior.std_dev());
    return precision.inverse();
}

}  // namespace taut::test
