// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/control_check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "survey/mean_edge_length.hpp"
#include "survey/median.hpp"

namespace taut {

std::vector<std::string> control_warnings(const CableNet& net,
                                          const std::vector<ControlResidual>& residuals,
                                          double noise_std) {
    constexpr double explained = 5.0;       // standard deviations
    constexpr double rounding_part = 1e-6;  // of the mean edge length
    // Median of the length of a normal vector in 3D, in standard deviations of a coordinate: where
    // all residuals are large, the given noise or scale is wrong, and no single point stands out.
    constexpr double median_length = 1.538;
    if (residuals.empty()) {
        return {};
    }
    const auto distance = [](const ControlResidual& point) { return point.residual.norm(); };
    Eigen::VectorXd distances(std::ssize(residuals));
    std::ranges::transform(residuals, distances.begin(), distance);
    const double spread = std::max(noise_std, median_of(distances) / median_length);
    const double limit = std::max(explained * spread, rounding_part * mean_edge_length(net));
    const auto count = std::ranges::count_if(
        residuals, [&](const ControlResidual& point) { return distance(point) > limit; });
    if (count == 0) {
        return {};
    }
    const ControlResidual& worst = *std::ranges::max_element(residuals, {}, distance);
    return {fmt::format(
        "{} of {} supports or control points are not where they should be: '{}' is {:.3g} mm off, "
        "more than the noise explains. Check their coordinates, and whether the survey is in the "
        "net's frame",
        count, residuals.size(), worst.id, 1e3 * distance(worst))};
}

}  // namespace taut
