// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/gp/fit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "gp/inputs_check.hpp"
#include "gp/length_scale_search.hpp"
#include "numerics/dense.hpp"

namespace taut::gp {
namespace {

double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// How far apart the training inputs are, where they differ at all.
struct Spread {
    double distance = 0.0;             ///< median of all pairs; 0 if all inputs are the same
    double distance_to_nearest = 0.0;  ///< median over the inputs
};

Spread spread_of(const Eigen::MatrixXd& inputs, const Eigen::MatrixXd& squared_distances) {
    // Inputs that should be the same can differ by rounding, and their distance by that of squares.
    const double rounding = 1e-14 * inputs.cwiseAbs().maxCoeff();
    const double same = std::max(rounding * rounding, 1e-14 * squared_distances.maxCoeff());
    std::vector<double> all;
    std::vector<double> nearest;
    for (Eigen::Index j = 0; j < squared_distances.cols(); ++j) {
        double smallest = std::numeric_limits<double>::infinity();
        for (Eigen::Index i = 0; i < squared_distances.rows(); ++i) {
            if (const double value = squared_distances(i, j); value > same) {
                if (i < j) {
                    all.push_back(value);
                }
                smallest = std::min(smallest, value);
            }
        }
        if (std::isfinite(smallest)) {
            nearest.push_back(smallest);
        }
    }
    if (all.empty()) {
        return {};
    }
    return {.distance = std::sqrt(median(all)), .distance_to_nearest = std::sqrt(median(nearest))};
}

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

/// The search over lambda: each output's profile at every point looked at, and the spectra of those
/// points that are some output's best.
struct Search {
    LengthScaleSearch points;
    std::map<double, KernelSpectrum> spectra;

    void look_at(double log_lambda, const Eigen::MatrixXd& squared_distances,
                 const Eigen::MatrixXd& outputs, const NoiseRatioBounds& bounds) {
        KernelSpectrum spectrum = kernel_spectrum(squared_distances, std::exp(log_lambda));
        points.add(log_lambda, profile_likelihood(spectrum, squared_distances, outputs, bounds));
        spectra.emplace(log_lambda, std::move(spectrum));
        const std::vector<double> best = points.best();
        std::erase_if(
            spectra, [&](const auto& s) { return std::ranges::find(best, s.first) == best.end(); });
    }
};

/// Conditions the outputs that chose one lambda on the data: weights and leave-one-out errors.
/// @param members their columns in the outputs, @param profile at this lambda, by the same columns
void condition(const KernelSpectrum& spectrum, const LikelihoodProfile& profile,
               const Eigen::MatrixXd& outputs, const std::vector<Eigen::Index>& members,
               FittedProcesses& result, const std::vector<int>& output_of, int spectrum_index) {
    const Eigen::MatrixXd& basis = spectrum.eigenvectors;
    const Eigen::ArrayXd d = spectrum.eigenvalues.array();
    const Eigen::MatrixXd z = transposed_product(basis, outputs(Eigen::all, members));
    Eigen::MatrixXd inverse(z.rows(), z.cols());  // (d + eta)^-1 of each member
    for (Eigen::Index k = 0; k < z.cols(); ++k) {
        inverse.col(k) = 1.0 / (d + profile.noise_ratio(members[k]));
    }
    const Eigen::MatrixXd weights = product(basis, z.cwiseProduct(inverse));
    // The error at input i of the process trained without it is a_i / [C^-1]_ii (Rasmussen and
    // Williams, eq. 5.12), and [C^-1]_ii = sum_k Q_ik^2 / (d_k + eta) up to sigma_f^2.
    const Eigen::MatrixXd inverse_diagonals = product(basis.cwiseAbs2(), inverse);
    for (Eigen::Index k = 0; k < z.cols(); ++k) {
        const Eigen::Index member = members[k];
        const int output = output_of[member];
        const double signal = profile.signal_variance(member);
        result.weights.col(output) = weights.col(k);
        result.processes[output] = {
            .status = FitStatus::fitted,
            .hyperparameters = {.inverse_length_scale = spectrum.inverse_length_scale,
                                .signal_std = std::sqrt(signal),
                                .noise_std = std::sqrt(signal * profile.noise_ratio(member))},
            .negative_log_likelihood = profile.value(member),
            .leave_one_out_rmse = std::sqrt(
                (weights.col(k).array() / inverse_diagonals.col(k).array()).square().mean()),
            .spectrum = spectrum_index};
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
    const Eigen::MatrixXd distances = squared_distances(inputs, inputs);
    const Spread spread = spread_of(inputs, distances);
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
    Search search{.points = {lower, upper, settings.relative_tolerance}, .spectra = {}};
    for (int made = 0; made < settings.max_spectra; ++made) {
        const auto log_lambda = search.points.next();
        if (!log_lambda) {
            break;
        }
        progress("training", made, settings.max_spectra);
        search.look_at(*log_lambda, distances, fittable, bounds);
    }

    const std::vector<double> chosen = search.points.best();
    for (auto& [log_lambda, spectrum] : search.spectra) {
        std::vector<Eigen::Index> members;
        for (size_t k = 0; k < chosen.size(); ++k) {
            if (chosen[k] == log_lambda) {
                members.push_back(static_cast<Eigen::Index>(k));
            }
        }
        condition(spectrum, search.points.profiles().at(log_lambda), fittable, members, result,
                  output_of, static_cast<int>(result.spectra.size()));
        result.spectra.push_back(std::move(spectrum));
    }
    return result;
}

}  // namespace taut::gp
