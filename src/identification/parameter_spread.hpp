// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/identification/parameter_estimate.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/model_perturbation.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {

/// Root mean square of estimates with one given standard deviation, over what that lets expect,
/// sqrt(given^2 - std^2): about 1 where it is right. 0 where nothing shows them.
[[nodiscard]] TAUT_CORE_EXPORT double spread_ratio(std::span<const ParameterEstimate> estimates);

/// The spread_ratio() of the estimates of one parameter.
struct TAUT_CORE_EXPORT ParameterSpread {
    UncertainParameter parameter;  ///< with its standard deviation before the survey
    double ratio = 0.0;            ///< 0 where nothing shows them
    /// By how many independent numbers the survey shows them, at least: their count times the part
    /// of their variance that it takes away.
    double shown = 0.0;
    double widening = 1.0;  ///< standard deviation before the survey over the parameter's

    /// Whether the ratio is larger than 1.5 and than chance would have it, as seldom as a single
    /// number of three standard deviations.
    [[nodiscard]] bool is_contradicted() const;
};

/// The spread of each parameter, in their order.
[[nodiscard]] TAUT_CORE_EXPORT std::vector<ParameterSpread> spreads_of(
    const std::vector<ParameterEstimate>& estimates);

/// The means of estimates as a perturbation of their net.
/// @param uncertain estimates of this net; edges, nodes and axes are not checked
/// @param test_loads of the survey, among the net's loads (3 x n); 3 x 0: none [N]
/// @throws std::out_of_range for a group that the net does not have
[[nodiscard]] TAUT_CORE_EXPORT ModelPerturbation
perturbation_of(const CableNet& net, const std::vector<ParameterEstimate>& uncertain,
                const Points& test_loads = Points(3, 0));

}  // namespace taut
