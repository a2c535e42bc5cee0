// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/stiffness_matrix.hpp"

#include <algorithm>

namespace taut {

StiffnessMatrix::StiffnessMatrix(const LocalNet& net)
    : m_rank(net.edges.size(), -1), m_axial_at_nodes(net.free_count) {
    const auto free_count = static_cast<size_t>(net.free_count);
    std::vector<std::vector<int>> lower(free_count);  // edges to smaller free neighbours
    for (size_t e = 0; e < net.edges.size(); ++e) {
        const auto [i, j] = std::minmax(net.edges[e][0], net.edges[e][1]);
        if (j < net.free_count) {
            lower[static_cast<size_t>(j)].push_back(static_cast<int>(e));
        }
    }
    const auto smaller_end = [&](int e) {
        return std::ranges::min(net.edges[static_cast<size_t>(e)]);
    };

    m_lower_neighbours.resize(free_count);
    Eigen::Index nonzeros = 0;
    for (size_t j = 0; j < free_count; ++j) {
        std::ranges::sort(lower[j], {}, smaller_end);
        m_lower_neighbours[j] = static_cast<int>(lower[j].size());
        nonzeros += 9 * m_lower_neighbours[j] + 6;
    }
    m_upper.resize(Eigen::Index{3} * net.free_count, Eigen::Index{3} * net.free_count);
    m_upper.reserve(nonzeros);
    for (size_t j = 0; j < free_count; ++j) {
        for (int b = 0; b < 3; ++b) {
            const int column = 3 * static_cast<int>(j) + b;
            m_upper.startVec(column);
            for (size_t k = 0; k < lower[j].size(); ++k) {
                m_rank[static_cast<size_t>(lower[j][k])] = static_cast<int>(k);
                for (int a = 0; a < 3; ++a) {
                    m_upper.insertBack(3 * smaller_end(lower[j][k]) + a, column) = 0.0;
                }
            }
            for (int a = 0; a <= b; ++a) {
                m_upper.insertBack(3 * static_cast<int>(j) + a, column) = 0.0;
            }
        }
    }
    m_upper.finalize();
}

double* StiffnessMatrix::diagonal_block_column(int node, int column) {
    return m_upper.valuePtr() + m_upper.outerIndexPtr()[3 * node + column] +
           3 * m_lower_neighbours[static_cast<size_t>(node)];
}

void StiffnessMatrix::assemble(const LocalNet& net, const std::vector<EdgeState>& states) {
    m_upper.coeffs().setZero();
    m_axial_at_nodes.setZero();
    for (size_t e = 0; e < states.size(); ++e) {
        const EdgeState& state = states[e];
        const auto [i, j] = std::minmax(net.edges[e][0], net.edges[e][1]);
        for (const int node : {i, j}) {
            if (node < net.free_count) {
                m_axial_at_nodes(node) += state.axial;
            }
        }
        if (!state.taut()) {
            continue;
        }
        const double across = state.force_density();
        Eigen::Matrix3d block =
            (state.axial - across) * state.direction * state.direction.transpose();
        block.diagonal().array() += across;
        for (const int node : {i, j}) {
            if (node < net.free_count) {
                for (int b = 0; b < 3; ++b) {
                    double* values = diagonal_block_column(node, b);
                    for (int a = 0; a <= b; ++a) {
                        values[a] += block(a, b);
                    }
                }
            }
        }
        if (j < net.free_count) {
            for (int b = 0; b < 3; ++b) {
                Eigen::Map<Eigen::Vector3d>(m_upper.valuePtr() +
                                            m_upper.outerIndexPtr()[3 * j + b] + 3 * m_rank[e]) -=
                    block.col(b);
            }
        }
    }
}

void StiffnessMatrix::add_shift(double shift) {
    for (int node = 0; node < m_axial_at_nodes.size(); ++node) {
        for (int b = 0; b < 3; ++b) {
            diagonal_block_column(node, b)[b] += shift * m_axial_at_nodes(node);
        }
    }
}

bool has_loose_nodes(const StiffnessMatrix& matrix, const StiffnessFactor& factor) {
    if (factor.info() != Eigen::Success) {
        return true;
    }
    const auto pivots = factor.pivots().reshaped(3, matrix.axial_at_nodes().size());
    return (pivots.colwise().minCoeff().transpose().array() <=
            smallest_relative_stiffness * matrix.axial_at_nodes().array())
        .any();
}

}  // namespace taut
