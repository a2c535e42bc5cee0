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

/// How well one method identified the lengths of many surveys. Failures are counted, and left out
/// of all other numbers.
struct MethodResult {
    std::string name;           ///< Method::name
    int surveys = 0;            ///< tried
    int failed = 0;             ///< of these: refused, or not converged
    std::string first_failure;  ///< in words; empty where none failed

    LengthErrors errors;  ///< empty vectors where all failed
    /// errors.mse over the edges that are taut in the true form: no form shows the length of a
    /// slack one [m2].
    double mse_of_taut = 0.0;
    double coverage = 0.0;        ///< part of the true length deviations inside their 95 % interval
    FormErrorSummary form_error;  ///< of the predicted form, mean over the surveys [m]
    int forms_not_converged = 0;  ///< predicted forms out of balance: left out of form_error

    double training_seconds = 0.0;  ///< Method::training_seconds
    double seconds = 0.0;  ///< mean wall time of one identification, while other threads work

    [[nodiscard]] int identified() const { return surveys - failed; }  ///< that gave lengths
};

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

/// Cramer-Rao bound of the mean squared error of the lengths: the mean over edges and surveys of
/// cramer_rao_variances() at the truth [m2].
struct CramerRaoBound {
    double mse = 0.0;          ///< over all interior edges
    double mse_of_taut = 0.0;  ///< over the edges that are taut in the true form
};

/// The bound for these surveys.
/// @param trials of this net, at least one
/// @return nothing where the statics of a true form are singular: a slack mechanism
/// @throws std::invalid_argument as cramer_rao_variances()
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::optional<CramerRaoBound> cramer_rao_bound(
    const CableNet& net, const LengthPrior& prior, const std::vector<Trial>& trials);

}  // namespace taut
