// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>

#include "taut/results/result_file.hpp"

namespace taut::report {

/// A parallel projection: its rows are the directions in space that become right and up.
using Projection = Eigen::Matrix<double, 2, 3>;

/// Extent of a form along x, y and z [m].
[[nodiscard]] Eigen::Vector3d extent(const Points& form);

/// Seen from above and from the side: 38 degrees above the ground, turned by 25 degrees.
[[nodiscard]] Projection slanting_view();

/// Seen along one axis of space, with the other two along the drawing's.
struct Plan {
    Projection projection = Projection::Zero();
    std::string right;  ///< name of the axis that points right: "x"
    std::string up;
    std::string seen;  ///< "from above", "along y"
};

/// From above; of a net that stands upright, the side that shows more of it.
[[nodiscard]] Plan plan_of(const Points& form);

}  // namespace taut::report
