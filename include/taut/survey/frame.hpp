// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// A rotation and a translation, x -> R (x - from) + to. Kept with two centres, so that coordinates
/// of a national grid (10^6 m) lose nothing.
struct RigidMotion {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< R
    Eigen::Vector3d from = Eigen::Vector3d::Zero();          ///< [m]
    Eigen::Vector3d to = Eigen::Vector3d::Zero();            ///< [m]

    /// Where the motion takes a place [m].
    [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& x) const {
        return rotation * (x - from) + to;
    }
};

/// How far a control point lies from its known place after the fit of the survey's frame.
struct ControlResidual {
    std::string id;            ///< name of the point
    Eigen::Vector3d residual;  ///< measured, moved, less known [m]
};

/// A rigid motion fitted to control points.
struct Registration {
    RigidMotion motion;                      ///< from the instrument's frame to the net's
    std::vector<ControlResidual> residuals;  ///< of the points it was fitted to, in their order
};

/// Root of the mean squared length of residuals; 0 where there are none [m].
[[nodiscard]] TAUT_CORE_EXPORT double root_mean_square(
    const std::vector<ControlResidual>& residuals);

}  // namespace taut
