// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gp/lambda_search.hpp"
#include "taut/gp/fit.hpp"

namespace taut::gp {

/// The outputs that can be fitted.
struct FittableOutputs {
    Eigen::MatrixXd values;      ///< n x number of outputs
    std::vector<int> column_of;  ///< column of each in the result
};

/// Conditions the outputs that chose one lambda on the data: hyperparameters, weights,
/// leave-one-out and approximation errors.
/// @param result with its inputs
/// @param index of their spectrum in it
/// @param members places of these outputs in `outputs` and in `best`
/// @throws Interrupted where a stop was requested
void condition(FittedProcesses& result, size_t index, const std::vector<BestLambda>& best,
               const FittableOutputs& outputs, const std::vector<Eigen::Index>& members,
               const Progress& progress);

}  // namespace taut::gp
