// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/survey/station_adjustment.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// What a simulated survey does to a form.
struct SurveySimulation {
    double noise_std = 0.0;     ///< normal noise on every coordinate [m]
    double dropped_part = 0.0;  ///< of the free nodes, hidden from the instrument
    double offset = 0.0;        ///< of targets on free nodes along the form's normal [m]
    double offset_std = 0.0;    ///< normal, of each target's offset [m]
    bool shuffled = false;      ///< targets on free nodes have no names, and any order
    bool random_frame = false;  ///< an instrument's own frame, as far away as a national grid
    std::uint64_t seed = 1;     ///< of all that is random
};

/// A survey of a form, for trials and teaching: free nodes and supports, with their noise where
/// there is some. The same seed gives the same survey.
/// @param form 3 x n, supports included [m]
/// @throws std::invalid_argument for a form of another size or that is not finite, a negative or
///   infinite noise or standard deviation of offsets, an offset where the form has no normal, and a
///   dropped part outside [0, 1)
[[nodiscard]] TAUT_CORE_EXPORT std::vector<SurveyPoint> simulate_survey(
    const CableNet& net, const Points& form, const SurveySimulation& simulation);

/// What a simulated instrument does to a form.
struct PolarSimulation {
    std::vector<Eigen::Vector3d> stations;  ///< places of the instrument, in the net's frame [m]
    double angle_std = common_angle_std;  ///< of normal noise on directions and zenith angles [rad]
    DistancePrecision distance;           ///< of normal noise on distances
    double dropped_part = 0.0;            ///< of the free nodes, hidden from all stations
    bool shuffled = false;                ///< targets on free nodes have names of their own
    std::uint64_t seed = 1;               ///< of all that is random
};

/// The observations of a simulated instrument: each station, named 1, 2, ..., levelled and with the
/// zero of its circle anywhere, observes each target once, with the standard deviations given. A
/// shuffled target is named t1, t2, ... in any order. The same seed gives the same observations.
/// @param form 3 x n, supports included [m]
/// @throws std::invalid_argument as simulate_survey(), and for no station, one nearer than 10 mm to
///   a target or not finite, and noise that is not positive
[[nodiscard]] TAUT_CORE_EXPORT PolarSurvey simulate_polar_survey(const CableNet& net,
                                                                 const Points& form,
                                                                 const PolarSimulation& simulation);

}  // namespace taut
