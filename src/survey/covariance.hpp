// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// Noise of a measured place: its covariance is s_i s_k rho_ik.
struct PlaceNoise {
    Eigen::Vector3d std_dev;       ///< of x, y, z [m]
    Eigen::Vector3d correlations;  ///< of x and y, x and z, y and z
};

/// Whether three coordinates can have such correlations: their matrix is positive definite, by more
/// than the digits of a file can be off.
[[nodiscard]] TAUT_CORE_EXPORT bool are_possible_correlations(const Eigen::Vector3d& correlations);

[[nodiscard]] TAUT_CORE_EXPORT Eigen::Matrix3d covariance_of(const PlaceNoise& noise);  ///< [m2]

/// The other way round; what has no variance is correlated with nothing.
/// @param covariance positive semidefinite [m2]
[[nodiscard]] TAUT_CORE_EXPORT PlaceNoise noise_of(const Eigen::Matrix3d& covariance);

/// The inverse of the covariance.
/// @param noise positive standard deviations, correlations that are possible: not checked
/// @return [1/m2]
[[nodiscard]] TAUT_CORE_EXPORT Eigen::Matrix3d weight_of(const PlaceNoise& noise);

/// L^-1 with the covariance L L', L lower triangular: errors times this are independent, of
/// standard deviation 1.
/// @param noise positive standard deviations, correlations that are possible: not checked
/// @return [1/m]
[[nodiscard]] TAUT_CORE_EXPORT Eigen::Matrix3d whitening_of(const PlaceNoise& noise);

}  // namespace taut
