// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/control_check.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "survey/mean_edge_length.hpp"

namespace taut {

std::vector<std::string> control_warnings(const CableNet& net,
                                          const std::vector<ControlResidual>& residuals,
                                          double noise_std) {
    constexpr double explained = 5.0;       // standard deviations
    constexpr double rounding_part = 1e-6;  // of the mean edge length
    const double limit = std::max(explained * noise_std, rounding_part * mean_edge_length(net));
    const auto distance = [](const ControlResidual& point) { return point.residual.norm(); };
    const auto count = std::ranges::count_if(
        residuals, [&](const ControlResidual& point) { return distance(point) > limit; });
    if (count == 0) {
        return {};
    }
    const ControlResidual& worst = *std::ranges::max_element(residuals, {}, distance);
    return {fmt::format(
        "{} of {} supports or control points were measured elsewhere than they are, '{}' by {:.3g} "
        "mm, more than the noise explains: supports are taken as the net has them. Are they there, "
        "and is the survey in its frame (--frame supports)?",
        count, residuals.size(), worst.id, 1e3 * distance(worst))};
}

}  // namespace taut
