// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/identification/identify.hpp"

namespace taut {

/// The factor on the noise that fits the survey, without gross errors, docs/theory.md (components).
/// @throws std::invalid_argument where the survey is exact
/// @throws SurveyError where it does not show its noise
[[nodiscard]] double noise_scale_of(const CableNet& net, const Survey& survey,
                                    const LengthPrior& prior, const IdentifyOptions& options,
                                    const Progress& progress);

}  // namespace taut
