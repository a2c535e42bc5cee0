// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/identification/identify.hpp"

namespace taut {

/// By a method under each prior of the posterior of priors, mixed: docs/theory.md, (prior-mixture).
[[nodiscard]] Identification identify_over_priors(IdentificationMethod method, const CableNet& net,
                                                  const Survey& survey,
                                                  const IdentifyOptions& options,
                                                  const Progress& progress);

}  // namespace taut
