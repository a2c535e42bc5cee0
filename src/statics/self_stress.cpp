// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/self_stress.hpp"

#include <cmath>

#include "numerics/small_dense.hpp"

namespace taut {
namespace {

/// The square of a singular value that counts as zero. Far above the rounding errors of A'A.
constexpr double zero_squared = 1e-10;

}  // namespace

SelfStress::SelfStress(const Eigen::SparseMatrix<double>& equilibrium_matrix)
    : m_columns(equilibrium_matrix.cols()) {
    if (m_columns == 0) {
        return;
    }
    const Eigen::SparseMatrix<double> gram = equilibrium_matrix.transpose() * equilibrium_matrix;
    // Sylvester's law of inertia: A'A - zero_squared I has as many negative eigenvalues as its D
    // of LDL' has negative entries, and these are the singular values below the threshold.
    m_factor.analyzePattern(gram);
    m_factor.setShift(-zero_squared);
    m_factor.factorize(gram);
    m_count = static_cast<int>((m_factor.vectorD().array() < 0.0).count());
    m_factor.setShift(zero_squared);
    m_factor.factorize(gram);
}

Eigen::MatrixXd SelfStress::basis() const {
    // Inverse iteration: each round reduces components outside the null space by their squared
    // singular value over zero_squared, 1e4 and more.
    constexpr int rounds = 3;
    Eigen::MatrixXd vectors =
        Eigen::MatrixXd::NullaryExpr(m_columns, m_count, [](Eigen::Index i, Eigen::Index j) {
            // Start vectors without a pattern that a net could share.
            return std::sin(12.9898 * static_cast<double>(i + 1) + 78.233 * static_cast<double>(j) +
                            static_cast<double>((i + 1) * (j + 1) % 7919));
        });
    for (int round = 0; round < rounds && m_count > 0; ++round) {
        vectors = orthonormal_basis(m_factor.solve(vectors));
    }
    return vectors;
}

Eigen::VectorXd SelfStress::solve(const Eigen::VectorXd& x) const {
    return m_factor.solve(x);
}

}  // namespace taut
