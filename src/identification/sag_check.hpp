// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/identification/result.hpp"
#include "taut/identification/trust.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Cables whose sag the model gets wrong by more than a quarter of the standard deviation
/// of their length: those that are taken as straight though they have a mass, by all of (S/T)^2 of
/// (sagging-law), and those that sag too much for its parabola, by its next term (sag-error). A
/// finding of either kind; doubtful where it is a whole standard deviation.
[[nodiscard]] std::vector<Trust::Finding> sag_findings(const CableNet& net,
                                                       const Identification& result);

}  // namespace taut
