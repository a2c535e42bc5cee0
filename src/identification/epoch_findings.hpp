// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "identification/epoch_changes.hpp"
#include "taut/identification/result.hpp"
#include "taut/identification/trust.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Why surveys cannot be of one net: by a factor on all strokes, or by more changes than can be.
/// Empty: they can.
[[nodiscard]] std::string contradiction_of(const CableNet& net,
                                           const std::vector<EpochChanges>& changes);

/// The findings of each survey, and of how lengths changed in between.
/// @param changes one a survey
[[nodiscard]] Trust trust_of_epochs(const CableNet& net, const std::vector<EpochResult>& epochs,
                                    const std::vector<EpochChanges>& changes);

}  // namespace taut
