// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/adjustment/turn_order.hpp"

namespace taut {

/// Whether these can be stages of work at a net.
/// @throws std::invalid_argument for a part that is not above 0 and at most 1, or not more than
///   what a stage before has done of an edge
/// @throws std::out_of_range for an edge that the net does not have
void check_stages(const CableNet& net, const std::vector<WorkStage>& stages);

/// A pass over the net.
struct Pass {
    Eigen::VectorXd strokes;  ///< of the plan, done at its end [m]
    int stage = 0;            ///< as many as there are: what no stage holds
};

/// All passes, one or more for each stage.
/// @param turn_step smallest change of length: only the strokes of the plan may end between steps;
///   0: any [m]
[[nodiscard]] std::vector<Pass> passes_of(const Plan& plan, const std::vector<WorkStage>& stages,
                                          int passes_of_stage, double turn_step);

}  // namespace taut
