// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/export/core.hpp"
#include "taut/identification/length_estimates.hpp"
#include "taut/identification/model.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Identifies by trained processes (eq. ident). Where the survey has noise, or misses nodes, the
/// processes are asked at the conditional mean of the form, docs/theory.md (conditioning), and the
/// uncertainty that is left goes through them to first order (propagation). Prior and slack edges
/// then enter as in (posterior). Gross errors are rejected by data snooping.
/// @param at_survey estimate_lengths() at the surveyed form, where that was asked of many forms at
///   once; used where the survey is exact and whole
[[nodiscard]] TAUT_CORE_EXPORT Identification
identify_by_processes(const CableNet& net, const LengthModel& model, const Survey& survey,
                      const LengthEstimates* at_survey = nullptr);

/// Eq. ident as it stands, on the surveyed form as it is: the processes' means, their standard
/// deviations and the intervals of a normal prior, docs/theory.md (as-in-paper). Only edges that
/// are slack in the predicted form get the interval of (slack-bound).
/// @param model trained as in the paper
/// @param at_survey as above
/// @throws SurveyError where a free node was not surveyed
[[nodiscard]] TAUT_CORE_EXPORT Identification
identify_as_in_paper(const CableNet& net, const LengthModel& model, const Survey& survey,
                     const LengthEstimates* at_survey = nullptr);

}  // namespace taut
