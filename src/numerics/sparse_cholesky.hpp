// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <optional>
#include <vector>

#include "numerics/supernodal_factor.hpp"

namespace taut {

/// The factor of a sparse, symmetric, positive definite matrix for a few solutions: row by row for
/// small matrices, by supernodes on all cores for large ones.
class SparseCholesky {
public:
    /// @param matrix of which both triangles are given
    explicit SparseCholesky(const Eigen::SparseMatrix<double>& matrix);

    /// Whether no pivot was zero or less.
    [[nodiscard]] bool is_positive_definite() const;

    /// A^-1 b, column by column.
    [[nodiscard]] Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& b) const;

private:
    using RowByRow = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;
    struct Supernodal {
        std::vector<int> order;  ///< rows, the first to be eliminated first
        SupernodalFactor factor;
    };
    static std::optional<Supernodal> by_supernodes(const Eigen::SparseMatrix<double>& matrix);

    RowByRow m_row_by_row;
    std::optional<Supernodal> m_supernodal;
};

}  // namespace taut
