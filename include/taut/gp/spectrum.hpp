// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut::gp {

/// The eigendecomposition R = Q diag(d) Q' of the correlation matrix of the training inputs. All
/// that a Gaussian process needs of K = sigma_f^2 R, for any sigma_f, sigma_w and any output,
/// follows from it in O(n^2): so one decomposition serves hundreds of outputs.
///
/// For more inputs than can be decomposed it holds the r largest directions, docs/theory.md
/// (low-rank), and the size of the others: R is about Q diag(d) Q' + tail_mean (I - Q Q'), and the
/// eigenvalues of R - Q diag(d) Q' are at most tail_largest.
struct KernelSpectrum {
    double inverse_length_scale = 0.0;  ///< lambda
    Eigen::VectorXd eigenvalues;   ///< d (r), ascending; rounding errors below zero set to zero
    Eigen::MatrixXd eigenvectors;  ///< Q (n x r), orthonormal columns
    double tail_mean = 0.0;        ///< of the n - r eigenvalues left out; 0 where r = n
    double tail_largest = 0.0;     ///< of these, by power iteration; 0 where r = n

    /// Whether r = n: nothing is left out.
    [[nodiscard]] bool is_whole() const { return eigenvectors.cols() == eigenvectors.rows(); }
};

/// Decomposes the correlation matrix at one lambda, in O(n^3).
/// @param squared_distances of all pairs of training inputs (n x n), symmetric, which is not
///   checked
/// @param inverse_length_scale lambda, in 1 / unit of the inputs
/// @throws std::invalid_argument where lambda is not positive and finite, or a distance not finite,
///   and for a matrix that is not square or empty
[[nodiscard]] TAUT_CORE_EXPORT KernelSpectrum kernel_spectrum(
    const Eigen::Ref<const Eigen::MatrixXd>& squared_distances, double inverse_length_scale);

}  // namespace taut::gp
