// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/observations.hpp"
#include "taut/sampling/length_prior.hpp"

namespace taut {

/// Edges (m) that are slack by their lengths, whatever the survey shows of their unstressed
/// lengths: adjustable ones shorter than their known unstressed length, and interior ones that
/// would be taut only at a deviation of more than three standard deviations of the prior (outside a
/// uniform one). docs/theory.md, (slack-form)
/// @param lengths of all edges, at the reference temperature (m) [m]
/// @param priors one an interior edge (m_I)
[[nodiscard]] std::vector<bool> slack_by_lengths(const CableNet& net,
                                                 const Eigen::VectorXd& lengths,
                                                 const std::vector<LengthPrior>& priors);

/// Edges (m) measured shorter than they can be while taut, by more than three standard deviations
/// of the measurement. docs/theory.md, (slack-survey)
/// @param length_stds standard deviation of each length by what edges have in common (m); empty:
///   known [m]
[[nodiscard]] std::vector<bool> slack_by_survey(const CableNet& net,
                                                const Observations& observations,
                                                const std::vector<LengthPrior>& priors,
                                                const Eigen::VectorXd& length_stds = {});

/// The slack edges (m) of which both ends were measured.
[[nodiscard]] std::vector<bool> where_measured(const CableNet& net,
                                               const Observations& observations,
                                               std::vector<bool> slack);

}  // namespace taut
