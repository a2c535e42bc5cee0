// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/study/error_statistics.hpp"

namespace taut {

/// How well one method identified the lengths of many surveys. Failures are counted, and left out
/// of all other numbers.
struct MethodResult {
    std::string name;           ///< "gp_as_in_paper", "gp", "balance" or "map"
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

    double training_seconds = 0.0;  ///< wall time, a share where trained with others [s]
    double seconds = 0.0;  ///< mean wall time of one identification, while other threads work

    [[nodiscard]] int identified() const { return surveys - failed; }  ///< that gave lengths
};

/// Cramer-Rao bound of the mean squared error of the lengths: the mean over edges and surveys of
/// the bound at the truth [m2].
struct CramerRaoBound {
    double mse = 0.0;          ///< over all interior edges
    double mse_of_taut = 0.0;  ///< over the edges that are taut in the true form
};

}  // namespace taut
