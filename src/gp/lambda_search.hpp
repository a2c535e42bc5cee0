// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <map>
#include <vector>

#include "gp/likelihood_profile.hpp"
#include "numerics/memory_budget.hpp"
#include "taut/gp/fit.hpp"

namespace taut::gp {

/// Range and effort of the search for lambda.
struct LambdaSearchSettings {
    double lower_log_lambda;
    double upper_log_lambda;
    NoiseRatioBounds noise_ratio;
    double relative_tolerance;  ///< FitSettings
    int max_spectra;            ///< FitSettings
};

/// The best of the lambdas tried for one output.
struct BestLambda {
    double log_lambda = 0.0;
    double value = std::numeric_limits<double>::infinity();  ///< negative log likelihood
    double noise_ratio = 0.0;
    double signal_variance = 0.0;
};

/// Replaces the best of some outputs by the values at one lambda, where these are better.
/// @param profile of these outputs, in their order
void keep_better(std::vector<BestLambda>& best, double log_lambda,
                 const std::vector<Eigen::Index>& outputs, const LikelihoodProfile& profile);

/// Result of a search: the best of each output, and their spectra, by log lambda.
struct FoundLambdas {
    std::vector<BestLambda> best;
    std::map<double, KernelSpectrum> spectra = {};
    int decompositions = 0;
    bool is_converged = true;  ///< FittedProcesses
    MemoryCharge charge = {};  ///< of the spectra

    /// Drops the spectra that are the best of no output.
    void forget_unused();
};

/// Searches the lambda of each output, by a decomposition of the correlation matrix at each lambda
/// tried.
/// @param squared_distances of all pairs of training inputs (n x n)
/// @param outputs n x m, none of them zero throughout; m >= 1
/// @throws Interrupted where a stop was requested
[[nodiscard]] FoundLambdas search_lambdas(const Eigen::MatrixXd& squared_distances,
                                          const Eigen::MatrixXd& outputs,
                                          const LambdaSearchSettings& settings,
                                          const Progress& progress);

}  // namespace taut::gp
