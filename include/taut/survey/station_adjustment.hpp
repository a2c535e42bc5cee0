// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <numbers>
#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

inline constexpr double gon = std::numbers::pi / 200.0;     ///< [rad]
inline constexpr double degree = std::numbers::pi / 180.0;  ///< [rad]

/// Standard deviation of a direction and of a zenith angle of a common total station [rad].
inline constexpr double common_angle_std = 0.3e-3 * gon;

/// How well an instrument measures distances, by its data sheet; by default a common total station.
struct DistancePrecision {
    double std_dev = 1e-3;  ///< standard deviation at the instrument [m]
    double part = 1.5e-6;   ///< added to that, as a part of the distance

    /// Standard deviation of a distance [m].
    [[nodiscard]] double std_at(double distance) const { return std_dev + part * distance; }
};

/// What an instrument observes by one pointing.
struct PolarObservation {
    int station = 0;             ///< index of the station
    std::string target;          ///< its name
    double direction = 0.0;      ///< on the horizontal circle, clockwise from its zero [rad]
    double zenith = 0.0;         ///< from the vertical, in the first face: 0 to pi [rad]
    double distance = 0.0;       ///< slope distance, positive [m]
    double target_height = 0.0;  ///< of the prism above the target [m]
    double angle_std = 0.0;      ///< standard deviation of both angles; 0: not given [rad]
    double distance_std = 0.0;   ///< of the distance; 0: not given [m]
    int line = 0;                ///< of the file it came from, for messages; 0 if none
};

/// An instrument that was set up and levelled, and not moved since.
struct PolarStation {
    std::string name;  ///< in the file, or else its number from 1
    int line = 0;      ///< of the file it came from, for messages; 0 if none
};

/// What instruments observed.
struct PolarSurvey {
    std::vector<PolarStation> stations;          ///< by PolarObservation::station
    std::vector<PolarObservation> observations;  ///< of all stations, in the order of the file
};

/// An observation of the second face, its zenith angle above pi, as of the first.
[[nodiscard]] TAUT_CORE_EXPORT PolarObservation in_first_face(PolarObservation observation);

/// Where a station stands: the point where its axes meet, and the angle of its horizontal circle's
/// zero from the direction of y, counterclockwise seen from above.
struct StationPose {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< [m]
    double orientation = 0.0;                         ///< [rad]
};

/// Targets in one frame, from observations of one or several stations.
struct StationAdjustment {
    /// Each target once, in the order of the first observations, with standard deviations and
    /// correlations. The frame is that of the datum station: z up, its place the origin, its
    /// circle's zero along y.
    std::vector<SurveyPoint> points;
    std::vector<StationPose> poses;  ///< one a station
    int datum = 0;                   ///< the station that sees most targets
    /// Standard deviation of the scale that all targets have in common by errors of the poses, 0
    /// for one station [-].
    double scale_std = 0.0;
    int redundancy = 0;  ///< observed numbers less those to be determined
    /// Root of the sum of squared standardised residuals over the redundancy: 1 is expected. 0
    /// without redundancy.
    double noise_ratio = 0.0;
    int worst = -1;               ///< observation with the largest standardised residual, or -1
    double worst_residual = 0.0;  ///< of it, in standard deviations of the observation
};

/// The place of every target and the pose of every station but one, by least squares: observations
/// are weighted as they are. The poses are found through targets that several stations see. With
/// the vector o = s u(a, z) that is observed in the frame of its station (direction a, zenith angle
/// z, distance s) and the target t in the common frame, docs/theory.md (polar):
///
///     minimise  sum |W (R(w)' (t + h e_z - p) - o)|^2
///
/// p, w the pose, h the height of the prism, and W the inverse standard deviations across, up and
/// along the line of sight. The covariance of a target is its block of the inverse of the normal
/// matrix, but for what errors of the poses do to all targets alike, docs/theory.md (pose-errors):
/// the frame counts as unknown. Other correlations between targets are not kept.
/// @param survey each station with an observation, each observation with its standard deviations
/// @throws SurveyError with the line, for observations that are not finite, or without positive
///   distance and standard deviations, of no station there, a survey without stations or a station
///   without observations, a station that shares fewer than two targets with those placed before
///   it, or only targets above each other: it has no orientation then; and where the iteration does
///   not converge
[[nodiscard]] TAUT_CORE_EXPORT StationAdjustment adjust_stations(const PolarSurvey& survey);

}  // namespace taut
