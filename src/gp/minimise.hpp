// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

namespace taut::gp {

/// A function of some variables: gives its value, and fills the gradient unless that is empty.
using Objective = std::function<double(const std::vector<double>&, std::vector<double>&)>;

struct MinimiseSettings {
    double lower;  ///< bounds of every variable
    double upper;
    double relative_tolerance;  ///< of the value
    int most_evaluations;       ///< a line search may take a little more
};

/// Evaluates an objective where L-BFGS looks for its minimum. Of the places the caller keeps the
/// best.
/// @throws what the objective throws; std::invalid_argument where taut was built without NLopt
void minimise(const Objective& objective, const std::vector<double>& start,
              const MinimiseSettings& settings);

}  // namespace taut::gp
