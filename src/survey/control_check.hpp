// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/frame.hpp"

namespace taut {

/// A warning where single control points lie farther from their known places than the noise and the
/// other points explain: by more than 5 standard deviations, the larger of the given one and that
/// of the median point, and by more than a millionth of the mean edge length.
/// @param residuals measured less known, in the net's frame
/// @param noise_std of a coordinate [m]
[[nodiscard]] TAUT_CORE_EXPORT std::vector<std::string> control_warnings(
    const CableNet& net, const std::vector<ControlResidual>& residuals, double noise_std);

}  // namespace taut
