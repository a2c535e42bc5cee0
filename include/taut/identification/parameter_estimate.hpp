// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/model_perturbation.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {

/// What a survey tells of one number that was unknown besides the lengths, in the unit of its kind:
/// the logarithm of a factor of the stiffness, K, m, a part of the loads, N.
struct TAUT_CORE_EXPORT ParameterEstimate {
    UncertainParameter
        parameter;      ///< as it was told, with its standard deviation before the survey
    int edge = -1;      ///< whose it is, of stiffness-each and adjustable; else -1
    int node = -1;      ///< whose it is, of supports and of loads in newtons; else -1
    int axis = -1;      ///< of the node: 0, 1, 2 for x, y, z
    double mean = 0.0;  ///< deviation from what the net tells
    double std = 0.0;   ///< of that, after the survey
    /// Of that, before the survey: of an assumed width 1.2 times that, docs/theory.md
    /// (assumed-width).
    double prior_std = 0.0;
    /// Whether the survey shows it at all: whether it is known better than before.
    [[nodiscard]] bool is_observed() const;
};

/// How far estimates of one width are from what was told, root mean square, over what that width
/// lets expect of them, sqrt(told^2 - std^2): about 1 where it is told right. 0 where nothing shows
/// them.
[[nodiscard]] TAUT_CORE_EXPORT double spread_ratio(std::span<const ParameterEstimate> estimates);

/// The spread_ratio() of the estimates of one unknown.
struct TAUT_CORE_EXPORT ParameterSpread {
    UncertainParameter parameter;  ///< with its standard deviation before the survey
    int count = 0;                 ///< of numbers
    double ratio = 0.0;            ///< 0 where nothing shows them
    double widening = 1.0;  ///< standard deviation before the survey over the width of `unknown`

    /// Whether chance does not explain it.
    [[nodiscard]] bool is_contradicted() const;
};

/// Of each unknown, in their order.
[[nodiscard]] TAUT_CORE_EXPORT std::vector<ParameterSpread> spreads_of(
    const std::vector<ParameterEstimate>& estimates);

/// The means of uncertain as perturbation of their net.
/// @param uncertain of this net; edges, nodes and axes are not checked
/// @throws std::out_of_range for a group that the net does not have
[[nodiscard]] TAUT_CORE_EXPORT ModelPerturbation
perturbation_of(const CableNet& net, const std::vector<ParameterEstimate>& uncertain);

}  // namespace taut
