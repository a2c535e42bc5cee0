// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

namespace taut {

/// The pattern of a symmetric matrix: for each row the other rows that it has entries with.
struct MatrixGraph {
    std::vector<int> starts;      ///< of each row in `neighbours`; one more at the end
    std::vector<int> neighbours;  ///< row by row, without the row itself

    [[nodiscard]] int row_count() const { return static_cast<int>(starts.size()) - 1; }
};

/// The graph of rows that are joined in pairs, each pair given once.
[[nodiscard]] MatrixGraph graph_of(int row_count, const std::vector<std::array<int, 2>>& pairs);

/// How much time an order may take.
enum class Ordering {
    quick,     ///< by minimum degree (AMD), a tenth of the time of a factorisation
    thorough,  ///< by nested dissection (METIS) where that pays: for matrices of many unknowns a
               ///< row
};

/// An order of elimination in which the factor of a symmetric matrix stays sparse.
///
/// Nested dissection (A. George, Nested dissection of a regular finite element mesh, SIAM J. Numer.
/// Anal. 10 (1973) 345-363; G. Karypis & V. Kumar, A fast and high quality multilevel scheme for
/// partitioning irregular graphs, SIAM J. Sci. Comput. 20 (1998) 359-392) leaves a quarter less
/// work than minimum degree on a net of 300 x 300 nodes. For three unknowns a node that is less
/// than the order costs; for the six of a saddle-point matrix, whose inverse is wanted, too, it is
/// more. By `bench_factorisation --benchmark_filter=order`.
///
/// @return rows, the first to be eliminated first
[[nodiscard]] std::vector<int> elimination_order(const MatrixGraph& graph, Ordering ordering);

}  // namespace taut
