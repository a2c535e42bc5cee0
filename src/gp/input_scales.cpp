// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "gp/input_scales.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "gp/inputs_check.hpp"
#include "gp/likelihood_profile.hpp"
#include "gp/minimise.hpp"
#include "numerics/dense.hpp"
#include "taut/gp/kernel.hpp"
#include "taut/gp/likelihood.hpp"
#include "taut/gp/spectrum.hpp"

namespace taut::gp {
namespace {

constexpr Eigen::Index most_inputs = 500;

/// The likelihood is flat about its optimum: a scale that is a per cent off costs nothing.
constexpr double relative_tolerance = 1e-6;
constexpr int most_evaluations = 60;

/// Length scales that the search may start from, in distances of the inputs.
constexpr std::array starts{100.0, 30.0, 10.0, 3.0, 1.0};

/// A dimension so many times less or more relevant than at the start is irrelevant, or alone
/// relevant.
constexpr double widest_factor = 1e3;

Eigen::VectorXd scales_of(const std::vector<int>& groups,
                          const Eigen::Ref<const Eigen::VectorXd>& log_scales) {
    return log_scales(groups).array().exp();
}

int group_count(const std::vector<int>& groups, Eigen::Index dimensions) {
    if (static_cast<Eigen::Index>(groups.size()) != dimensions) {
        throw std::invalid_argument(
            fmt::format("{} groups for inputs of dimension {}, expected one "
                        "per dimension",
                        groups.size(), dimensions));
    }
    // No group is empty: there are no more of them than dimensions.
    if (groups.empty() || std::ranges::min(groups) < 0 ||
        std::ranges::max(groups) >= std::ssize(groups)) {
        throw std::invalid_argument("a group is negative or too large, or there is none");
    }
    return std::ranges::max(groups) + 1;
}

/// Inputs and outputs that the scales are estimated from, and the best seen so far.
struct Problem {
    Eigen::MatrixXd inputs;
    Eigen::MatrixXd outputs;
    const std::vector<int>& groups;
    std::vector<double> best_log_scales;
    double best_value = std::numeric_limits<double>::infinity();
    const Progress& progress;
    int evaluations = 0;
};

Problem problem_of(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                   const Eigen::Ref<const Eigen::MatrixXd>& outputs, const std::vector<int>& groups,
                   const Progress& progress) {
    const Eigen::Index n = std::min(most_inputs, inputs.cols());
    std::vector<Eigen::Index> usable;
    for (Eigen::Index j = 0; j < outputs.cols(); ++j) {
        const auto output = outputs.col(j).head(n);
        if (output.allFinite() && output.maxCoeff() > output.minCoeff()) {
            usable.push_back(j);
        }
    }
    return {.inputs = inputs.leftCols(n),
            .outputs = outputs.topRows(n)(Eigen::all, usable),
            .groups = groups,
            .best_log_scales = {},
            .progress = progress};
}

ScalesLikelihood evaluate(Problem& problem, const Eigen::VectorXd& log_scales) {
    constexpr int most = static_cast<int>(starts.size()) + most_evaluations;
    // A line search may evaluate a little more than it was allowed.
    problem.progress("scales of the kernel", std::min(problem.evaluations++, most), most);
    return scales_likelihood(problem.inputs, problem.outputs, problem.groups, log_scales);
}

/// The objective of the search, which keeps the best.
double objective(Problem& problem, const std::vector<double>& x, std::vector<double>& gradient) {
    const ScalesLikelihood at =
        evaluate(problem, Eigen::VectorXd::Map(x.data(), static_cast<Eigen::Index>(x.size())));
    if (!gradient.empty()) {
        Eigen::VectorXd::Map(gradient.data(), at.gradient.size()) = at.gradient;
    }
    if (at.value < problem.best_value) {
        problem.best_value = at.value;
        problem.best_log_scales = x;
    }
    return at.value;
}

/// One scale for all: the best of a few, from that of a nearly linear kernel to a rough one.
double best_common_scale(Problem& problem, Eigen::Index group_count) {
    const Eigen::MatrixXd squares = squared_distances(problem.inputs);
    const double distance = std::sqrt(squares.mean());
    if (!(distance > 0.0)) {
        throw std::invalid_argument(
            "the training inputs are all the same, expected different ones");
    }
    double best = 0.0;
    double best_value = std::numeric_limits<double>::infinity();
    for (const double length_scale : starts) {
        const double log_scale = -std::log(length_scale * distance);
        const double value =
            evaluate(problem, Eigen::VectorXd::Constant(group_count, log_scale)).value;
        if (value < best_value) {
            best = log_scale;
            best_value = value;
        }
    }
    return best;
}

}  // namespace

ScalesLikelihood scales_likelihood(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                                   const Eigen::Ref<const Eigen::MatrixXd>& outputs,
                                   const std::vector<int>& groups,
                                   const Eigen::Ref<const Eigen::VectorXd>& log_scales) {
    const Eigen::MatrixXd scaled = scales_of(groups, log_scales).asDiagonal() * inputs;
    const Eigen::MatrixXd squares = squared_distances(scaled);
    const KernelSpectrum spectrum = kernel_spectrum(squares, 1.0);
    const LikelihoodProfile profile =
        profile_likelihood(spectrum, squares, outputs, default_noise_ratio_bounds(inputs.cols()));

    // With C_j = sigma_f^2 (R + eta I) of output j, sum_j dL_j/ds = tr(M dR/ds) with
    //   M = 1/2 sum_j ((R + eta_j I)^-1 - w_j w_j' / sigma_f,j^2),  w_j = (R + eta_j I)^-1 y_j
    // (Rasmussen and Williams, eq. 5.9; derivatives by sigma_f and eta vanish at their optimum).
    const Eigen::MatrixXd& basis = spectrum.eigenvectors;
    Eigen::MatrixXd in_basis = transposed_product(basis, outputs);
    Eigen::VectorXd inverse_sum = Eigen::VectorXd::Zero(basis.cols());
    for (Eigen::Index j = 0; j < outputs.cols(); ++j) {
        const Eigen::ArrayXd inverse =
            (spectrum.eigenvalues.array() + profile.noise_ratio(j)).inverse();
        inverse_sum.array() += inverse;
        in_basis.col(j).array() *= inverse / std::sqrt(profile.signal_variance(j));
    }
    const Eigen::MatrixXd weights = product(basis, in_basis);
    Eigen::MatrixXd M = product(basis * inverse_sum.asDiagonal(), basis.transpose());
    M -= product(weights, weights.transpose());
    M *= 0.5;

    // dR/dlog s_g = -R o D_g, D_g the squared distances within the group alone. With T = M o R,
    // symmetric, sum_ik T_ik (x_i - x_k)^2 = 2 sum_i x_i^2 sum_k T_ik - 2 x' T x for each
    // dimension.
    const Eigen::MatrixXd T = M.cwiseProduct(correlation(squares, 1.0));
    const Eigen::VectorXd of_dimension =
        -2.0 * (scaled.cwiseAbs2() * T.rowwise().sum() -
                scaled.cwiseProduct(product(scaled, T)).rowwise().sum());
    ScalesLikelihood result{.value = profile.value.sum(),
                            .gradient = Eigen::VectorXd::Zero(log_scales.size())};
    for (size_t i = 0; i < groups.size(); ++i) {
        result.gradient(groups[i]) += of_dimension(static_cast<Eigen::Index>(i));
    }
    return result;
}

Eigen::VectorXd estimate_input_scales(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                                      const Eigen::Ref<const Eigen::MatrixXd>& outputs,
                                      const std::vector<int>& groups, const Progress& progress) {
    const int count = group_count(groups, inputs.rows());
    if (outputs.rows() != inputs.cols() || inputs.cols() < 2 || !is_usable(inputs)) {
        throw std::invalid_argument(
            fmt::format("{} inputs and {} rows of outputs, expected as many, finite, at least 2",
                        inputs.cols(), outputs.rows()));
    }
    Problem problem = problem_of(inputs, outputs, groups, progress);
    if (count == 1 || problem.outputs.cols() == 0) {
        return Eigen::VectorXd::Ones(inputs.rows());
    }
    const double start = best_common_scale(problem, count);
    const std::vector<double> first(count, start);
    problem.best_log_scales = first;
    minimise([&](const auto& x, auto& gradient) { return objective(problem, x, gradient); }, first,
             {.lower = start - std::log(widest_factor),
              .upper = start + std::log(widest_factor),
              .relative_tolerance = relative_tolerance,
              .most_evaluations = most_evaluations});
    const Eigen::VectorXd found = Eigen::VectorXd::Map(problem.best_log_scales.data(), count);
    Eigen::VectorXd result = scales_of(groups, found);
    return result / std::exp(result.array().log().mean());
}

}  // namespace taut::gp
