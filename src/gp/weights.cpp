// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "gp/weights.hpp"

#include <utility>

#include "gp/correlation_product.hpp"
#include "numerics/dense.hpp"
#include "numerics/memory_budget.hpp"

namespace taut::gp {
namespace {

/// a_j' b_j of each column.
Eigen::RowVectorXd dots(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return a.cwiseProduct(b).colwise().sum();
}

/// a / b, or 0 where b is 0: of a converged output.
Eigen::RowVectorXd ratios(const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b) {
    return (b.array() > 0.0).select(a.array() / b.array(), 0.0);
}

}  // namespace

Eigen::MatrixXd weights_by_spectrum(const KernelSpectrum& spectrum, const Eigen::MatrixXd& outputs,
                                    const Eigen::VectorXd& noise_ratios) {
    const Eigen::MatrixXd& Q = spectrum.eigenvectors;
    const Eigen::MatrixXd z = transposed_product(Q, outputs);
    Eigen::MatrixXd shrunk = z;  // (d + eta)^-1 z
    for (Eigen::Index j = 0; j < z.cols(); ++j) {
        shrunk.col(j).array() *= (spectrum.eigenvalues.array() + noise_ratios(j)).inverse();
    }
    if (spectrum.is_whole()) {
        return product(Q, shrunk);
    }
    // Q (d + eta)^-1 z + (t + eta)^-1 (y - Q z), t the mean of the tail.
    const Eigen::VectorXd tail = (noise_ratios.array() + spectrum.tail_mean).inverse();
    return product(Q, shrunk - z * tail.asDiagonal()) + outputs * tail.asDiagonal();
}

RefinedWeights refined_weights(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                               const KernelSpectrum& spectrum, const Eigen::MatrixXd& outputs,
                               const Eigen::VectorXd& noise_ratios,
                               const Eigen::VectorXd& tolerances, const Progress& progress) {
    const MemoryCharge charge = charge_numbers(5.0 * static_cast<double>(outputs.size()));
    // With the spectrum as preconditioner the error falls by a factor of some ten a step at first.
    constexpr int most_steps = 12;
    const auto precondition = [&](const Eigen::MatrixXd& r) {
        return weights_by_spectrum(spectrum, r, noise_ratios);
    };
    const auto apply = [&](const Eigen::MatrixXd& w) -> Eigen::MatrixXd {
        return correlation_product(inputs, spectrum.inverse_length_scale, w, progress) +
               w * noise_ratios.asDiagonal();
    };
    const auto sizes = [](const Eigen::MatrixXd& r) -> Eigen::VectorXd {
        return r.cwiseAbs2().colwise().mean().cwiseSqrt();
    };
    Eigen::MatrixXd weights = precondition(outputs);
    Eigen::MatrixXd residuals = outputs - apply(weights);
    Eigen::MatrixXd preconditioned = precondition(residuals);
    Eigen::MatrixXd direction = preconditioned;
    Eigen::RowVectorXd energy = dots(residuals, preconditioned);
    for (int step = 0; step < most_steps; ++step) {
        if ((sizes(residuals).array() <= tolerances.array()).all()) {
            break;
        }
        const Eigen::MatrixXd applied = apply(direction);
        const Eigen::RowVectorXd length = ratios(energy, dots(direction, applied));
        weights += direction * length.asDiagonal();
        residuals -= applied * length.asDiagonal();
        preconditioned = precondition(residuals);
        const Eigen::RowVectorXd next = dots(residuals, preconditioned);
        direction = preconditioned + direction * ratios(next, energy).asDiagonal();
        energy = next;
    }
    residuals = outputs - apply(weights);  // (approximation-error): the steps have rounded theirs
    return {.weights = std::move(weights), .residuals = sizes(residuals)};
}

}  // namespace taut::gp
