// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/control_check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "survey/mean_edge_length.hpp"

namespace taut {

std::vector<std::string> control_warnings(const CableNet& net,
                                          const std::vector<ControlResidual>& residuals,
                                          double noise_std) {
    constexpr double explained = 5.0;       // standard deviations
    constexpr double rounding_part = 1e-6;  // of the mean edge length
    // The median length of a residual, in standard deviations of a coordinate: where all lie as far
    // off, it is not single points that are elsewhere, but noise or scale that is told wrong.
    constexpr double median_length = 1.538;
    if (residuals.empty()) {
        return {};
    }
    const auto distance = [](const ControlResidual& point) { return point.residual.norm(); };
    std::vector<double> distances(residuals.size());
    std::ranges::transform(residuals, distances.begin(), distance);
    const auto middle = distances.begin() + std::ssize(distances) / 2;
    std::ranges::nth_element(distances, middle);
    const double spread = std::max(noise_std, *middle / median_length);
    const double limit = std::max(explained * spread, rounding_part * mean_edge_length(net));
    const auto count = std::ranges::count_if(
        residuals, [&](const ControlResidual& point) { return distance(point) > limit; });
    if (count == 0) {
        return {};
    }
    const ControlResidual& worst = *std::ranges::max_element(residuals, {}, distance);
    return {fmt::format(
        "{} of {} supports or control points were measured elsewhere than they are, '{}' by {:.3g} "
        "mm, more than the noise explains. Are they there, and is the survey in the net's frame "
        "(--frame supports)?",
        count, residuals.size(), worst.id, 1e3 * distance(worst))};
}

}  // namespace taut
