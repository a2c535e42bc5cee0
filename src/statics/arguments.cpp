// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/arguments.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

namespace taut {

void check_unstressed_lengths(Eigen::Index edge_count,
                              const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths) {
    if (unstressed_lengths.size() != edge_count) {
        throw std::invalid_argument(fmt::format("unstressed_lengths has {} entries, expected {}",
                                                unstressed_lengths.size(), edge_count));
    }
    for (Eigen::Index e = 0; e < edge_count; ++e) {
        if (!(std::isfinite(unstressed_lengths(e)) && unstressed_lengths(e) > 0.0)) {
            throw std::invalid_argument(
                fmt::format("unstressed length {} is {}, expected a positive and finite number", e,
                            unstressed_lengths(e)));
        }
    }
}

void check_form(const char* name, Eigen::Index node_count, const Eigen::Ref<const Points>& form) {
    if (form.cols() != node_count) {
        throw std::invalid_argument(
            fmt::format("{} has {} points, expected {}", name, form.cols(), node_count));
    }
    for (Eigen::Index i = 0; i < node_count; ++i) {
        if (!form.col(i).allFinite()) {
            throw std::invalid_argument(
                fmt::format("{} has ({}, {}, {}) at node {}, expected finite coordinates", name,
                            form(0, i), form(1, i), form(2, i), i));
        }
    }
}

void check_edges(Eigen::Index edge_count, std::span<const int> edges) {
    for (const int edge : edges) {
        if (edge < 0 || edge >= edge_count) {
            throw std::invalid_argument(
                fmt::format("edges names edge {}, expected one of the {}", edge, edge_count));
        }
    }
}

void check_edge_forces(Eigen::Index edge_count, const Eigen::Ref<const Points>& edge_forces) {
    if (edge_forces.cols() != edge_count) {
        throw std::invalid_argument(
            fmt::format("edge_forces has {} columns, expected {}", edge_forces.cols(), edge_count));
    }
    for (Eigen::Index e = 0; e < edge_count; ++e) {
        if (!edge_forces.col(e).allFinite()) {
            throw std::invalid_argument(
                fmt::format("edge_forces has ({}, {}, {}) at edge {}, expected finite forces",
                            edge_forces(0, e), edge_forces(1, e), edge_forces(2, e), e));
        }
    }
}

}  // namespace taut
