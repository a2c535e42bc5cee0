// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/export/core.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {

/// Estimate of one number of an uncertain parameter, in the unit of its kind: the logarithm of a
/// factor of the stiffness, K, m, a part of the loads, N.
struct TAUT_CORE_EXPORT ParameterEstimate {
    UncertainParameter parameter;  ///< as given, with its standard deviation before the survey
    int edge = -1;  ///< of stiffness-each, adjustable, and of slip that which it passed to; else -1
    int node = -1;  ///< of supports and of loads in newtons; else -1
    int axis = -1;  ///< of the node: 0, 1, 2 for x, y, z
    double mean = 0.0;     ///< deviation from the net
    double std_dev = 0.0;  ///< of that, after the survey
    /// Standard deviation before the survey: 1.2 times an assumed one, docs/theory.md
    /// (assumed-width).
    double prior_std = 0.0;
    /// Whether the survey determines it any better than before.
    [[nodiscard]] bool is_observed() const;
};

}  // namespace taut
