// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/gp/fit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gp/condition.hpp"
#include "gp/input_spread.hpp"
#include "gp/inputs_check.hpp"
#include "gp/lambda_search.hpp"
#include "gp/low_rank_search.hpp"
#include "gp/low_rank_spectrum.hpp"
#include "numerics/memory_budget.hpp"
#include "numerics/parallel.hpp"
#include "taut/gp/kernel.hpp"

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
    check(settings.most_decomposed >= 2, "most_decomposed", settings.most_decomposed, "at least 2");
    check(settings.rank >= 1, "rank", settings.rank, "at least 1");
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

/// The outputs that can be fitted; marks the others.
FittableOutputs fittable(const Eigen::Ref<const Eigen::MatrixXd>& outputs,
                         std::vector<Process>& processes) {
    FittableOutputs result;
    for (int j = 0; j < outputs.cols(); ++j) {
        processes[j].status = status_of(outputs.col(j));
        if (processes[j].status == FitStatus::fitted) {
            result.column_of.push_back(j);
        }
    }
    result.values = outputs(Eigen::all, result.column_of);
    return result;
}

LambdaSearchSettings search_settings(const FitSettings& settings, const InputSpread& spread,
                                     Eigen::Index n) {
    if (spread.distance <= 0.0) {
        throw std::invalid_argument(
            "the training inputs are all the same, expected different ones");
    }
    const LambdaSearchSettings search{
        .lower_log_lambda = std::log(settings.smallest_scaled_lambda / spread.distance),
        .upper_log_lambda = std::log(settings.largest_scaled_lambda / spread.distance_to_nearest),
        .noise_ratio = settings.noise_ratio.value_or(default_noise_ratio_bounds(n)),
        .relative_tolerance = settings.relative_tolerance,
        .max_spectra = settings.max_spectra};
    if (search.lower_log_lambda > search.upper_log_lambda) {
        throw std::invalid_argument(fmt::format(
            "smallest_scaled_lambda {} and largest_scaled_lambda {} leave nothing between them for "
            "these inputs",
            settings.smallest_scaled_lambda, settings.largest_scaled_lambda));
    }
    return search;
}

/// The outputs that chose each of the spectra, in the order of these.
std::vector<std::vector<Eigen::Index>> members_of(const FoundLambdas& found) {
    std::vector<std::vector<Eigen::Index>> members;
    for (const auto& [log_lambda, spectrum] : found.spectra) {
        members.emplace_back();
        for (size_t k = 0; k < found.best.size(); ++k) {
            if (found.best[k].log_lambda == log_lambda) {
                members.back().push_back(static_cast<Eigen::Index>(k));
            }
        }
    }
    return members;
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
    const Eigen::Index n = inputs.cols();
    const bool is_decomposed = n <= settings.most_decomposed;
    // Of many inputs a part shows as well how far all are apart, and where lambda lies.
    const std::vector<Eigen::Index> part =
        spread_part(n, is_decomposed ? n : std::min(settings.most_decomposed, inputs_to_search));
    const MemoryCharge charge = charge_numbers(
        static_cast<double>(inputs.size()) + 2.0 * static_cast<double>(outputs.size()) +
        static_cast<double>(std::ssize(part) * std::ssize(part)));
    const Eigen::MatrixXd distances = squared_distances(inputs(Eigen::all, part));
    const LambdaSearchSettings search =
        search_settings(settings, input_spread(inputs(Eigen::all, part), distances), n);
    FittedProcesses result;
    result.inputs = inputs;
    result.weights.setZero(n, outputs.cols());
    result.processes.resize(outputs.cols());
    const FittableOutputs to_fit = fittable(outputs, result.processes);
    if (to_fit.column_of.empty()) {
        return result;
    }
    FoundLambdas found =
        is_decomposed ? search_lambdas(distances, to_fit.values, search, progress)
                      : search_by_low_rank(inputs, to_fit.values, part, distances, search,
                                           std::min<Eigen::Index>(settings.rank, n), progress);
    result.decompositions = found.decompositions;
    result.is_converged = found.is_converged;
    const std::vector<std::vector<Eigen::Index>> members = members_of(found);
    for (auto& [log_lambda, spectrum] : found.spectra) {
        result.spectra.push_back(std::move(spectrum));
    }
    parallel_for(size_t{0}, members.size(),
                 [&](size_t s) { condition(result, s, found.best, to_fit, members[s], progress); });
    return result;
}

std::optional<Eigen::Index> FittedProcesses::rank() const {
    std::optional<Eigen::Index> rank;
    for (const KernelSpectrum& spectrum : spectra) {
        if (!spectrum.is_whole()) {
            rank = std::max(rank.value_or(0), spectrum.eigenvectors.cols());
        }
    }
    return rank;
}

double FittedProcesses::left_out() const {
    double largest = 0.0;
    for (const KernelSpectrum& spectrum : spectra) {
        const auto n = static_cast<double>(spectrum.eigenvectors.rows());
        const auto r = static_cast<double>(spectrum.eigenvectors.cols());
        largest = std::max(largest, spectrum.tail_mean * (n - r) / n);  // the trace is n
    }
    return largest;
}

}  // namespace taut::gp
