// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "estimation/prior_likelihood.hpp"
#include "taut/estimation/diagnostics.hpp"
#include "taut/estimation/prior_estimate.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_prior.hpp"

namespace taut {

/// A distribution over priors: log-normal in the standard deviation of the length deviations, and a
/// probability for each shape. docs/theory.md, (hyperprior)
struct Hyperprior {
    LengthPrior centre;                ///< given, or assumed where none was
    double log_std = 0.0;              ///< standard deviation of the logarithm of the scale
    double uniform_probability = 0.0;  ///< of the uniform shape; the rest is the centre's other
                                       ///< shape, normal or bimodal
};

/// Around a given prior: a factor of 1.5; its own shape with probability 3/4, except that a bimodal
/// one keeps its shape.
[[nodiscard]] Hyperprior hyperprior_around(const LengthPrior& given);
/// Where none is given: a factor of 2.5 around uniform:5mm, both shapes equally likely.
[[nodiscard]] Hyperprior broad_hyperprior();

/// The posterior over priors by their evidence: for the scale that of the linearised fit, for the
/// shape that of its lengths. docs/theory.md, (prior-evidence)
///
/// @param observations of the fit, with a normal prior for each length
/// @param fitted the result of the fit
/// @param left_out interior edges (m_I) of another prior
/// @param fit_prior prior of the fit
/// @param scale of the lengths, by estimate_components()
/// @param shapes likelihood of priors by the same fit
[[nodiscard]] PriorEstimate estimate_prior(const Hyperprior& hyperprior, LinearisedFit fitted,
                                           const Observations& observations,
                                           const std::vector<bool>& left_out,
                                           const LengthPrior& fit_prior, const FoundScale& scale,
                                           const PriorLikelihood& shapes);

/// One prior for an estimate: its most probable shape and its mean standard deviation.
[[nodiscard]] LengthPrior central_prior(const PriorEstimate& estimate);

/// Gauss quadrature of a discrete distribution: integrates polynomials up to degree 2 count - 1 as
/// it does (G. H. Golub & J. H. Welsch, Math. Comp. 23 (1969) 221-230).
/// @param weights at each place, not negative, with a positive sum
/// @return places and weights, which sum to 1; fewer nodes where the distribution has no more
/// places
[[nodiscard]] std::vector<std::pair<double, double>> gauss_nodes(const Eigen::VectorXd& places,
                                                                 const Eigen::VectorXd& weights,
                                                                 int count);

}  // namespace taut
