// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "taut/estimation/prior_estimate.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_prior.hpp"

namespace taut {

/// What length deviations have in common, after the survey: d = e + G b, with e independent under
/// their prior and b normal. b holds the mean of all, the relative length of each run of cable, and
/// what all struts and all adjustable edges are longer. To first order, docs/theory.md
/// (length-trend).
struct LengthTrend {
    Eigen::MatrixXd columns;     ///< G, m_I x r: of one standard deviation of the prior each [m]
    Eigen::VectorXd prior_stds;  ///< of b before the survey, root mean square of the mixture's, as
                                 ///< the survey weights it (r)
    Eigen::VectorXd mean;        ///< of b (r)
    Eigen::MatrixXd root;        ///< R, r x r: R R' is the covariance of b
    Eigen::MatrixXd length_gains;  ///< d of the estimated lengths by b, m_I x r [m]
    Eigen::MatrixXd common_gains;  ///< the same of the common parameters, in their std
    double adjustable_std = 0.0;   ///< prior std of what adjustable edges have in common [m]
    CommonDeviation found;

    [[nodiscard]] bool empty() const { return columns.cols() == 0; }
};

/// The trend that a fit without one shows.
/// @param left_out interior edges (m_I) of another prior
/// @param adjustable_stds prior standard deviation of uncertain lengths of adjustable edges, else
///   0 (m_I) [m]
[[nodiscard]] LengthTrend trend_of(const LinearisedFit& fitted, const Observations& observations,
                                   const std::vector<bool>& left_out,
                                   const Eigen::VectorXd& adjustable_stds,
                                   const LengthPrior& prior);

}  // namespace taut
