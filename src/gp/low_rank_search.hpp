// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gp/lambda_search.hpp"
#include "taut/gp/fit.hpp"

namespace taut::gp {

/// So many inputs are enough to find lambda.
inline constexpr int inputs_to_search = 2000;

/// Chooses the lambda of each output for more inputs than can be decomposed: of the few lambdas
/// that are best on a part of the inputs, the likeliest on all, by spectra of low rank.
/// @param inputs d x n
/// @param outputs n x m, none of them zero throughout; m >= 1
/// @param part of the inputs, which are decomposed
/// @param part_squared_distances of all pairs of these inputs
/// @param rank of the spectra, 1 to n
/// @throws Interrupted where a stop was requested
[[nodiscard]] FoundLambdas search_by_low_rank(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                                              const Eigen::MatrixXd& outputs,
                                              const std::vector<Eigen::Index>& part,
                                              const Eigen::MatrixXd& part_squared_distances,
                                              const LambdaSearchSettings& settings,
                                              Eigen::Index rank, const Progress& progress);

}  // namespace taut::gp
