// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/survey/frame.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// A point whose place is known in the net's frame and was measured in the instrument's.
struct ControlPoint {
    std::string id;            ///< name in the survey
    Eigen::Vector3d known;     ///< [m]
    Eigen::Vector3d measured;  ///< [m]
    int line = 0;              ///< of the survey's file, for messages
};

/// The rigid motion, without scale, that moves the measured places nearest to the known ones in
/// the sense of least squares (Kabsch 1976; Umeyama 1991). Places must be finite, which is not
/// checked.
/// @throws SurveyError for fewer than three points, points on a line, and where measured and known
///   points differ in scale by more than 1 % of their spread: a survey in millimetres, another net
[[nodiscard]] TAUT_CORE_EXPORT Registration
register_rigidly(const std::vector<ControlPoint>& points);

/// The points named after supports of the net, as control points: rigid ones, and elastic ones at
/// their nodes where fewer than three are rigid.
[[nodiscard]] TAUT_CORE_EXPORT std::vector<ControlPoint> support_control_points(
    const CableNet& net, const std::vector<SurveyPoint>& points);

/// Takes control points out of the points of a survey, by the names of the known ones. One that is
/// a node of the net stays in, since it is a target, too.
/// @param known control points in the net's frame [m]
/// @param points of the survey; left are those that are no control points, or nodes; as they were
///   where it throws
/// @return those that were measured
/// @throws SurveyError with the line of a known point without a name, or whose name comes twice
[[nodiscard]] TAUT_CORE_EXPORT std::vector<ControlPoint> split_off_control_points(
    const CableNet& net, const std::vector<SurveyPoint>& known, std::vector<SurveyPoint>& points);

/// Whether all control points were measured where they are known to be: to a tenth of the net's
/// mean edge length.
[[nodiscard]] TAUT_CORE_EXPORT bool in_frame_of_net(const CableNet& net,
                                                    const std::vector<ControlPoint>& points);

/// The points in the frame that a registration leads to. Standard deviations turn with them: the
/// diagonal of R diag(s^2) R'.
[[nodiscard]] TAUT_CORE_EXPORT std::vector<SurveyPoint> moved(std::vector<SurveyPoint> points,
                                                              const RigidMotion& motion);

}  // namespace taut
