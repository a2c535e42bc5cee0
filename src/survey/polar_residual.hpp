// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/survey/station_adjustment.hpp"

namespace taut {

/// By how much a target misses an observation, across, up and along the line of sight, in standard
/// deviations of the observation, and its derivatives. docs/theory.md, (polar)
struct PolarResidual {
    Eigen::Vector3d value;
    Eigen::Matrix3d by_target;            ///< [1/m]
    Eigen::Matrix<double, 3, 4> by_pose;  ///< by place [1/m] and orientation [1/rad]
};

[[nodiscard]] PolarResidual polar_residual(const PolarObservation& observation,
                                           const StationPose& pose, const Eigen::Vector3d& target);

/// The prism in the frame of its station, as observed [m].
[[nodiscard]] Eigen::Vector3d sighted(const PolarObservation& observation);

/// From the frame of a station to the common one.
[[nodiscard]] Eigen::Matrix3d rotation_of(const StationPose& pose);

}  // namespace taut
