// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// @throws std::invalid_argument unless there is one positive and finite length an edge
TAUT_CORE_EXPORT void check_unstressed_lengths(
    Eigen::Index edge_count, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths);

/// @param name of the argument, for the message
/// @throws std::invalid_argument unless there is one finite point a node
TAUT_CORE_EXPORT void check_form(const char* name, Eigen::Index node_count,
                                 const Eigen::Ref<const Points>& form);

/// @throws std::invalid_argument for an edge that is not 0 to edge_count - 1
TAUT_CORE_EXPORT void check_edges(Eigen::Index edge_count, std::span<const int> edges);

/// @throws std::invalid_argument unless there is one finite force an edge
TAUT_CORE_EXPORT void check_edge_forces(Eigen::Index edge_count,
                                        const Eigen::Ref<const Points>& edge_forces);

}  // namespace taut
