// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/gauss_newton.hpp"
#include "taut/sampling/length_law.hpp"

namespace taut {

/// Edges (m) that a form shows to be slack, whatever the survey tells of their lengths: adjustable
/// ones, of known length, that are shorter than it; and interior ones that would be taut only at a
/// deviation beyond three standard deviations of the law (beyond the bound of a uniform one).
[[nodiscard]] std::vector<bool> slack_by_form(const CableNet& net, const Guess& guess,
                                              const LengthLaw& law);

/// Edges (m) that were measured shorter than they can be while taut (see above), by more than three
/// standard deviations of that measurement.
[[nodiscard]] std::vector<bool> slack_by_survey(const CableNet& net, const Knowledge& knowledge,
                                                const LengthLaw& law);

/// Of edges named slack (m), those of which both ends were measured.
[[nodiscard]] std::vector<bool> where_measured(const CableNet& net, const Knowledge& knowledge,
                                               std::vector<bool> slack);

/// Fits form and lengths to what is known, from a start, with the edges slack that the fitted form
/// shows to be so. Whether an edge is taut is a question of its own: a cable that is stretched by a
/// hundredth of a millimetre where it is taut can hang by several where it is slack, and no small
/// steps lead from one fit to the other. So the survey is asked first, by slack_by_survey(). An
/// edge that comes out longer than it can be while slack is taut for good, even with some pressure:
/// it stands between the two. Where it settles, the statics are left linearised at the result.
/// @param slack edges (m) to begin with
/// @throws std::runtime_error as fit_under_statics()
[[nodiscard]] GaussNewtonResult fit_to_survey(const CableNet& net, ConditionedStatics& statics,
                                              const Knowledge& knowledge, const LengthLaw& law,
                                              const Guess& start, std::vector<bool> slack,
                                              double tolerance, int max_iterations);

}  // namespace taut
