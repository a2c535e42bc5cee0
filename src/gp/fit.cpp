// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/gp/fit.hpp"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "gp/input_spread.hpp"
#include "gp/inputs_check.hpp"
#include "gp/length_scale_search.hpp"
#include "numerics/dense.hpp"

namespace taut::gp {
namespace {

FitStatus status_of(const Eigen::Ref<const Eigen::VectorXd>& output) {
    if (!is_usable(output)) {
        return FitStatus::non_finite_output;
    }
    return output.maxCoeff() == output.minCoeff() ? FitStatus::constant_output : FitStatus::fitted;
}

void check_arguments(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                     const Eigen::Ref<const Eigen::MatrixXd>& outputs) {
    if (outputs.rows() != inputs.cols()) {
        throw std::invalid_argument(fmt::format(
            "{} inputs, but {} rows of outputs: expected as many", inputs.cols(), outputs.rows()));
    }
    if (inputs.rows() < 1) {
        throw std::invalid_argument("training inputs without dimensions, expected one at least");
    }
    if (inputs.cols() < 2) {
        throw std::invalid_argument(
            fmt::format("{} training inputs, expected at least 2", inputs.cols()));
    }
    require_usable("the training inputs", inputs);
}

void check_settings(const FitSettings& settings) {
    const auto check = [](bool holds, std::string_view field, double value, std::string_view rule) {
        if (!holds) {
            throw std::invalid_argument(fmt::format("{} is {}, expected {}", field, value, rule));
        }
    };
    const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
    check(positive(settings.smallest_scaled_lambda), "smallest_scaled_lambda",
          settings.smallest_scaled_lambda, "a positive and finite number");
    check(positive(settings.largest_scaled_lambda), "largest_scaled_lambda",
          settings.largest_scaled_lambda, "a positive and finite number");
    check(settings.relative_tolerance >= 0.0, "relative_tolerance", settings.relative_tolerance,
          "zero or more");
    check(settings.max_spectra >= 1, "max_spectra", settings.max_spectra, "at least 1");
    if (settings.noise_ratio) {
        const auto [lower, upper] = *settings.noise_ratio;
        // Products of ratios over some processes must neither underflow nor overflow.
        constexpr double limit = 1e18;
        check(lower >= 1.0 / limit && lower <= limit, "noise_ratio.lower", lower,
              "a number from 1e-18 to 1e18");
        check(upper >= lower && upper <= limit, "noise_ratio.upper", upper,
              "a number from noise_ratio.lower to 1e18");
    }
}

/// Lambdas looked at together, one a thread: always as many, so that results do not depend on the
/// number of threads. More would be chosen with less knowledge; of two, hardly one is lost by it.
constexpr int lambdas_together = 2;

/// What is best for one output among the lambdas looked at.
struct Best {
    double log_lambda = 0.0;
    double value = std::numeric_limits<double>::infinity();
    double noise_ratio = 0.0;
    double signal_variance = 0.0;
};

/// The search over lambda: each output's best, and the spectra that are best for some.
struct Search {
    LengthScaleSearch points;
    std::vector<Best> best;
    std::map<double, KernelSpectrum> spectra;

    /// @param is_last nothing will be asked of `points` again
    void look_at(const std::vector<LengthScaleSearch::Look>& looks, bool is_last,
                 const Eigen::MatrixXd& squared_distances, const Eigen::MatrixXd& outputs,
                 const NoiseRatioBounds& bounds) {
        std::vector<KernelSpectrum> seen(looks.size());
        std::vector<LikelihoodProfile> profiles(looks.size());
        tbb::parallel_for(size_t{0}, seen.size(), [&](size_t k) {
            seen[k] = kernel_spectrum(squared_distances, std::exp(looks[k].log_lambda));
            profiles[k] = profile_likelihood(seen[k], squared_distances,
                                             outputs(Eigen::all, looks[k].outputs), bounds,
                                             is_last ? Slope::left_out : Slope::wanted);
        });
        for (size_t k = 0; k < seen.size(); ++k) {
            keep_best(looks[k], profiles[k]);
            if (!is_last) {
                points.add(looks[k], profiles[k]);
            }
            spectra.emplace(looks[k].log_lambda, std::move(seen[k]));
        }
        std::erase_if(spectra, [&](const auto& s) {
            return std::ranges::find(best, s.first, &Best::log_lambda) == best.end();
        });
    }

private:
    void keep_best(const LengthScaleSearch::Look& look, const LikelihoodProfile& profile) {
        for (Eigen::Index k = 0; k < profile.value.size(); ++k) {
            if (Best& known = best[look.outputs[k]]; profile.value(k) < known.value) {
                known = {.log_lambda = look.log_lambda,
                         .value = profile.value(k),
                         .noise_ratio = profile.noise_ratio(k),
                         .signal_variance = profile.signal_variance(k)};
            }
        }
    }
};

/// Conditions the outputs that chose one lambda on the data: weights and leave-one-out errors.
/// @param index of its spectrum in the result
/// @param members their columns in `outputs` and places in `best`
/// @param output_of their columns in the result
void condition(FittedProcesses& result, size_t index, const std::vector<Best>& best,
               const Eigen::MatrixXd& outputs, const std::vector<Eigen::Index>& members,
               const std::vector<int>& output_of) {
    const KernelSpectrum& spectrum = result.spectra[index];
    const Eigen::MatrixXd& basis = spectrum.eigenvectors;
    const Eigen::ArrayXd d = spectrum.eigenvalues.array();
    const Eigen::MatrixXd z = transposed_product(basis, outputs(Eigen::all, members));
    Eigen::MatrixXd inverse(z.rows(), z.cols());  // (d + eta)^-1 of each member
    for (Eigen::Index k = 0; k < z.cols(); ++k) {
        inverse.col(k) = 1.0 / (d + best[members[k]].noise_ratio);
    }
    const Eigen::MatrixXd weights = product(basis, z.cwiseProduct(inverse));
    // The error at input i of the process trained without it is a_i / [C^-1]_ii (Rasmussen and
    // Williams, eq. 5.12), and [C^-1]_ii = sum_k Q_ik^2 / (d_k + eta) up to sigma_f^2.
    const Eigen::MatrixXd inverse_diagonals = product(basis.cwiseAbs2(), inverse);
    for (Eigen::Index k = 0; k < z.cols(); ++k) {
        const Best& of = best[members[k]];
        const int output = output_of[members[k]];
        result.weights.col(output) = weights.col(k);
        result.processes[output] = {
            .status = FitStatus::fitted,
            .hyperparameters = {.inverse_length_scale = spectrum.inverse_length_scale,
                                .signal_std = std::sqrt(of.signal_variance),
                                .noise_std = std::sqrt(of.signal_variance * of.noise_ratio)},
            .negative_log_likelihood = of.value,
            .leave_one_out_rmse = std::sqrt(
                (weights.col(k).array() / inverse_diagonals.col(k).array()).square().mean()),
            .spectrum = static_cast<int>(index)};
    }
}

}  // namespace

std::string_view to_string(FitStatus status) {
    switch (status) {
        case FitStatus::fitted:
            return "fitted";
        case FitStatus::constant_output:
            return "constant output";
        case FitStatus::non_finite_output:
            return "non-finite output";
    }
    return "unknown";
}

FittedProcesses fit(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                    const Eigen::Ref<const Eigen::MatrixXd>& outputs, const FitSettings& settings,
                    const Progress& progress) {
    check_arguments(inputs, outputs);
    check_settings(settings);
    const Eigen::MatrixXd distances = squared_distances(inputs);
    const InputSpread spread = input_spread(inputs, distances);
    if (spread.distance <= 0.0) {
        throw std::invalid_argument(
            "the training inputs are all the same, expected different ones");
    }
    FittedProcesses result;
    result.inputs = inputs;
    result.weights.setZero(inputs.cols(), outputs.cols());
    result.processes.resize(outputs.cols());
    std::vector<int> output_of;  // columns that can be fitted
    for (int j = 0; j < outputs.cols(); ++j) {
        Process& process = result.processes[j];
        process.status = status_of(outputs.col(j));
        if (process.status == FitStatus::fitted) {
            output_of.push_back(j);
        }
    }
    if (output_of.empty()) {
        return result;
    }
    const Eigen::MatrixXd fittable = outputs(Eigen::all, output_of);
    const NoiseRatioBounds bounds =
        settings.noise_ratio.value_or(default_noise_ratio_bounds(inputs.cols()));

    const double lower = std::log(settings.smallest_scaled_lambda / spread.distance);
    const double upper = std::log(settings.largest_scaled_lambda / spread.distance_to_nearest);
    if (lower > upper) {
        throw std::invalid_argument(fmt::format(
            "smallest_scaled_lambda {} and largest_scaled_lambda {} leave nothing between, for "
            "these inputs",
            settings.smallest_scaled_lambda, settings.largest_scaled_lambda));
    }
    Search search{.points = {fittable.cols(), lower, upper, settings.relative_tolerance},
                  .best = std::vector<Best>(fittable.cols()),
                  .spectra = {}};
    for (int made = 0; made < settings.max_spectra;) {
        const auto looks =
            search.points.next(std::min(lambdas_together, settings.max_spectra - made));
        if (looks.empty()) {
            break;
        }
        for (size_t k = 0; k < looks.size(); ++k) {
            progress("training", made++, settings.max_spectra);
        }
        search.look_at(looks, made == settings.max_spectra, distances, fittable, bounds);
    }

    std::vector<std::vector<Eigen::Index>> members;  // of each spectrum
    for (auto& [log_lambda, spectrum] : search.spectra) {
        members.emplace_back();
        for (size_t k = 0; k < search.best.size(); ++k) {
            if (search.best[k].log_lambda == log_lambda) {
                members.back().push_back(static_cast<Eigen::Index>(k));
            }
        }
        result.spectra.push_back(std::move(spectrum));
    }
    tbb::parallel_for(size_t{0}, members.size(), [&](size_t s) {
        condition(result, s, search.best, fittable, members[s], output_of);
    });
    return result;
}

}  // namespace taut::gp
