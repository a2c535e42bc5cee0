// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/observations.hpp"
#include "taut/sampling/length_law.hpp"

namespace taut {

/// Edges (m) that a form shows to be slack, whatever the survey tells of their lengths: adjustable
/// ones, of known length, that are shorter than it; and interior ones that would be taut only at a
/// deviation beyond three standard deviations of its law (beyond the bound of a uniform one).
/// @param laws one an interior edge (m_I)
/// docs/theory.md, (slack-form)
[[nodiscard]] std::vector<bool> slack_by_form(const CableNet& net, const Iterate& iterate,
                                              const std::vector<LengthLaw>& laws);

/// Edges (m) that were measured shorter than they can be while taut (see above), by more than three
/// standard deviations of that measurement. docs/theory.md, (slack-survey)
[[nodiscard]] std::vector<bool> slack_by_survey(const CableNet& net,
                                                const Observations& observations,
                                                const std::vector<LengthLaw>& laws);

/// Of edges named slack (m), those of which both ends were measured.
[[nodiscard]] std::vector<bool> where_measured(const CableNet& net,
                                               const Observations& observations,
                                               std::vector<bool> slack);

}  // namespace taut
