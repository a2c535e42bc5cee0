// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "numerics/parts.hpp"

namespace taut {

/// What is known of a symmetric matrix whose factor is asked for.
enum class Definiteness { positive_definite, indefinite };

/// A dense matrix in memory of its owner, by columns.
using FrontMatrix = Eigen::Map<Eigen::MatrixXd>;

/// Eliminates the p pivots of a dense symmetric matrix [F_pp F_qp'; F_qp ...] of which the lower
/// triangle is given, panel by panel.
///
/// @param panels where they begin among the pivots, and the end
/// @param pivots F_pp and below it F_qp, (p + q) x p; becomes the columns of the factor: of a
///   definite matrix L with L L' = F, else for each panel the inverse of its pivot on the
///   diagonal, and below it L with L D L' = F, D holding the pivots
/// @param update q x q, becomes -F_qp F_pp^-1 F_qp': its lower triangle
/// @param scratch room for (p + q) p numbers where the matrix is indefinite
/// @return false where a pivot is singular, or not positive where the matrix should be definite
[[nodiscard]] bool eliminate_pivots(Definiteness definiteness, const std::vector<int>& panels,
                                    FrontMatrix& pivots, FrontMatrix& update, double* scratch,
                                    Parts parts);

}  // namespace taut
