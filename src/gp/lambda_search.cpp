// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "gp/lambda_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gp/length_scale_search.hpp"
#include "gp/likelihood_profile.hpp"
#include "numerics/parallel.hpp"
#include "shared_work.hpp"

namespace taut::gp {
namespace {

/// Lambdas tried together, one per thread: always as many, so that results do not depend on the
/// number of threads. More would be chosen with less knowledge; with two hardly one is wasted.
constexpr int lambdas_together = 2;

/// The spectrum and the profiles at one lambda.
struct Seen {
    KernelSpectrum spectrum;
    LikelihoodProfile profile;
};

template <typename Packing>
void pack(Packing& packing, Seen& seen) {
    auto& [inverse_length_scale, eigenvalues, eigenvectors, tail_mean, tail_largest] =
        seen.spectrum;
    auto& [value, slope, noise_ratio, signal_variance] = seen.profile;
    packing(inverse_length_scale, eigenvalues, eigenvectors, tail_mean, tail_largest, value, slope,
            noise_ratio, signal_variance);
}

}  // namespace

void keep_better(std::vector<BestLambda>& best, double log_lambda,
                 const std::vector<Eigen::Index>& outputs, const LikelihoodProfile& profile) {
    for (Eigen::Index k = 0; k < profile.value.size(); ++k) {
        if (BestLambda& known = best[outputs[k]]; profile.value(k) < known.value) {
            known = {.log_lambda = log_lambda,
                     .value = profile.value(k),
                     .noise_ratio = profile.noise_ratio(k),
                     .signal_variance = profile.signal_variance(k)};
        }
    }
}

void FoundLambdas::forget_unused() {
    std::erase_if(spectra, [&](const auto& spectrum) {
        return std::ranges::find(best, spectrum.first, &BestLambda::log_lambda) == best.end();
    });
    double numbers = 0.0;
    for (const auto& [log_lambda, spectrum] : spectra) {
        numbers += static_cast<double>(spectrum.eigenvectors.size());
    }
    charge = {};
    charge = charge_numbers(numbers);
}

FoundLambdas search_lambdas(const Eigen::MatrixXd& squared_distances,
                            const Eigen::MatrixXd& outputs, const LambdaSearchSettings& settings,
                            const Progress& progress) {
    FoundLambdas found{.best = std::vector<BestLambda>(outputs.cols()), .is_converged = false};
    LengthScaleSearch points(outputs.cols(), settings.lower_log_lambda, settings.upper_log_lambda,
                             settings.relative_tolerance);
    for (int made = 0; made < settings.max_spectra;) {
        const auto looks = points.next(std::min(lambdas_together, settings.max_spectra - made));
        if (looks.empty()) {
            found.is_converged = true;
            break;
        }
        for (size_t k = 0; k < looks.size(); ++k) {
            progress("training", made++, settings.max_spectra);
        }
        found.decompositions = made;
        const bool is_last = made == settings.max_spectra;  // no slope will be asked for
        const std::vector<size_t> mine = share_of(looks.size());
        // Of each the correlations, their eigenvectors, as much room for the decomposition, and the
        // rates of the correlations; of each output that along the eigenvectors, and its squares.
        double numbers = 0.0;
        for (const size_t k : mine) {
            numbers += 4.0 * static_cast<double>(squared_distances.size()) +
                       3.0 * static_cast<double>(outputs.rows() * std::ssize(looks[k].outputs));
        }
        const MemoryCharge at_work = charge_numbers(numbers);
        std::vector<Seen> seen(mine.size());
        parallel_for(size_t{0}, seen.size(), [&](size_t i) {
            const LengthScaleSearch::Look& look = looks[mine[i]];
            seen[i].spectrum = kernel_spectrum(squared_distances, std::exp(look.log_lambda));
            progress.throw_if_stopped();
            seen[i].profile = profile_likelihood(
                seen[i].spectrum, squared_distances, outputs(Eigen::all, look.outputs),
                settings.noise_ratio, is_last ? Slope::left_out : Slope::wanted);
        });
        seen = all_gather(looks.size(), std::move(seen));
        for (size_t k = 0; k < seen.size(); ++k) {
            keep_better(found.best, looks[k].log_lambda, looks[k].outputs, seen[k].profile);
            if (!is_last) {
                points.add(looks[k], seen[k].profile);
            }
            found.spectra.emplace(looks[k].log_lambda, std::move(seen[k].spectrum));
        }
        found.forget_unused();
    }
    return found;
}

}  // namespace taut::gp
