// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "statics/stiffness_matrix.hpp"

namespace taut {

/// The factors K = L D L' of a stiffness, L in blocks of 3 x 3, found row by row (T. A. Davis,
/// Direct Methods for Sparse Linear Systems, SIAM 2006, sections 4.1 to 4.7). Nodes keep their
/// order. The symbolic work is done on construction; after that nothing is allocated.
///
/// Why taut has its own: nets of some hundred nodes are solved thousands of times, and their
/// columns are too short for dense products. By `bench_factorisation --benchmark_filter=stiffness`,
/// times its time for factor and one solution (one core):
///
///                                        built-in net   hypar:30x30   100x100   300x300
///   Eigen SimplicialLDLT, not in blocks       2.3           2.6          2.7       3.4
///   numerics/supernodal_factor.hpp            4.8           2.4          1.0       0.5
///
/// So the supernodal factor does not replace it: what it gains begins beyond 10,000 nodes.
class StiffnessFactor {
public:
    explicit StiffnessFactor(const StiffnessMatrix& matrix);

    /// @return whether the matrix is positive definite; if not, there is no factor
    bool factorize(const StiffnessMatrix& matrix);
    [[nodiscard]] bool positive_definite() const { return m_positive_definite; }

    /// Overwrites a right-hand side (3 n_I) with K^-1 times it.
    void solve(Eigen::Ref<Eigen::VectorXd> x) const;

    /// D of each free node (3 x n_I): what is left of its stiffness when the nodes before it are
    /// free to move [N/m].
    [[nodiscard]] const Eigen::Matrix3Xd& pivots() const { return m_pivots; }

private:
    /// L_ij, i > j.
    struct Block {
        int row;  ///< i
        Eigen::Matrix3d values;
    };

    [[nodiscard]] size_t row_pattern(const StiffnessMatrix& matrix, int row);

    std::vector<int> m_parents;               ///< in the elimination tree; -1 for a root
    std::vector<size_t> m_starts;             ///< of each column in m_blocks; one more at the end
    std::vector<Block> m_blocks;              ///< below the diagonal, column by column
    std::vector<Eigen::Matrix3d> m_diagonal;  ///< L_jj, below a diagonal of ones
    Eigen::Matrix3Xd m_pivots;
    bool m_positive_definite = false;

    // work space of factorize()
    std::vector<size_t> m_ends;          ///< of the blocks found so far, of each column
    std::vector<Eigen::Matrix3d> m_row;  ///< of the row in work, at each column
    std::vector<int> m_pattern;          ///< columns of the row in work, last ones first
    std::vector<int> m_visited;          ///< last row that came to each column
};

/// The stiffness of a net and its factor.
struct Stiffness {
    StiffnessMatrix matrix;
    StiffnessFactor factor;

    explicit Stiffness(const LocalNet& net) : matrix(net), factor(matrix) {}

    bool factorize() { return factor.factorize(matrix); }
    /// Whether the factor tells that some node is loose: the matrix is not positive definite, or
    /// only by rounding errors.
    [[nodiscard]] bool has_loose_nodes() const;
};

/// Below this part of a node's axial stiffness, stiffness is rounding error.
constexpr double smallest_relative_stiffness = 1e-12;

}  // namespace taut
