// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "statics/edge_state.hpp"
#include "statics/local_net.hpp"

namespace taut {

/// The upper triangle of the stiffness of a net, with a fixed pattern and a fast way into its
/// values. Column 3j+b holds, for each free neighbour i < j in ascending order, the three rows of
/// node i, and then the rows 3j .. 3j+b: so the place of every entry follows from its neighbour's
/// rank.
class StiffnessMatrix {
public:
    explicit StiffnessMatrix(const LocalNet& net);

    /// Sets all entries from the states of all edges (eq. in statics/energy.hpp).
    void assemble(const LocalNet& net, const std::vector<EdgeState>& states);

    /// Adds shift times its axial stiffness (the sum of EA/l_0 of its edges) to each node's
    /// diagonal.
    void add_shift(double shift);

    [[nodiscard]] const Eigen::SparseMatrix<double>& upper() const { return m_upper; }
    /// Sum of EA/l_0 of the edges at each free node, as last assembled [N/m].
    [[nodiscard]] const Eigen::VectorXd& axial_at_nodes() const { return m_axial_at_nodes; }

private:
    [[nodiscard]] double* diagonal_block_column(int node, int column);

    Eigen::SparseMatrix<double> m_upper;
    std::vector<int> m_lower_neighbours;  ///< number of free neighbours i < j of each free node j
    std::vector<int> m_rank;              ///< of each edge's smaller end among its larger end's
    Eigen::VectorXd m_axial_at_nodes;
};

/// Below this part of a node's axial stiffness, stiffness is rounding error.
constexpr double smallest_relative_stiffness = 1e-12;

/// LDL' for matrices that are ordered already: works in place on the pattern, without copies.
class StiffnessFactor : public Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper,
                                                     Eigen::NaturalOrdering<int>> {
public:
    /// D, one a row: all positive for a positive definite matrix.
    [[nodiscard]] const Eigen::VectorXd& pivots() const { return m_diag; }

    [[nodiscard]] bool positive_definite() const {
        return info() == Eigen::Success && m_diag.minCoeff() > 0.0;
    }
};

/// Whether the factor of this matrix tells that some node is loose: it is not positive definite, or
/// only by rounding errors.
[[nodiscard]] bool has_loose_nodes(const StiffnessMatrix& matrix, const StiffnessFactor& factor);

}  // namespace taut
