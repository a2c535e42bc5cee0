// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/progress.hpp"
#include "taut/sampling/uncertain_parameter.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Corrects the common mean of the length deviations (PriorCheck::mean) by the bias of a fit to
/// first order: by the mean that it finds in one simulated survey of the same net, with lengths and
/// uncertain parameters drawn from their priors and the same targets and noise. docs/theory.md,
/// (mean-bias). Only where the mean is significant and may be such a bias; it takes the time of
/// another fit.
void take_out_mean_bias(Identification& result, const CableNet& net, const Survey& survey,
                        const std::vector<UncertainParameter>& uncertain, const Progress& progress);

}  // namespace taut
