// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/design/force_density.hpp"

#include <fmt/core.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "numerics/sparse_cholesky.hpp"

namespace taut {
namespace {

void check_node(Eigen::Index node, Eigen::Index count, const char* where) {
    if (node < 0 || node >= count) {
        throw std::invalid_argument(
            fmt::format("{} names node {}, expected one of the {} nodes", where, node, count));
    }
}

/// The first row that no path through the matrix joins to one of the given rows, or -1.
int first_row_not_joined(const Eigen::SparseMatrix<double>& matrix, std::vector<int> joined) {
    std::vector<bool> seen(matrix.rows(), false);
    while (!joined.empty()) {
        const int row = joined.back();
        joined.pop_back();
        if (seen[row]) {
            continue;
        }
        seen[row] = true;
        for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, row); it; ++it) {
            joined.push_back(static_cast<int>(it.index()));
        }
    }
    const auto missing = std::ranges::find(seen, false);
    return missing == seen.end() ? -1 : static_cast<int>(missing - seen.begin());
}

Eigen::MatrixX3d solve(const Eigen::SparseMatrix<double>& laplacian, const Eigen::MatrixX3d& rhs) {
    const auto check = [](bool is_definite) {
        if (!is_definite) {
            throw std::invalid_argument("force densities differ by too many orders of magnitude");
        }
    };
    // Above this size the supernodal factor pays. Smaller nets keep Eigen's: another one would
    // change the last digits of their nodes, and so the fingerprints of the built-in nets.
    constexpr Eigen::Index large = 100'000;
    if (laplacian.rows() > large) {
        const SparseCholesky factor(laplacian);
        check(factor.is_positive_definite());
        return factor.solve(rhs);
    }
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor(laplacian);
    check(factor.info() == Eigen::Success);
    return factor.solve(rhs);
}

}  // namespace

Points form_from_force_densities(const Eigen::Ref<const Points>& nodes,
                                 const std::vector<int>& supports, const std::vector<Edge>& edges,
                                 const Eigen::Ref<const Eigen::VectorXd>& force_densities,
                                 const Eigen::Ref<const Points>& loads) {
    if (force_densities.size() != static_cast<Eigen::Index>(edges.size())) {
        throw std::invalid_argument(fmt::format("force_densities has {} entries, expected {}",
                                                force_densities.size(), edges.size()));
    }
    if (loads.cols() != 0 && loads.cols() != nodes.cols()) {
        throw std::invalid_argument(
            fmt::format("loads has {} columns, expected {} or none", loads.cols(), nodes.cols()));
    }
    if (!loads.allFinite()) {
        throw std::invalid_argument("loads holds a number that is not finite");
    }
    std::vector<int> row(nodes.cols(), 0);
    for (const int support : supports) {
        check_node(support, nodes.cols(), "supports");
        if (!nodes.col(support).allFinite()) {
            throw std::invalid_argument(
                fmt::format("nodes has ({}, {}, {}) at support {}, expected finite coordinates",
                            nodes(0, support), nodes(1, support), nodes(2, support), support));
        }
        row[support] = -1;
    }
    int free_count = 0;
    for (int& r : row) {
        if (r == 0) {
            r = free_count++;
        }
    }

    // D r_free = p - D_support r_support, with D the Laplacian weighted by force densities.
    Eigen::MatrixX3d rhs = Eigen::MatrixX3d::Zero(free_count, 3);
    std::vector<int> supported_rows;  // of free nodes with an edge to a support
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * edges.size());
    for (size_t e = 0; e < edges.size(); ++e) {
        const double q = force_densities(static_cast<Eigen::Index>(e));
        if (!std::isfinite(q) || q <= 0.0) {
            throw std::invalid_argument(
                fmt::format("force density {} is {}, expected a positive and finite number", e, q));
        }
        check_node(edges[e][0], nodes.cols(), "edges");
        check_node(edges[e][1], nodes.cols(), "edges");
        for (const auto [from, to] : {edges[e], Edge{edges[e][1], edges[e][0]}}) {
            const int i = row[from];
            const int j = row[to];
            if (i < 0) {
                continue;
            }
            entries.emplace_back(i, i, q);
            if (j >= 0) {
                entries.emplace_back(i, j, -q);
            } else {
                rhs.row(i) += q * nodes.col(to).transpose();
                supported_rows.push_back(i);
            }
        }
    }
    if (loads.cols() != 0) {
        for (Eigen::Index node = 0; node < nodes.cols(); ++node) {
            if (const int i = row[node]; i >= 0) {
                rhs.row(i) += loads.col(node).transpose();
            }
        }
    }

    Eigen::SparseMatrix<double> laplacian(free_count, free_count);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    if (const int i = first_row_not_joined(laplacian, std::move(supported_rows)); i >= 0) {
        throw std::invalid_argument(fmt::format("free node {} is joined to no support by edges",
                                                std::ranges::find(row, i) - row.begin()));
    }
    if (free_count == 0) {
        return nodes;
    }
    const Eigen::MatrixX3d solution = solve(laplacian, rhs);
    Points form = nodes;
    for (Eigen::Index node = 0; node < nodes.cols(); ++node) {
        if (const int i = row[node]; i >= 0) {
            form.col(node) = solution.row(i).transpose();
        }
    }
    return form;
}

}  // namespace taut
