// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "gp/low_rank_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "gp/likelihood_profile.hpp"
#include "gp/low_rank_spectrum.hpp"

namespace taut::gp {
namespace {

/// Lambdas tried on all inputs.
constexpr size_t most_kept = 3;

/// The few lambdas that lose least, one after the other: each time the one with which the best
/// values of all outputs have the least sum.
/// @param values negative log likelihoods of the outputs, by log lambda
std::vector<double> best_few(const std::map<double, Eigen::VectorXd>& values) {
    std::vector<double> kept;
    Eigen::VectorXd best = Eigen::VectorXd::Constant(values.begin()->second.size(),
                                                     std::numeric_limits<double>::max());
    while (kept.size() < std::min(most_kept, values.size())) {
        const auto next = std::ranges::min_element(
            values, {}, [&](const auto& at) { return best.cwiseMin(at.second).mean(); });
        const Eigen::VectorXd with_it = best.cwiseMin(next->second);
        if (with_it == best) {
            break;
        }
        best = with_it;
        kept.push_back(next->first);
    }
    return kept;
}

/// The lambdas that are best for the outputs on a part of the inputs.
/// @param search gets how it went
std::vector<double> log_lambdas_of_part(const Eigen::MatrixXd& squared_distances,
                                        const Eigen::MatrixXd& outputs,
                                        const LambdaSearchSettings& settings, FoundLambdas& search,
                                        const Progress& progress) {
    std::vector<Eigen::Index> usable;  // an output that is constant on the part shows nothing
    for (Eigen::Index j = 0; j < outputs.cols(); ++j) {
        if (outputs.col(j).maxCoeff() > outputs.col(j).minCoeff()) {
            usable.push_back(j);
        }
    }
    if (usable.empty()) {
        return {0.5 * (settings.lower_log_lambda + settings.upper_log_lambda)};
    }
    const Eigen::MatrixXd varying = outputs(Eigen::all, usable);
    const FoundLambdas found = search_lambdas(squared_distances, varying, settings, progress);
    search.decompositions = found.decompositions;
    search.is_converged = found.is_converged;
    std::map<double, Eigen::VectorXd> values;
    for (const auto& [log_lambda, spectrum] : found.spectra) {
        values[log_lambda] = profile_likelihood(spectrum, squared_distances, varying,
                                                settings.noise_ratio, Slope::left_out)
                                 .value;
    }
    return best_few(values);
}

}  // namespace

FoundLambdas search_by_low_rank(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                                const Eigen::MatrixXd& outputs,
                                const std::vector<Eigen::Index>& part,
                                const Eigen::MatrixXd& part_squared_distances,
                                const LambdaSearchSettings& settings, Eigen::Index rank,
                                const Progress& progress) {
    FoundLambdas found{.best = std::vector<BestLambda>(outputs.cols())};
    const std::vector<double> log_lambdas = log_lambdas_of_part(
        part_squared_distances, outputs(part, Eigen::all), settings, found, progress.part(0, 2));
    std::vector<Eigen::Index> all(outputs.cols());
    std::iota(all.begin(), all.end(), 0);
    const Progress steps = progress.part(1, 2);
    for (size_t k = 0; k < log_lambdas.size(); ++k) {
        steps("training", static_cast<int>(k), static_cast<int>(log_lambdas.size()));
        const double at = log_lambdas[k];
        KernelSpectrum spectrum = low_rank_spectrum(inputs, std::exp(at), rank, progress);
        // Noise cannot be distinguished from what the spectrum leaves out, so it is at least that.
        // The likelihood would else find none, and the weights would follow the noise.
        const double least = std::max(least_noise_ratio(inputs.cols()), spectrum.tail_mean);
        const NoiseRatioBounds noise_ratio{.lower = std::max(least, settings.noise_ratio.lower),
                                           .upper = std::max(least, settings.noise_ratio.upper)};
        keep_better(
            found.best, at, all,
            profile_likelihood(spectrum, Eigen::MatrixXd(), outputs, noise_ratio, Slope::left_out));
        found.spectra.emplace(at, std::move(spectrum));
        found.forget_unused();
    }
    return found;
}

}  // namespace taut::gp
