// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "statics/edge_state.hpp"
#include "statics/local_net.hpp"

namespace taut {

/// The stiffness of a net in blocks of 3 x 3, one for each free node, and one for each pair of them
/// that an edge or a frame joins: the upper triangle, column by column.
class StiffnessMatrix {
public:
    /// K_ij of the free nodes i < j.
    struct Block {
        int row;  ///< i
        Eigen::Matrix3d values;
    };

    explicit StiffnessMatrix(const LocalNet& net);

    /// Sets all entries from the states of all edges (taut/statics/energy.hpp).
    void assemble(const LocalNet& net, const std::vector<EdgeState>& states);

    /// Adds shift times its axial stiffness (the sum of EA/l_0 of its edges) to each node's
    /// diagonal.
    void add_shift(double shift);

    [[nodiscard]] int node_count() const { return static_cast<int>(m_diagonal.size()); }
    [[nodiscard]] const Eigen::Matrix3d& diagonal(int node) const { return m_diagonal[node]; }
    /// K_ij of a column j for its neighbours i < j, unordered.
    [[nodiscard]] std::span<const Block> column(int node) const {
        const auto j = static_cast<size_t>(node);
        return {m_blocks.data() + m_starts[j], m_blocks.data() + m_starts[j + 1]};
    }
    /// The blocks of all columns, one after the other.
    [[nodiscard]] std::span<const Block> blocks() const { return m_blocks; }
    /// Both triangles (3 n_I x 3 n_I) [N/m].
    [[nodiscard]] Eigen::SparseMatrix<double> to_sparse() const;
    /// Sum of EA/l_0 of the edges at each free node, and the mean stiffness of its spring, as last
    /// assembled [N/m].
    [[nodiscard]] const Eigen::VectorXd& axial_at_nodes() const { return m_axial_at_nodes; }

private:
    std::vector<Eigen::Matrix3d> m_diagonal;
    std::vector<Block> m_blocks;
    std::vector<size_t> m_starts;      ///< of each column in m_blocks; one more at the end
    std::vector<int> m_block_of_edge;  ///< -1 for an edge at a support
    std::vector<int> m_block_of_pair;  ///< of LocalNet::spring_pairs
    Eigen::VectorXd m_axial_at_nodes;
};

}  // namespace taut
