// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace taut {

/// The covariance of few samples in many dimensions, shrunk towards independent coordinates of
/// unequal variances (Schaefer & Strimmer, A shrinkage approach to large-scale covariance matrix
/// estimation, Stat. Appl. Genet. Mol. Biol. 4(1), 2005, article 32: their target D and eq. 10).
///
/// With the products w_kij = x_ki x_kj of the n centred samples and their means w_ij over k,
///
///   s_ij = n / (n - 1) w_ij,   Var(s_ij) = n / (n - 1)^3 sum_k (w_kij - w_ij)^2,
///   a = sum_(i != j) Var(s_ij) / sum_(i != j) s_ij^2, clamped to [0, 1]:
///
/// the result is s_ii on the diagonal and (1 - a) s_ij off it. a is the share of the off-diagonal
/// entries that is chance; it is 1 if all of them are zero.
/// @param centred x, one column a sample, the mean of each row zero (d x n)
/// @return d x d
[[nodiscard]] Eigen::MatrixXd shrunk_covariance(const Eigen::MatrixXd& centred);

}  // namespace taut
