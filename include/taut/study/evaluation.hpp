// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "taut/export/adjustment.hpp"
#include "taut/progress.hpp"
#include "taut/study/error_statistics.hpp"
#include "taut/study/method.hpp"
#include "taut/study/trial.hpp"

namespace taut {

/// How well one method identified the lengths of many surveys. What failed is counted, and in none
/// of the other numbers.
struct MethodResult {
    std::string name;           ///< Method::name
    int surveys = 0;            ///< tried
    int failed = 0;             ///< of these: refused, or not converged
    std::string first_failure;  ///< in words; empty where none failed

    LengthErrors errors;  ///< empty vectors where all failed
    /// The same as errors.mse, over the edges that carry tension in the true form: no form shows
    /// the length of a slack one [m2].
    double mse_of_taut = 0.0;
    double coverage = 0.0;  ///< part of the true length deviations inside their 95 % interval
    FormErrorSummary
        form_error;  ///< of the predicted form: each number's mean over the surveys [m]
    int forms_not_converged = 0;  ///< identified, but left out of form_error: not in balance

    double training_seconds = 0.0;  ///< Method::training_seconds
    double seconds = 0.0;  ///< mean of one identification, in its thread while others do others

    /// How many did not fail.
    [[nodiscard]] int identified() const { return surveys - failed; }
};

/// What a method made of surveys: the sum, and each by itself.
struct Evaluation {
    MethodResult result;                                         ///< over all surveys
    std::vector<std::optional<Identification>> identifications;  ///< of each trial; empty: failed
};

/// Tries a method on surveys, in parallel on the threads of oneTBB where it does not use them
/// itself. The outcome does not depend on their number. What a method throws counts as a failure,
/// but for std::bad_alloc.
/// @param method of this net, called from several threads at once unless it uses all of them itself
/// @param progress told of the stage "identification" after each trial
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT Evaluation evaluate(const CableNet& net, const Method& method,
                                                         const std::vector<Trial>& trials,
                                                         const Progress& progress = {});

/// The least mean squared error that can be expected, to first order: the mean over edges and
/// surveys of best_possible_variances() at the truth [m2].
struct BestPossible {
    double mse = 0.0;          ///< over all interior edges
    double mse_of_taut = 0.0;  ///< over the edges that carry tension in the true form
};

/// The least error that can be expected of these surveys.
/// @param trials of this net, at least one
/// @return nothing where the statics of a true form are singular: a slack mechanism
/// @throws std::invalid_argument as best_possible_variances()
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::optional<BestPossible> best_possible(
    const CableNet& net, const LengthPrior& prior, const std::vector<Trial>& trials);

}  // namespace taut
