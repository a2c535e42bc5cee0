// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/estimation/doubt.hpp"
#include "taut/estimation/length_posterior.hpp"
#include "taut/sampling/length_law.hpp"

namespace taut {

/// Compares the law that was told with the likeliest uniform, normal or bimodal one, by what a
/// survey tells of each length without its law, docs/theory.md (law-check).
/// @param told of each interior edge without its law (m_I)
/// @param left_out edges (m_I) that are beyond it, or of another law
/// @return all but the mean
[[nodiscard]] LawCheck check_law_by_lengths(const LengthLaw& law,
                                            const std::vector<LengthLikelihood>& told,
                                            const std::vector<bool>& left_out);

}  // namespace taut
