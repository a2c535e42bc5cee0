// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <limits>
#include <stdexcept>
#include <vector>

#include "gp/gradient_weights.hpp"
#include "gp/inputs_check.hpp"
#include "numerics/dense.hpp"
#include "numerics/memory_budget.hpp"
#include "numerics/parallel.hpp"
#include "taut/gp/fit.hpp"

namespace taut::gp {
namespace {

std::vector<Eigen::Index> members_of(const FittedProcesses& fitted, size_t spectrum) {
    std::vector<Eigen::Index> members;
    for (size_t j = 0; j < fitted.processes.size(); ++j) {
        if (fitted.processes[j].spectrum == static_cast<int>(spectrum)) {
            members.push_back(static_cast<Eigen::Index>(j));
        }
    }
    return members;
}

void check_inputs(const FittedProcesses& fitted, const Eigen::Ref<const Eigen::MatrixXd>& at) {
    if (at.rows() != fitted.inputs.rows()) {
        throw std::invalid_argument(fmt::format(
            "inputs of dimension {}, expected {} as in training", at.rows(), fitted.inputs.rows()));
    }
    require_usable("the inputs", at);
}

/// Bound of the rounding errors in sum_i a_i^2 / (d_i + eta) + b^2 / (tau + eta), a = Q'k along the
/// directions and b = |k - Q a| beside them: sums of n products with unit vectors round a_i and b
/// by at most delta = n epsilon |k|, and so a square by 2 a delta + delta^2. (processes x inputs)
Eigen::MatrixXd rounding_of_explained(const Eigen::MatrixXd& k, const Eigen::MatrixXd& inverse,
                                      const Eigen::VectorXd& tail_inverse,
                                      const Eigen::MatrixXd& along,
                                      const Eigen::RowVectorXd& beside) {
    const Eigen::RowVectorXd delta =
        static_cast<double>(k.rows()) * std::numeric_limits<double>::epsilon() * k.colwise().norm();
    const Eigen::VectorXd inverses = inverse.colwise().sum().transpose() + tail_inverse;
    return 2.0 * (transposed_product(inverse, along.cwiseAbs()) + tail_inverse * beside) *
               delta.asDiagonal() +
           inverses * delta.cwiseAbs2();
}

/// Adds the mean and std of the processes that use spectrum number s, by their rows in the result.
void predict_with_spectrum(const FittedProcesses& fitted, size_t s,
                           const Eigen::MatrixXd& squared_distances, Prediction& result) {
    const std::vector<Eigen::Index> members = members_of(fitted, s);
    const KernelSpectrum& spectrum = fitted.spectra[s];
    Eigen::VectorXd signal_stds(members.size());
    Eigen::VectorXd errors(members.size());
    // (d + eta)^-1 of each. What a spectrum leaves out counts as noise, as much in all directions
    // as in the worst: so the variance is no smaller than the exact one. (low-rank-variance)
    Eigen::MatrixXd inverse(spectrum.eigenvalues.size(), members.size());
    Eigen::VectorXd tail_inverse(members.size());
    for (size_t i = 0; i < members.size(); ++i) {
        const auto& theta = fitted.processes[members[i]].hyperparameters;
        const double ratio = theta.noise_std / theta.signal_std;
        const auto column = static_cast<Eigen::Index>(i);
        signal_stds(column) = theta.signal_std;
        errors(column) = fitted.processes[members[i]].approximation_error;
        const double noise = ratio * ratio + spectrum.tail_largest;
        inverse.col(column) = (spectrum.eigenvalues.array() + noise).inverse();
        tail_inverse(column) = 1.0 / noise;
    }
    // k(x_*) / sigma_f^2, and what of the variance the training inputs explain:
    // k' (R + eta I)^-1 k = sum_i (Q'k)_i^2 / (d_i + eta).
    const Eigen::MatrixXd k = correlation(squared_distances, spectrum.inverse_length_scale);
    const Eigen::MatrixXd along = transposed_product(spectrum.eigenvectors, k);
    Eigen::MatrixXd explained = transposed_product(inverse, along.cwiseAbs2());
    Eigen::MatrixXd rounding;
    if (!spectrum.is_whole()) {
        const Eigen::RowVectorXd beside =
            (k - product(spectrum.eigenvectors, along)).colwise().norm();
        explained += tail_inverse * beside.cwiseAbs2();
        rounding = rounding_of_explained(k, inverse, tail_inverse, along, beside);
    }
    result.mean(members, Eigen::all) = transposed_product(fitted.weights(Eigen::all, members), k);
    Eigen::MatrixXd unexplained = 1.0 - explained.array();
    if (!spectrum.is_whole()) {
        // Below zero by no more than rounding errors, it is set to these. Else tail_largest was
        // underestimated: the variance is then that of the prior.
        const auto is_rounding = unexplained.array() >= -rounding.array();
        unexplained = (unexplained.array() >= 0.0)
                          .select(unexplained, is_rounding.select(rounding.array().min(1.0), 1.0));
    }
    result.std_dev(members, Eigen::all) =
        (signal_stds.asDiagonal() * unexplained.cwiseMax(0.0).cwiseSqrt()).eval();
    if (!spectrum.is_whole()) {
        // The error bound of the mean, (approximation-error), adds to the variance.
        result.std_dev(members, Eigen::all) =
            (result.std_dev(members, Eigen::all).array().square().colwise() +
             errors.array().square())
                .sqrt()
                .eval();
    }
}

}  // namespace

Prediction FittedProcesses::predict(const Eigen::Ref<const Eigen::MatrixXd>& at) const {
    check_inputs(*this, at);
    const auto m = static_cast<Eigen::Index>(processes.size());
    // Distances; of each spectrum correlations, what lies along it, and its squares.
    const MemoryCharge charge = charge_numbers(
        static_cast<double>(at.cols()) *
        (static_cast<double>(inputs.cols()) * (1.0 + 3.0 * static_cast<double>(spectra.size())) +
         4.0 * static_cast<double>(m)));
    Prediction result{.mean = Eigen::MatrixXd::Zero(m, at.cols()),
                      .std_dev = Eigen::MatrixXd::Zero(m, at.cols())};
    const Eigen::MatrixXd distances = squared_distances(inputs, at);
    parallel_for(size_t{0}, spectra.size(),
                 [&](size_t s) { predict_with_spectrum(*this, s, distances, result); });
    return result;
}

Eigen::MatrixXd gradient_weights(const FittedProcesses& fitted,
                                 const Eigen::Ref<const Eigen::VectorXd>& at) {
    check_inputs(fitted, at);
    const Eigen::MatrixXd distances = squared_distances(fitted.inputs, at);
    Eigen::MatrixXd result =
        Eigen::MatrixXd::Zero(fitted.inputs.cols(), std::ssize(fitted.processes));
    for (size_t s = 0; s < fitted.spectra.size(); ++s) {
        const double lambda = fitted.spectra[s].inverse_length_scale;
        const Eigen::VectorXd factors = -lambda * lambda * correlation(distances, lambda).col(0);
        for (const Eigen::Index j : members_of(fitted, s)) {
            result.col(j) = factors.cwiseProduct(fitted.weights.col(j));
        }
    }
    return result;
}

Eigen::MatrixXd FittedProcesses::mean_gradient(const Eigen::Ref<const Eigen::VectorXd>& at) const {
    const Eigen::MatrixXd weights_there = gradient_weights(*this, at);
    return weights_there.colwise().sum().transpose() * at.transpose() -
           product(inputs, weights_there).transpose();
}

}  // namespace taut::gp
