// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

#include "numerics/supernodal_factor.hpp"
#include "statics/nodal_factor.hpp"
#include "statics/stiffness_matrix.hpp"

namespace taut {

/// The factors K = L D L' of a stiffness. Nodes keep their order. The symbolic work is done on
/// construction. After that nothing is allocated, except for a large net.
///
/// Nets of some hundred nodes are solved thousands of times, and their columns are too short for
/// dense products: they use NodalFactor. Large nets use SupernodalFactor, whose dense products run
/// at the machine's peak, on all cores.
class StiffnessFactor {
public:
    explicit StiffnessFactor(const StiffnessMatrix& matrix);

    /// @return whether the matrix is positive definite; if not, there is no factor
    bool factorize(const StiffnessMatrix& matrix);
    [[nodiscard]] bool positive_definite() const { return m_positive_definite; }

    /// Overwrites a right-hand side (3 n_I) with K^-1 times it.
    void solve(Eigen::Ref<Eigen::VectorXd> x) const;

    /// D of each free node (3 x n_I): its stiffness with the nodes before it free to move [N/m].
    [[nodiscard]] const Eigen::Matrix3Xd& pivots() const;

    /// A net of at least this number of free nodes is large.
    static constexpr int large = 5000;

private:
    /// The supernodal factor, and the blocks of the matrix that it assembles.
    struct Large {
        /// A block K_ij of the matrix, i < j.
        struct Entry {
            int later;  ///< j
            int block;
        };

        SupernodalFactor factor;
        std::vector<std::vector<Entry>> entries;  ///< of each node i
        Eigen::Matrix3Xd pivots;

        [[nodiscard]] bool factorize(const StiffnessMatrix& matrix);
    };
    static Large large_factor(const StiffnessMatrix& matrix);

    std::variant<NodalFactor, Large> m_factor;
    bool m_positive_definite = false;
};

/// The stiffness of a net and its factor.
struct Stiffness {
    StiffnessMatrix matrix;
    StiffnessFactor factor;

    explicit Stiffness(const LocalNet& net) : matrix(net), factor(matrix) {}

    bool factorize() { return factor.factorize(matrix); }
    /// Whether some node is loose: the matrix is not positive definite, or only by rounding errors.
    [[nodiscard]] bool has_loose_nodes() const;
};

/// Below this share of a node's axial stiffness, a pivot is rounding error.
constexpr double smallest_relative_stiffness = 1e-12;

}  // namespace taut
