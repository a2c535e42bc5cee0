// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// A node that is to be surveyed.
struct PlannedTarget {
    std::string id;  ///< CableNet::node_id
    int line = 0;    ///< of the file it came from, for messages; 0 if none
};

/// The survey that a plan leads to, with nominal places in place of the measured ones.
/// @param noise_std of each coordinate [m]
/// @throws SurveyError with the line of a target, for a name that is empty, not a node's or comes
///   twice
/// @throws std::invalid_argument for noise that is negative or not finite
[[nodiscard]] TAUT_CORE_EXPORT Survey planned_survey(const CableNet& net,
                                                     const std::vector<PlannedTarget>& targets,
                                                     double noise_std);

}  // namespace taut
