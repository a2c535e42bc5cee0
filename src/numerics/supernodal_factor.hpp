// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "numerics/supernodes.hpp"
#include "numerics/tree_branches.hpp"

namespace taut {

/// The factor A = L D L' of a sparse symmetric matrix whose unknowns come in blocks, and the
/// entries of its inverse where the factor has entries.
///
/// The method is multifrontal (I. S. Duff & J. K. Reid, The multifrontal solution of indefinite
/// sparse symmetric linear equations, ACM TOMS 9 (1983) 302-325; T. A. Davis, Direct Methods for
/// Sparse Linear Systems, SIAM 2006, section 4.9). A supernode with pivots p and later unknowns q
/// gathers its entries of A and the updates of its children in a dense matrix F, its front, and
/// leaves an update for its parent:
///
///   L_qp = F_qp F_pp^-1,   U = F_qq - L_qp F_pq
///
/// The pivots are taken in panels of some blocks; D holds a dense block F_pp a panel, of which the
/// inverse is kept. It is inverted with row exchanges, so A may be indefinite. But there are none
/// between panels: the order of the blocks is the caller's, and must be one in which A can be
/// eliminated block by block.
///
/// Branches of the tree, and parts of large products, are worked on in parallel; results are the
/// same for any number of threads. What it is measured against:
/// benchmarks/bench_factorisation.cpp.
class SupernodalFactor {
public:
    /// @param sizes of the blocks, in the order of elimination; the unknowns are numbered block by
    ///   block
    /// @param couplings one list a block: unknowns of later blocks that it may have entries with
    SupernodalFactor(const std::vector<int>& sizes, std::vector<std::vector<int>> couplings);

    [[nodiscard]] int unknown_count() const { return static_cast<int>(m_number.size()); }

    /// Where the unknowns of a front stand in its dense matrix: those of its blocks and those of
    /// later blocks that they are coupled with. Unknowns of a block stand side by side, in their
    /// order, and later blocks behind earlier ones.
    class Places {
    public:
        Places(const Supernode& supernode, const std::vector<int>& number)
            : m_supernode(supernode), m_number(number) {}
        [[nodiscard]] int of(int unknown) const { return m_supernode.place_of(m_number[unknown]); }

    private:
        const Supernode& m_supernode;
        const std::vector<int>& m_number;
    };

    /// Adds the entries of a block with itself and with later blocks to the lower triangle of its
    /// front. Is called in parallel for different fronts.
    using Assembly = std::function<void(int block, const Places&, Eigen::MatrixXd& front)>;

    /// @return false where a pivot is singular
    [[nodiscard]] bool factorize(const Assembly& assemble);

    /// A^-1 b, after factorize().
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::Ref<const Eigen::VectorXd>& b) const;

    /// Takes the inverse over the unknowns of a block's front, both triangles. Is called in
    /// parallel for different fronts.
    using Reader = std::function<void(int block, const Places&, const Eigen::MatrixXd& inverse)>;

    /// Shows every block its part of Z = A^-1, after factorize(). From the last front to the first
    /// (K. Takahashi, J. Fagan & M.-S. Chin, Formation of a sparse bus impedance matrix and its
    /// application to short circuit study, PICA 1973; A. M. Erisman & W. F. Tinney, On computing
    /// certain elements of the inverse of a sparse matrix, CACM 18 (1975) 177-179), for pivots p of
    /// a panel and all later unknowns q of the front:
    ///
    ///   Z_qp = -Z_qq L_qp,   Z_pp = F_pp^-1 - L_qp' Z_qp
    ///
    /// Z_qq is known by then: q is part of the parent's front.
    void selected_inverse(const Reader& read) const;

private:
    /// A supernode, where its panels begin among its pivots (and the end), and their factor.
    struct Front {
        Supernode supernode;
        std::vector<int> panels;
        /// The columns of the pivots: for each panel the inverse of its pivot on the diagonal, and
        /// below it L.
        Eigen::MatrixXd factor;
    };
    [[nodiscard]] bool eliminate(int front, const Assembly& assemble,
                                 std::vector<Eigen::MatrixXd>& matrices);
    void invert(int front, const Reader& read, std::vector<Eigen::MatrixXd>& inverses) const;

    std::vector<int> m_number;  ///< of each unknown, in the order of the fronts' pivots
    std::vector<Front> m_fronts;
    TreeBranches m_branches;
};

}  // namespace taut
