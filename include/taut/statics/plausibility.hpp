// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// What about a net, at its nominal form, is most likely told in another unit: a line each, with
/// the likely slip and what mends it. A sound net gives none.
/// - edges longer than 30 m in the mean: coordinates in mm;
/// - strains below 8e-6 in the mean of the taut edges: forces in kN taken for N, or an axial
///   stiffness a thousand times too large;
/// - a strain beyond 5 %: the other way around;
/// - nodes out of balance by more than a tenth of the mean tension: loads left out, or in another
///   unit.
[[nodiscard]] TAUT_CORE_EXPORT std::vector<std::string> unit_warnings(const CableNet& net);

/// Refuses what no unit makes a net: unstressed lengths that are, in the median, more than a
/// hundred times the lengths of their edges at the nominal form, or less than a hundredth of them.
/// @throws NetError of unstressed_lengths
TAUT_CORE_EXPORT void refuse_impossible_units(const CableNet& net);

}  // namespace taut
