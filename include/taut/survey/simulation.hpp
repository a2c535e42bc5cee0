// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "taut/survey/survey.hpp"

namespace taut {

/// What a simulated survey does to a form.
struct SurveySimulation {
    double noise_std = 0.0;     ///< normal noise on every coordinate [m]
    double dropped_part = 0.0;  ///< of the free nodes, hidden from the instrument
    bool shuffled = false;      ///< targets on free nodes have no names, and any order
    bool random_frame = false;  ///< an instrument's own frame, as far away as a national grid
    std::uint64_t seed = 1;
};

/// A survey of a form, for trials and teaching: free nodes and supports, with the noise told where
/// there is some. The same seed gives the same survey.
/// @param form 3 x n, supports included [m]
/// @throws std::invalid_argument for a form of another size or that is not finite, a negative or
///   infinite noise, and a dropped part outside [0, 1)
[[nodiscard]] std::vector<SurveyPoint> simulate_survey(const CableNet& net, const Points& form,
                                                       const SurveySimulation& simulation);

}  // namespace taut
