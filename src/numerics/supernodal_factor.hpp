// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "numerics/buffer.hpp"
#include "numerics/front.hpp"
#include "numerics/front_stacks.hpp"
#include "numerics/parallel.hpp"
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
/// The pivots are taken in panels of some blocks. Of an indefinite matrix D holds a dense block
/// F_pp a panel, of which the inverse is kept. It is inverted with row exchanges, but there are
/// none between panels: the order of the blocks is the caller's, and must be one in which A can be
/// eliminated block by block. A positive definite matrix is factorised by Cholesky's method.
///
/// Branches of the tree and parts of large products run in parallel. The results are the same for
/// any number of threads. benchmarks/bench_factorisation.cpp compares it with other solvers.
class SupernodalFactor {
public:
    /// @param sizes of the blocks, in the order of elimination; the unknowns are numbered block by
    ///   block
    /// @param couplings one list a block: later blocks that it may have entries with, each once
    SupernodalFactor(const std::vector<int>& sizes, const std::vector<std::vector<int>>& couplings,
                     Definiteness definiteness = Definiteness::indefinite);

    [[nodiscard]] int unknown_count() const { return static_cast<int>(m_number.size()); }

    /// Numbers that the factor stores, zeros included.
    [[nodiscard]] double entry_count() const;
    /// Floating-point operations of a factorisation: the sum of c^2 over the columns of the factor,
    /// c being the length of one, diagonal included.
    [[nodiscard]] double operation_count() const;

    /// Where the unknowns of a front stand in its dense matrix: those of its blocks and those of
    /// later blocks that they are coupled with. Unknowns of a block stand side by side,
    /// in their order, and later blocks behind earlier ones.
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
    /// front, of which the columns of the pivots are given. Is called in parallel for different
    /// fronts.
    using Assembly = std::function<void(int block, const Places&, FrontMatrix& columns)>;

    /// @return false where a pivot is singular, or not positive where the matrix should be definite
    [[nodiscard]] bool factorize(const Assembly& assemble);

    /// A^-1 b, after factorize().
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::Ref<const Eigen::VectorXd>& b) const;

    /// Of a definite matrix, after factorize(): D of each unknown for a diagonal L of ones, what is
    /// left of its entry when all unknowns before it are eliminated.
    [[nodiscard]] Eigen::VectorXd pivots() const;

    /// log |det A|, after factorize().
    [[nodiscard]] double log_determinant() const;

    /// Takes the inverse over the unknowns of a block's front, both triangles. Is called in
    /// parallel for different fronts.
    using Reader = std::function<void(int block, const Places&, const FrontMatrix& inverse)>;

    /// Shows every block its part of Z = A^-1, after factorize(), of an indefinite matrix. From the
    /// last front to the first (K. Takahashi, J. Fagan & M.-S. Chin, Formation of a sparse bus
    /// impedance matrix and its application to short circuit study, PICA 1973; A. M. Erisman & W.
    /// F. Tinney, On computing certain elements of the inverse of a sparse matrix, CACM 18 (1975)
    /// 177-179), for pivots p of a panel and all later unknowns q of the front:
    ///
    ///   Z_qp = -Z_qq L_qp,   Z_pp = F_pp^-1 - L_qp' Z_qp
    ///
    /// Z_qq is known by then: q is part of the parent's front.
    void selected_inverse(const Reader& read) const;

private:
    struct Front {
        Supernode supernode;
        std::vector<int> panels;  ///< first pivot of each panel, and the number of pivots
        size_t begin = 0;         ///< of its columns in m_values
        int level = 0;            ///< number of ancestors
        int branch = -1;          ///< whose root it is; -1: of none

        [[nodiscard]] Eigen::Index size() const { return supernode.size + row_count(); }
        [[nodiscard]] Eigen::Index row_count() const { return std::ssize(supernode.rows); }
    };
    /// Memory that several fronts need while they are eliminated or inverted.
    struct Needs {
        FrontStacks::Heights heights{};
        size_t scratch = 0;

        void cover(const Needs& other);
    };
    struct Workspace {
        FrontStacks stacks;
        Buffer scratch;
        std::vector<const double*> updates;  ///< of the children of the front in work

        void prepare(const Needs& needs);
    };

    /// The columns of the factor of a front, (p + q) x p.
    [[nodiscard]] FrontMatrix factor_of(const Front& front) const;
    [[nodiscard]] Needs needs_of(const std::vector<int>& fronts) const;
    [[nodiscard]] Needs needs_of_inverse(const std::vector<int>& fronts) const;
    [[nodiscard]] bool eliminate(const Front& front, const Assembly& assemble, FrontMatrix& U,
                                 Workspace& workspace, Parts parts);
    [[nodiscard]] bool eliminate(const std::vector<int>& fronts, const Assembly& assemble,
                                 Workspace& workspace, Parts parts);
    [[nodiscard]] bool eliminate_branch(int branch, const Assembly& assemble);

    void finish_inverse(const Front& front, FrontMatrix& Z, Parts parts) const;
    void show(const Front& front, const FrontMatrix& Z, const Reader& read) const;
    void invert(int front, const Reader& read, std::vector<Buffer>& inverses) const;
    void invert_branch(const std::vector<int>& fronts, const Reader& read,
                       std::vector<Buffer>& inverses, FrontStacks& stacks) const;

    Definiteness m_definiteness;
    std::vector<int> m_number;  ///< of each unknown, in the order of the fronts' pivots
    std::vector<Front> m_fronts;
    std::vector<std::vector<int>> m_branches;  ///< their fronts, children before parents
    std::vector<int> m_trunk;                  ///< all others
    Needs m_branch_needs;                      ///< of any branch
    Needs m_trunk_needs;
    Buffer m_values;  ///< the factor, front by front

    // Memory that is reused by the next factorisation.
    std::vector<Buffer> m_branch_updates;  ///< of the roots of the branches
    Workspace m_trunk_workspace;
    PerThread<Workspace> m_branch_workspaces;
};

}  // namespace taut
