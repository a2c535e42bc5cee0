// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace taut {

/// The null space of an equilibrium matrix A (columns of norm 1, or less at supports): tensions
/// that balance without loads. Singular values of A below 1e-5 count as zero: those of true states
/// of self-stress come out below 1e-8, the others of sensible nets above 1e-3.
///
/// Uses two LDL' factors of the Gram matrix A'A, which is sparse and positive semidefinite. A QR
/// decomposition would not square the singular values, but fills in: Eigen's takes 13 s for 3000
/// edges, this takes some milliseconds.
class SelfStress {
public:
    explicit SelfStress(const Eigen::SparseMatrix<double>& equilibrium_matrix);

    /// Independent states of self-stress: columns of A less its rank.
    [[nodiscard]] int count() const { return m_count; }

    /// An orthonormal basis of the states (columns x count()).
    [[nodiscard]] Eigen::MatrixXd basis() const;

    /// (A'A)^+ x for an x (columns) orthogonal to all states of self-stress, up to 1e-10 of the
    /// largest singular value squared.
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& x) const;

private:
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_factor;  ///< of A'A + zero_squared I
    Eigen::Index m_columns;
    int m_count = 0;
};

}  // namespace taut
