// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/law_likelihood.hpp"
#include "taut/estimation/doubt.hpp"
#include "taut/sampling/length_law.hpp"

namespace taut {

/// Compares the law that was told with the likeliest uniform, normal or bimodal one, by what a
/// survey tells of each length without its law, docs/theory.md (law-check).
/// @return all but the mean
[[nodiscard]] LawCheck check_law_by_lengths(const LengthLaw& law, const LawLikelihood& likelihood);

}  // namespace taut
