// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/gp/spectrum.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "numerics/dense.hpp"
#include "taut/gp/kernel.hpp"

namespace taut::gp {

KernelSpectrum kernel_spectrum(const Eigen::Ref<const Eigen::MatrixXd>& squared_distances,
                               double inverse_length_scale) {
    if (!std::isfinite(inverse_length_scale) || inverse_length_scale <= 0.0) {
        throw std::invalid_argument(
            fmt::format("inverse length scale is {}, expected a positive and finite number",
                        inverse_length_scale));
    }
    if (squared_distances.rows() != squared_distances.cols() || squared_distances.rows() == 0) {
        throw std::invalid_argument(
            fmt::format("squared distances of {} x {} pairs, expected a square matrix",
                        squared_distances.rows(), squared_distances.cols()));
    }
    if (!squared_distances.allFinite()) {
        throw std::invalid_argument("the training inputs hold a number that is not finite");
    }
    SymmetricEigen eigen = symmetric_eigen(correlation(squared_distances, inverse_length_scale));
    return {.inverse_length_scale = inverse_length_scale,
            .eigenvalues = eigen.values.cwiseMax(0.0),
            .eigenvectors = std::move(eigen.vectors)};
}

}  // namespace taut::gp
