// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/linearisation.hpp"
#include "estimation/prior_knowledge.hpp"
#include "taut/identification/result.hpp"

namespace taut {

/// The lengths of the stretches that slide, docs/theory.md (slips), after a fit; without their
/// deviations.
/// @param knowledge of the fit
[[nodiscard]] std::vector<StretchLength> stretch_lengths(const CableNet& net,
                                                         const PriorKnowledge& knowledge,
                                                         const LinearisedFit& fitted);

/// Sets the deviations of the stretches of a result to the sums of those of its edges.
void set_stretch_deviations(Identification& result);

}  // namespace taut
