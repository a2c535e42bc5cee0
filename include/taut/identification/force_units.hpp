// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/survey/forces.hpp"

namespace taut {

/// A warning where the tensions are most likely in another unit: of one kind of measurement, their
/// median over those of the design in equilibrium is above 2.5, or below 1 / 2.5; else empty.
/// @throws std::out_of_range for an edge that the net lacks
/// @throws std::invalid_argument where the median is above 50, or below 1 / 50
TAUT_CORE_EXPORT std::string force_unit_warning(const CableNet& net,
                                                const std::vector<ForceMeasurement>& measurements);

}  // namespace taut
