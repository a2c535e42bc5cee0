// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <stdexcept>

#include "design/form_found_net.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

constexpr double rise = 0.25;  // height between corners, of the shorter side
constexpr int largest_side = 1000;

}  // namespace

CableNet hypar(int rows, int columns) {
    if (rows < 1 || rows > largest_side || columns < 1 || columns > largest_side) {
        throw std::invalid_argument(
            fmt::format("hypar of {} x {} free nodes: expected 1 to {} rows "
                        "and columns",
                        rows, columns, largest_side));
    }
    // Grid points (i, j), with the supports one spacing around the free nodes; no nodes at corners.
    const auto is_free = [&](int i, int j) {
        return i >= 1 && i <= rows && j >= 1 && j <= columns;
    };
    const double height = rise * lattice_spacing * std::min(rows + 1, columns + 1);
    std::vector<Eigen::Vector3d> nodes;
    std::vector<int> supports;
    std::vector<int> node_at((rows + 2) * (columns + 2), -1);
    const auto at = [&](int i, int j) -> int& { return node_at[i * (columns + 2) + j]; };
    for (int i = 0; i <= rows + 1; ++i) {
        for (int j = 0; j <= columns + 1; ++j) {
            const bool inner_row = i >= 1 && i <= rows;
            const bool inner_column = j >= 1 && j <= columns;
            if (!inner_row && !inner_column) {
                continue;
            }
            at(i, j) = static_cast<int>(nodes.size());
            if (!is_free(i, j)) {
                supports.push_back(at(i, j));
            }
            const double u = 2.0 * j / (columns + 1) - 1.0;
            const double v = 2.0 * i / (rows + 1) - 1.0;
            nodes.emplace_back(lattice_spacing * j, lattice_spacing * i,
                               0.5 * height * (1.0 + u * v));
        }
    }
    std::vector<Edge> edges;
    for (int i = 0; i <= rows; ++i) {
        for (int j = 0; j <= columns; ++j) {
            if (is_free(i, j) || is_free(i, j + 1)) {
                edges.push_back({at(i, j), at(i, j + 1)});
            }
            if (is_free(i, j) || is_free(i + 1, j)) {
                edges.push_back({at(i, j), at(i + 1, j)});
            }
        }
    }
    const Points points =
        Eigen::Map<const Points>(nodes.front().data(), 3, static_cast<Eigen::Index>(nodes.size()));
    return form_found_net(fmt::format("hypar:{}x{}", rows, columns), points, supports, edges);
}

}  // namespace taut
