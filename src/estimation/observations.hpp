// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/linearised_statics.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// @throws std::invalid_argument for a survey of another size, an index that is not a free node's
/// or
///   comes twice, noise that is negative or not finite, a position that is not, no surveyed node
void check_survey(const CableNet& net, const Survey& survey);

/// Standard deviation of each coordinate (3 x n) as reckoned with: exact ones are so to a ten
/// millionth of the net's mean edge length. Far above rounding errors, far below any instrument's,
/// and no harder on the factorisation than it bears [m].
[[nodiscard]] Points reckoned_noise(const CableNet& net, const Survey& survey);

/// A survey without the targets that are left out (one flag a node), and length deviations of one
/// mean and standard deviation.
[[nodiscard]] Knowledge knowledge_of(const CableNet& net, const Survey& survey, const Points& noise,
                                     const std::vector<bool>& left_out, double length_std);

/// Where to begin: the surveyed form, nominal places where there is none, nominal lengths.
[[nodiscard]] Guess surveyed_guess(const CableNet& net, const Survey& survey,
                                   const std::vector<bool>& left_out);

}  // namespace taut
