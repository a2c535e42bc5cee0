// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Warnings about values of a net, at its nominal form, that are probably in a wrong unit: one line
/// each, with the likely mistake and its remedy. A sound net gives none.
/// - mean edge length above 30 m: coordinates in mm;
/// - mean strain of the taut edges below 8e-6: forces in kN taken for N, or an axial stiffness a
///   thousand times too large;
/// - a strain above 5 %: the opposite mistake;
/// - nodes out of balance by more than a tenth of the mean tension: loads missing, or in a wrong
///   unit.
[[nodiscard]] TAUT_CORE_EXPORT std::vector<std::string> unit_warnings(const CableNet& net);

/// Refuses nets that are wrong in any unit: the median ratio of unstressed lengths to edge lengths
/// at the nominal form is above 100 or below 1/100.
/// @throws NetError of the field unstressed_lengths
TAUT_CORE_EXPORT void refuse_impossible_units(const CableNet& net);

}  // namespace taut
