// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/projection.hpp"

#include <cmath>
#include <numbers>

namespace taut::report {

Eigen::Vector3d extent(const Points& form) {
    return form.rowwise().maxCoeff() - form.rowwise().minCoeff();
}

Projection slanting_view() {
    const double turn = 25.0 * std::numbers::pi / 180.0;
    const double height = 38.0 * std::numbers::pi / 180.0;
    // The eye stands in the direction d = (cos h sin t, -cos h cos t, sin h). Right is level and
    // across d, up is across both.
    Projection view;
    view << std::cos(turn), std::sin(turn), 0.0,  //
        -std::sin(height) * std::sin(turn), std::sin(height) * std::cos(turn), std::cos(height);
    return view;
}

Plan plan_of(const Points& form) {
    const Eigen::Vector3d size = extent(form);
    Plan plan;
    // A net counts as upright where one of its sides is less than half as wide as it is high.
    if (size.y() < 0.5 * size.z() && size.y() <= size.x()) {
        plan = {.right = "x", .up = "z", .seen = "along y"};
        plan.projection << 1, 0, 0, 0, 0, 1;
    } else if (size.x() < 0.5 * size.z()) {
        plan = {.right = "y", .up = "z", .seen = "along x"};
        plan.projection << 0, 1, 0, 0, 0, 1;
    } else {
        plan = {.right = "x", .up = "y", .seen = "from above"};
        plan.projection << 1, 0, 0, 0, 1, 0;
    }
    return plan;
}

}  // namespace taut::report
