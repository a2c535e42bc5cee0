// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <map>
#include <vector>

#include "taut/gp/fit.hpp"

namespace taut::gp {

/// What outputs are to be learnt, and where their lambda is looked for.
struct LambdaSearchSettings {
    double lower_log_lambda;
    double upper_log_lambda;
    NoiseRatioBounds noise_ratio;
    double relative_tolerance;  ///< FitSettings
    int max_spectra;            ///< FitSettings
};

/// What is best for one output among the lambdas looked at.
struct BestLambda {
    double log_lambda = 0.0;
    double value = std::numeric_limits<double>::infinity();  ///< negative log likelihood
    double noise_ratio = 0.0;
    double signal_variance = 0.0;
};

/// Takes what was seen of some outputs at one lambda, where it is better.
/// @param profile of these outputs, in their order
void keep_better(std::vector<BestLambda>& best, double log_lambda,
                 const std::vector<Eigen::Index>& outputs, const LikelihoodProfile& profile);

/// What a search found: the best of each output, and the spectra that these are of, by log lambda.
struct FoundLambdas {
    std::vector<BestLambda> best;
    std::map<double, KernelSpectrum> spectra;

    /// Drops the spectra that are the best of no output.
    void forget_unused();
};

/// Looks for the lambda of each output, by a decomposition of the correlation matrix at each lambda
/// looked at.
/// @param squared_distances of all pairs of training inputs (n x n)
/// @param outputs n x m, none of them zero throughout; m >= 1
/// @throws Interrupted where a stop was requested
[[nodiscard]] FoundLambdas search_lambdas(const Eigen::MatrixXd& squared_distances,
                                          const Eigen::MatrixXd& outputs,
                                          const LambdaSearchSettings& settings,
                                          const Progress& progress);

}  // namespace taut::gp
