// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "gp/condition.hpp"

#include <cmath>
#include <limits>

#include "gp/weights.hpp"
#include "numerics/dense.hpp"
#include "numerics/memory_budget.hpp"

namespace taut::gp {
namespace {

constexpr double tiny = std::numeric_limits<double>::min();

/// Diagonals of (R + eta I)^-1, sum_k Q_ik^2 / (d_k + eta), of each eta (n x k).
Eigen::MatrixXd inverse_diagonals(const KernelSpectrum& spectrum,
                                  const Eigen::VectorXd& noise_ratios) {
    const MemoryCharge charge = charge_numbers(static_cast<double>(spectrum.eigenvectors.size()));
    const Eigen::MatrixXd squares = spectrum.eigenvectors.cwiseAbs2();
    Eigen::MatrixXd inverses(squares.cols(), noise_ratios.size());
    for (Eigen::Index j = 0; j < inverses.cols(); ++j) {
        inverses.col(j) = (spectrum.eigenvalues.array() + noise_ratios(j)).inverse();
    }
    Eigen::MatrixXd diagonals = product(squares, inverses);
    if (!spectrum.is_whole()) {
        // For input i the directions leave out l_i = 1 - |Q_i|^2 of a unit vector and e_i of R_ii.
        // That part adds to the diagonal at least l_i / (e_i / l_i + eta), by Jensen's inequality,
        // (low-rank-diagonal).
        const Eigen::VectorXd remainder = (1.0 - (squares * spectrum.eigenvalues).array()).max(0.0);
        const Eigen::ArrayXd left_out = (1.0 - squares.rowwise().sum().array()).max(0.0);
        for (Eigen::Index j = 0; j < diagonals.cols(); ++j) {
            diagonals.col(j).array() +=
                left_out.square() / (remainder.array() + noise_ratios(j) * left_out).max(tiny);
        }
    }
    return diagonals;
}

RefinedWeights weights_of(const FittedProcesses& result, const KernelSpectrum& spectrum,
                          const Eigen::MatrixXd& outputs, const Eigen::VectorXd& noise_ratios,
                          const Eigen::VectorXd& tolerances, const Progress& progress) {
    if (spectrum.is_whole()) {
        return {.weights = weights_by_spectrum(spectrum, outputs, noise_ratios),
                .residuals = Eigen::VectorXd::Zero(outputs.cols())};
    }
    return refined_weights(result.inputs, spectrum, outputs, noise_ratios, tolerances, progress);
}

}  // namespace

void condition(FittedProcesses& result, size_t index, const std::vector<BestLambda>& best,
               const FittableOutputs& outputs, const std::vector<Eigen::Index>& members,
               const Progress& progress) {
    const KernelSpectrum& spectrum = result.spectra[index];
    constexpr double of_noise = 0.1;  // errors below this part of the noise do not count
    Eigen::VectorXd noise_ratios(std::ssize(members));
    Eigen::VectorXd tolerances(std::ssize(members));
    for (Eigen::Index k = 0; k < noise_ratios.size(); ++k) {
        const BestLambda& of = best[members[k]];
        noise_ratios(k) = of.noise_ratio;
        tolerances(k) = of_noise * std::sqrt(of.signal_variance * of.noise_ratio);
    }
    const auto [weights, residuals] = weights_of(
        result, spectrum, outputs.values(Eigen::all, members), noise_ratios, tolerances, progress);
    // The error at input i of the process trained without it is a_i / [C^-1]_ii (Rasmussen and
    // Williams, eq. 5.12), up to sigma_f^2 the same of R + eta I.
    const Eigen::MatrixXd diagonals = inverse_diagonals(spectrum, noise_ratios);
    for (Eigen::Index k = 0; k < noise_ratios.size(); ++k) {
        const BestLambda& of = best[members[k]];
        const int output = outputs.column_of[members[k]];
        result.weights.col(output) = weights.col(k);
        result.processes[output] = {
            .status = FitStatus::fitted,
            .hyperparameters = {.inverse_length_scale = spectrum.inverse_length_scale,
                                .signal_std = std::sqrt(of.signal_variance),
                                .noise_std = std::sqrt(of.signal_variance * of.noise_ratio)},
            .negative_log_likelihood = of.value,
            .leave_one_out_rmse = std::hypot(
                std::sqrt((weights.col(k).array() / diagonals.col(k).array()).square().mean()),
                residuals(k)),
            .spectrum = static_cast<int>(index),
            .approximation_error = residuals(k)};
    }
}

}  // namespace taut::gp
