// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/identification/identification.hpp"
#include "taut/sampling/length_law.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Whether every free node was surveyed, and without noise: then the statics leave the law nothing
/// to say, but of slack edges.
[[nodiscard]] bool is_exact_and_complete(const CableNet& net, const Survey& survey);

/// Lengths from such a survey: the balance of its form, h = 0 (eq. hq), is linear in 1/l_0, and
/// solved by sparse least squares.
/// @throws std::runtime_error where it asks for a length that is not positive, or the identified
///   lengths find no equilibrium
[[nodiscard]] Identification identify_by_exact_balance(const CableNet& net, const Survey& survey,
                                                       const LengthLaw& law);

}  // namespace taut
