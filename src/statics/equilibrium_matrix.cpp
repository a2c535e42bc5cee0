// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/equilibrium_matrix.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "statics/edge_state.hpp"
#include "statics/self_stress.hpp"

namespace taut {

Eigen::SparseMatrix<double> equilibrium_matrix(const CableNet& net,
                                               const Eigen::Ref<const Points>& form,
                                               std::span<const int> edges) {
    check_form("form", net.node_count(), form);
    check_edges(net.edge_count(), edges);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(6 * edges.size());
    for (size_t column = 0; column < edges.size(); ++column) {
        const auto [s, t] = net.edges()[edges[column]];
        const Eigen::Vector3d vector = form.col(s) - form.col(t);
        if (vector.isZero(0.0)) {
            throw std::invalid_argument(fmt::format(
                "edge {} has both ends at one place, expected a length", edges[column]));
        }
        const Eigen::Vector3d direction = vector.normalized();
        for (int k = 0; k < 3; ++k) {
            if (const int i = net.free_index(s); i >= 0) {
                entries.emplace_back(3 * i + k, static_cast<int>(column), direction(k));
            }
            if (const int j = net.free_index(t); j >= 0) {
                entries.emplace_back(3 * j + k, static_cast<int>(column), -direction(k));
            }
        }
    }
    Eigen::SparseMatrix<double> matrix(Eigen::Index{3} * net.free_node_count(),
                                       static_cast<Eigen::Index>(edges.size()));
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

StressStates stress_states(const CableNet& net,
                           const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                           const Eigen::Ref<const Points>& form) {
    const auto states = edge_states(net, unstressed_lengths, form);
    std::vector<int> taut_edges;
    for (int e = 0; e < net.edge_count(); ++e) {
        if (states[e].carries()) {
            taut_edges.push_back(e);
        }
    }
    // Springs of elastic supports bear any force there, as rigid supports do.
    Eigen::SparseMatrix<double> matrix = equilibrium_matrix(net, form, taut_edges);
    int rows = 3 * net.free_node_count();
    if (!net.elastic_supports().empty()) {
        std::vector<bool> is_held(static_cast<size_t>(net.free_node_count()), false);
        for (const ElasticSupport& support : net.elastic_supports()) {
            is_held[net.free_index(support.node)] = true;
            rows -= 3;
        }
        matrix.prune([&is_held](Eigen::Index row, Eigen::Index, double) {
            return !is_held[static_cast<size_t>(row / 3)];
        });
    }
    const int self_stress = SelfStress(matrix).count();
    const int rank = static_cast<int>(taut_edges.size()) - self_stress;
    return {.rank = rank, .self_stress = self_stress, .mechanisms = rows - rank};
}

}  // namespace taut
