// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "study/method.hpp"
#include "study/trial.hpp"
#include "taut/export/adjustment.hpp"
#include "taut/progress.hpp"
#include "taut/study/method_result.hpp"

namespace taut {

/// The results of a method on surveys, together and one by one.
struct Evaluation {
    MethodResult result;                                         ///< over all surveys
    std::vector<std::optional<Identification>> identifications;  ///< one per trial; empty: failed
};

/// Tries a method on surveys, in parallel on the threads of oneTBB where it does not use them
/// itself. The outcome does not depend on their number. What a method throws counts as a failure,
/// but for std::bad_alloc.
/// @param method of this net, called from several threads at once unless it uses all of them itself
/// @param progress gets the stage "identification" after each trial
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT Evaluation evaluate(const CableNet& net, const Method& method,
                                                         const std::vector<Trial>& trials,
                                                         const Progress& progress = {});

/// The CramerRaoBound of these surveys.
/// @param trials of this net, at least one
/// @return nothing where the statics of a true form are singular: a slack mechanism
/// @throws std::invalid_argument as cramer_rao_variances()
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::optional<CramerRaoBound> cramer_rao_bound(
    const CableNet& net, const LengthPrior& prior, const std::vector<Trial>& trials);

}  // namespace taut
