// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/elimination_order.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <numeric>

#include "numerics/nested_dissection.hpp"

namespace taut {
namespace {

/// Below this number of rows, nested dissection leaves no less work than minimum degree.
constexpr int smallest_to_dissect = 5000;

std::vector<int> by_minimum_degree(const MatrixGraph& graph) {
    // Rows without a diagonal entry would be left for last.
    std::vector<Eigen::Triplet<char>> entries;
    entries.reserve(graph.neighbours.size() + graph.starts.size());
    for (int row = 0; row < graph.row_count(); ++row) {
        entries.emplace_back(row, row, 1);
        for (int k = graph.starts[row]; k < graph.starts[row + 1]; ++k) {
            entries.emplace_back(row, graph.neighbours[k], 1);
        }
    }
    Eigen::SparseMatrix<char> pattern(graph.row_count(), graph.row_count());
    pattern.setFromTriplets(entries.begin(), entries.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(pattern, order);
    return {order.indices().begin(), order.indices().end()};
}

}  // namespace

MatrixGraph graph_of(int row_count, const std::vector<std::array<int, 2>>& pairs) {
    MatrixGraph graph{.starts = std::vector<int>(row_count + 1, 0),
                      .neighbours = std::vector<int>(2 * pairs.size())};
    for (const auto& [a, b] : pairs) {
        ++graph.starts[a + 1];
        ++graph.starts[b + 1];
    }
    std::partial_sum(graph.starts.begin(), graph.starts.end(), graph.starts.begin());
    std::vector<int> next(graph.starts.begin(), graph.starts.end() - 1);
    for (const auto& [a, b] : pairs) {
        graph.neighbours[next[a]++] = b;
        graph.neighbours[next[b]++] = a;
    }
    return graph;
}

std::vector<int> elimination_order(const MatrixGraph& graph, Ordering ordering) {
    if (ordering == Ordering::thorough && graph.row_count() >= smallest_to_dissect) {
        if (std::vector<int> order = nested_dissection(graph); !order.empty()) {
            return order;
        }
    }
    return by_minimum_degree(graph);
}

}  // namespace taut
