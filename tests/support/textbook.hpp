// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "taut/gp/kernel.hpp"

/// A Gaussian process by the textbook's formulas, entry by entry and with one dense Cholesky
/// factorisation: slow, and a reference if the covariance is well conditioned.
namespace taut::test {

inline Eigen::MatrixXd normal_matrix(Eigen::Index rows, Eigen::Index cols, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal;
    return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return normal(engine); });
}

/// sigma_f^2 exp(-lambda^2 / 2 |x_i - z_j|^2), eq. SEkernel_iso.
inline Eigen::MatrixXd textbook_kernel(const Eigen::MatrixXd& x, const Eigen::MatrixXd& z,
                                       const gp::Hyperparameters& theta) {
    return Eigen::MatrixXd::NullaryExpr(x.cols(), z.cols(), [&](Eigen::Index i, Eigen::Index j) {
        const double scaled = theta.inverse_length_scale * (x.col(i) - z.col(j)).norm();
        return theta.signal_std * theta.signal_std * std::exp(-0.5 * scaled * scaled);
    });
}

inline Eigen::LLT<Eigen::MatrixXd> textbook_covariance(const Eigen::MatrixXd& inputs,
                                                       const gp::Hyperparameters& theta) {
    Eigen::MatrixXd K = textbook_kernel(inputs, inputs, theta);
    K.diagonal().array() += theta.noise_std * theta.noise_std;
    return K.llt();
}

/// 1/2 y' C^-1 y + 1/2 log det C + n/2 log 2 pi.
inline double textbook_negative_log_likelihood(const Eigen::MatrixXd& inputs,
                                               const Eigen::VectorXd& y,
                                               const gp::Hyperparameters& theta) {
    const Eigen::LLT<Eigen::MatrixXd> C = textbook_covariance(inputs, theta);
    return 0.5 * y.dot(C.solve(y)) + C.matrixLLT().diagonal().array().log().sum() +
           0.5 * static_cast<double>(y.size()) * std::log(2.0 * std::numbers::pi);
}

struct TextbookPrediction {
    Eigen::VectorXd mean;
    Eigen::VectorXd std_dev;
};

/// Eqs. mx_* and sigmax_* with zero mean function, at the columns of `at`.
inline TextbookPrediction textbook_prediction(const Eigen::MatrixXd& inputs,
                                              const Eigen::VectorXd& y,
                                              const gp::Hyperparameters& theta,
                                              const Eigen::MatrixXd& at) {
    const Eigen::LLT<Eigen::MatrixXd> C = textbook_covariance(inputs, theta);
    const Eigen::MatrixXd k = textbook_kernel(inputs, at, theta);
    const Eigen::VectorXd explained = k.cwiseProduct(C.solve(k)).colwise().sum().transpose();
    const double variance = theta.signal_std * theta.signal_std;
    return {.mean = k.transpose() * C.solve(y),
            .std_dev = (variance - explained.array()).cwiseMax(0.0).sqrt()};
}

}  // namespace taut::test
