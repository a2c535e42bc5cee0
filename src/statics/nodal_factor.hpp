// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "statics/stiffness_matrix.hpp"

namespace taut {

/// The factors K = L D L' of the stiffness of a small net, L in blocks of 3 x 3, found row by row
/// (T. A. Davis, Direct Methods for Sparse Linear Systems, SIAM 2006, sections 4.1 to 4.7). Nodes
/// keep their order. The symbolic work and all allocation are done on construction.
class NodalFactor {
public:
    explicit NodalFactor(const StiffnessMatrix& matrix);

    /// @return whether the matrix is positive definite; if not, there is no factor
    [[nodiscard]] bool factorize(const StiffnessMatrix& matrix);

    /// Overwrites a right-hand side (3 n_I) with K^-1 times it.
    void solve(Eigen::Ref<Eigen::VectorXd> x) const;

    /// D of each free node (3 x n_I): its stiffness with the nodes before it free to move [N/m].
    [[nodiscard]] const Eigen::Matrix3Xd& pivots() const { return m_pivots; }

private:
    /// 3 x 3 with a row of zeros below, so that a column is one whole packet.
    using Padded = Eigen::Matrix<double, 4, 3>;
    /// L_jj, below its diagonal of ones, and D_j.
    struct Diagonal {
        double l10 = 0.0;
        double l20 = 0.0;
        double l21 = 0.0;
        Eigen::Array3d inverse_pivots;  ///< 1 / D_j
    };
    /// L_ij, i > j.
    struct Block {
        Padded values;
        int row;  ///< i
    };

    static void subtract_products(const Block* begin, const Block* end, const Eigen::Matrix3d& S,
                                  Padded* rows);
    [[nodiscard]] size_t row_pattern(const StiffnessMatrix& matrix, int row);

    std::vector<int> m_parents;        ///< in the elimination tree; -1 for a root
    std::vector<size_t> m_starts;      ///< of each column in m_blocks; one more at the end
    std::vector<Block> m_blocks;       ///< below the diagonal, column by column
    std::vector<Diagonal> m_diagonal;  ///< L_jj and D_j
    Eigen::Matrix3Xd m_pivots;

    // workspace of factorize()
    std::vector<size_t> m_ends;  ///< of the blocks found so far in each column
    std::vector<Padded> m_row;   ///< entries of the current row, by column
    std::vector<int> m_pattern;  ///< columns of the current row, filled from the end
    std::vector<int> m_visited;  ///< last row that visited each column
};

}  // namespace taut
