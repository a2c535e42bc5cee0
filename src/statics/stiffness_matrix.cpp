// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/stiffness_matrix.hpp"

#include <algorithm>
#include <numeric>

namespace taut {

StiffnessMatrix::StiffnessMatrix(const LocalNet& net)
    : m_diagonal(net.free_count),
      m_starts(net.free_count + 1, 0),
      m_block_of_edge(net.edges.size(), -1),
      m_axial_at_nodes(net.free_count) {
    for (const Edge& edge : net.edges) {
        if (const int j = std::ranges::max(edge); j < net.free_count) {
            ++m_starts[j + 1];
        }
    }
    for (const SpringPair& pair : net.spring_pairs) {
        if (pair.edge < 0) {
            ++m_starts[pair.second + 1];
        }
    }
    std::partial_sum(m_starts.begin(), m_starts.end(), m_starts.begin());
    m_blocks.resize(m_starts.back());
    std::vector<size_t> next = m_starts;
    for (size_t e = 0; e < net.edges.size(); ++e) {
        const auto [i, j] = std::minmax(net.edges[e][0], net.edges[e][1]);
        if (j < net.free_count) {
            const size_t block = next[j]++;
            m_blocks[block].row = i;
            m_block_of_edge[e] = static_cast<int>(block);
        }
    }
    for (const SpringPair& pair : net.spring_pairs) {
        if (pair.edge >= 0) {
            m_block_of_pair.push_back(m_block_of_edge[pair.edge]);
            continue;
        }
        const size_t block = next[pair.second]++;
        m_blocks[block].row = pair.first;
        m_block_of_pair.push_back(static_cast<int>(block));
    }
}

void StiffnessMatrix::assemble(const LocalNet& net, const std::vector<EdgeState>& states) {
    std::ranges::fill(m_diagonal, Eigen::Matrix3d::Zero());
    m_axial_at_nodes.setZero();
    for (size_t e = 0; e < states.size(); ++e) {
        const EdgeState& state = states[e];
        const double across = state.force_density();
        Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
        if (state.carries()) {
            const double x = state.direction.x();
            const double y = state.direction.y();
            const double z = state.direction.z();
            const double along = state.axial - across;
            const double xy = along * (x * y);
            const double xz = along * (x * z);
            const double yz = along * (y * z);
            stiffness << along * (x * x) + across, xy, xz,  //
                xy, along * (y * y) + across, yz,           //
                xz, yz, along * (z * z) + across;
        }
        for (const int node : net.edges[e]) {
            if (node < net.free_count) {
                // where a tension law is flat, T / l is the only stiffness
                m_axial_at_nodes(node) += std::max(state.axial, across);
                m_diagonal[node] += stiffness;
            }
        }
        if (m_block_of_edge[e] >= 0) {
            m_blocks[m_block_of_edge[e]].values = -stiffness;
        }
    }
    for (const Spring& spring : net.springs) {
        m_axial_at_nodes(spring.node) += spring.stiffness.trace() / 3.0;
        m_diagonal[spring.node] += spring.stiffness;
    }
    for (size_t k = 0; k < net.spring_pairs.size(); ++k) {
        const SpringPair& pair = net.spring_pairs[k];
        Block& block = m_blocks[m_block_of_pair[k]];
        if (pair.edge < 0) {
            block.values.setZero();
        }
        block.values += pair.stiffness;
    }
}

void StiffnessMatrix::add_shift(double shift) {
    for (int node = 0; node < node_count(); ++node) {
        m_diagonal[node].diagonal().array() += shift * m_axial_at_nodes(node);
    }
}

Eigen::SparseMatrix<double> StiffnessMatrix::to_sparse() const {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(9 * (m_diagonal.size() + 2 * m_blocks.size()));
    const auto add = [&](int i, int j, const Eigen::Matrix3d& values) {
        for (int b = 0; b < 3; ++b) {
            for (int a = 0; a < 3; ++a) {
                entries.emplace_back(3 * i + a, 3 * j + b, values(a, b));
            }
        }
    };
    for (int j = 0; j < node_count(); ++j) {
        add(j, j, diagonal(j));
        for (const Block& block : column(j)) {
            add(block.row, j, block.values);
            add(j, block.row, block.values.transpose());
        }
    }
    Eigen::SparseMatrix<double> result(Eigen::Index{3} * node_count(),
                                       Eigen::Index{3} * node_count());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

}  // namespace taut
