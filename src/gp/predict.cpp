// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <stdexcept>

#include "gp/dense.hpp"
#include "taut/gp/fit.hpp"

namespace taut::gp {

Prediction FittedProcesses::predict(const Eigen::Ref<const Eigen::MatrixXd>& at) const {
    if (at.rows() != inputs.rows()) {
        throw std::invalid_argument(fmt::format(
            "inputs of dimension {}, expected {} as in training", at.rows(), inputs.rows()));
    }
    if (!at.allFinite()) {
        throw std::invalid_argument("the inputs hold a number that is not finite");
    }
    const auto m = static_cast<Eigen::Index>(processes.size());
    Prediction result{.mean = Eigen::MatrixXd::Zero(m, at.cols()),
                      .std = Eigen::MatrixXd::Zero(m, at.cols())};
    const Eigen::MatrixXd distances = squared_distances(inputs, at);
    for (size_t s = 0; s < spectra.size(); ++s) {
        const KernelSpectrum& spectrum = spectra[s];
        // k(x_*) / sigma_f^2, and the same in the basis of the spectrum.
        const Eigen::MatrixXd k = correlation(distances, spectrum.inverse_length_scale);
        const Eigen::MatrixXd squared = transposed_product(spectrum.eigenvectors, k).cwiseAbs2();
        for (Eigen::Index j = 0; j < m; ++j) {
            const Process& process = processes[static_cast<size_t>(j)];
            if (process.spectrum != static_cast<int>(s)) {
                continue;
            }
            const Hyperparameters& theta = process.hyperparameters;
            const double noise_ratio =
                theta.noise_std * theta.noise_std / (theta.signal_std * theta.signal_std);
            const Eigen::RowVectorXd explained =
                (spectrum.eigenvalues.array() + noise_ratio).inverse().matrix().transpose() *
                squared;
            result.mean.row(j) = weights.col(j).transpose() * k;
            result.std.row(j) = theta.signal_std * (1.0 - explained.array()).cwiseMax(0.0).sqrt();
        }
    }
    return result;
}

}  // namespace taut::gp
