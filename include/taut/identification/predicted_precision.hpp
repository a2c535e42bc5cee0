// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/estimation/edge_status.hpp"
#include "taut/export/core.hpp"
#include "taut/progress.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"
#include "taut/survey/forces.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Predicted precision of one interior edge's unstressed length.
struct EdgePrecision {
    int edge = 0;                                ///< index in the net
    double std_dev = 0.0;                        ///< of the length deviation, after the survey [m]
    EdgeStatus status = EdgeStatus::determined;  ///< that an identification most probably gives
};

/// Predicted precision of one edge's tension, and the gain by measuring it.
struct TensionPrecision {
    int edge = 0;          ///< index in the net
    double tension = 0.0;  ///< in the form of the prediction [N]
    double std_dev = 0.0;  ///< of the tension, after the survey and the given measurements [N]
    /// Standard deviation of the mean tension if this edge's is measured, too [N].
    double mean_std_if_measured = 0.0;
};

/// Predicted precision of all lengths and tensions, before a survey is made.
struct TAUT_CORE_EXPORT PredictedPrecision {
    double prior_std = 0.0;            ///< of each length deviation, before the survey [m]
    std::vector<EdgePrecision> edges;  ///< one an interior edge, in their order

    double mean_tension = 0.0;      ///< over all cables, in the form of the prediction [N]
    double mean_tension_std = 0.0;  ///< after the survey and the given measurements [N]
    /// All taut edges without a given measurement, the one whose measurement gains most first.
    std::vector<TensionPrecision> force_candidates;

    /// How many edges have a status.
    [[nodiscard]] int count(EdgeStatus status) const;
    /// Root mean square of the edges' standard deviations [m].
    [[nodiscard]] double rms_std() const;
};

/// What a prediction knows besides the survey.
struct PredictOptions {
    Forces forces = {};  ///< whose edges are measured, and their noise; the tensions are not used
    std::vector<UncertainParameter> uncertain = {};  ///< besides the lengths
    /// Whether what is not among `uncertain` has the widths of a site, with_site_assumptions(), as
    /// identify() takes it by default. An exact survey takes the net as exact.
    bool assume_site = true;
    double relative_force_std = 0.02;  ///< of one more measurement, as a part of the tension
};

/// Standard deviations to first order at the nominal lengths and their form, with the prior taken
/// as a normal one of the same variance: the Cramer-Rao bound. Of the net as built, which
/// nobody knows before, they differ to second order. Each status is the one that an identification
/// most probably gives, over deviations from the prior and errors of the survey: by its own rule,
/// under the prior itself. Slack are the edges without tension in
/// this form.
/// @param form equilibrium of the nominal lengths (3 x n) [m]
/// @param survey which nodes, and their noise; its form is not used
/// @param progress asked whether to stop; gets no reports
/// @throws Interrupted where a stop was requested
/// @throws std::invalid_argument for a form of the wrong size or not finite, as
///   LengthPrior::check(), check_forces(), check_uncertain_parameters(), and where the net has no
///   interior edge
/// @throws SurveyError as check_survey(), and where the survey is exact and not whole
/// @throws std::runtime_error where the statics are singular at this form
[[nodiscard]] TAUT_CORE_EXPORT PredictedPrecision predicted_precision(
    const CableNet& net, const Eigen::Ref<const Points>& form, const Survey& survey,
    const LengthPrior& prior, const PredictOptions& options = {}, const Progress& progress = {});

}  // namespace taut
