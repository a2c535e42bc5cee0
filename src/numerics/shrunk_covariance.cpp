// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/shrunk_covariance.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/dense.hpp"

namespace taut {

Eigen::MatrixXd shrunk_covariance(const Eigen::MatrixXd& centred) {
    const auto n = static_cast<double>(centred.cols());
    const Eigen::MatrixXd mean_product = gram(centred.transpose()) / n;
    // For the products w = x_i x_j: sum (w - mean w)^2 = sum w^2 - n (mean w)^2.
    const Eigen::MatrixXd spread =
        gram(centred.cwiseAbs2().transpose()) - n * mean_product.cwiseAbs2();
    const double unbiased = n / std::max(1.0, n - 1.0);
    const double chance =
        std::pow(unbiased, 3) / (n * n) * (spread.sum() - spread.diagonal().sum());
    const double all =
        unbiased * unbiased * (mean_product.squaredNorm() - mean_product.diagonal().squaredNorm());
    const double part = all > 0.0 ? std::clamp(chance / all, 0.0, 1.0) : 1.0;
    Eigen::MatrixXd result = (1.0 - part) * unbiased * mean_product;
    result.diagonal() = unbiased * mean_product.diagonal();
    return result;
}

}  // namespace taut
