// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// A warning where the noise of a survey is above 2 % of the net's mean edge length, or above 50
/// mm: no instrument is that bad, so it was most likely meant in millimetres.
/// @param noise_std of a coordinate [m]
[[nodiscard]] TAUT_CORE_EXPORT std::vector<std::string> noise_warnings(const CableNet& net,
                                                                       double noise_std);

/// Refuses noise above the mean edge length, which hides the node that a target is on.
/// @param noise_std of a coordinate [m]
/// @throws SurveyError for such noise
TAUT_CORE_EXPORT void refuse_absurd_noise(const CableNet& net, double noise_std);

}  // namespace taut
