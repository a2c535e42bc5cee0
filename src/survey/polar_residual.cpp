// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/polar_residual.hpp"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

/// Least sine of a zenith angle. Near the vertical a direction says little across the line of
/// sight, since errors of pointing and levelling dominate: a target nearer than some six degrees
/// counts as if it were six degrees away.
constexpr double least_sine = 0.1;

Eigen::Vector3d line_of_sight(const PolarObservation& observation) {
    const double across = std::sin(observation.zenith);
    return {across * std::sin(observation.direction), across * std::cos(observation.direction),
            std::cos(observation.zenith)};
}

/// Across, up and along the line of sight, each over its standard deviation [1/m].
Eigen::Matrix3d weighting(const PolarObservation& observation) {
    const double sin_a = std::sin(observation.direction);
    const double cos_a = std::cos(observation.direction);
    const double sin_z = std::sin(observation.zenith);
    const double cos_z = std::cos(observation.zenith);
    const double by_angle = observation.distance * observation.angle_std;
    Eigen::Matrix3d W;
    W.row(0) << cos_a, -sin_a, 0.0;
    W.row(0) /= by_angle * std::max(std::abs(sin_z), least_sine);
    W.row(1) << cos_z * sin_a, cos_z * cos_a, -sin_z;
    W.row(1) /= by_angle;
    W.row(2) = line_of_sight(observation) / observation.distance_std;
    return W;
}

}  // namespace

Eigen::Vector3d sighted(const PolarObservation& observation) {
    return observation.distance * line_of_sight(observation);
}

Eigen::Matrix3d rotation_of(const StationPose& pose) {
    const double c = std::cos(pose.orientation);
    const double s = std::sin(pose.orientation);
    Eigen::Matrix3d R;
    R << c, -s, 0.0,  //
        s, c, 0.0,    //
        0.0, 0.0, 1.0;
    return R;
}

PolarResidual polar_residual(const PolarObservation& observation, const StationPose& pose,
                             const Eigen::Vector3d& target) {
    const Eigen::Vector3d prism = target + observation.target_height * Eigen::Vector3d::UnitZ();
    const Eigen::Matrix3d W = weighting(observation);
    const Eigen::Vector3d seen = rotation_of(pose).transpose() * (prism - pose.place);
    PolarResidual result;
    result.value = W * (seen - sighted(observation));
    result.by_target = W * rotation_of(pose).transpose();
    result.by_pose.leftCols<3>() = -result.by_target;
    // dR'/dw x = -e_z x (R' x)
    result.by_pose.col(3) = W * Eigen::Vector3d(seen.y(), -seen.x(), 0.0);
    return result;
}

}  // namespace taut
