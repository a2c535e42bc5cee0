// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "taut/export/adjustment.hpp"
#include "taut/statics/cone_program.hpp"

namespace taut {

struct Cone {
    enum class Kind { nonnegative, second_order };
    Kind kind;
    int dimension;
};

/// Minimise x'Px/2 + q'x subject to Ax + s = b, s in the product of the cones.
struct ConicProgram {
    Eigen::SparseMatrix<double> P;  ///< upper triangle
    Eigen::VectorXd q;
    Eigen::SparseMatrix<double> A;
    Eigen::VectorXd b;
    std::vector<Cone> cones;
};

struct ConicSolution {
    Eigen::VectorXd x;
    Eigen::VectorXd z;  ///< multipliers: Px + q + A'z = 0
    ConeStatus status;
    int iterations;
    double primal_objective;
    double dual_objective;
    double primal_residual;
    double dual_residual;
};

/// @throws std::invalid_argument if taut was built without a conic solver
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT ConicSolution solve_conic(const ConicProgram& program,
                                                               int max_iterations);

}  // namespace taut
