// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "taut/export/adjustment.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/study/comparison.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// A survey whose truth is known.
struct Trial {
    Eigen::VectorXd deviations;  ///< true length deviations of the interior edges (m_I) [m]
    Points form;                 ///< true form (3 x n) [m]
    std::vector<bool> slack;     ///< interior edges without tension in the true form (m_I)
    Survey survey;               ///< with its true noise as the standard deviation
    /// All surveys where there are several; form, slack and survey are of the last.
    std::vector<Epoch> epochs;
};

/// Simulates surveys of samples of a data set. Noise and hidden nodes of a trial follow from the
/// seed and the sample alone. So trials of two kinds differ in nothing but the kind: the noise is
/// the same up to its size.
/// @param data of this net, which is not checked
/// @param samples which, 0 to data.size() - 1, not checked; their forces must balance
/// @throws std::invalid_argument as simulate_survey(), and for noise so large that surveyed points
///   are nowhere near their nodes
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::vector<Trial> simulate_trials(
    const CableNet& net, const DataSet& data, const std::vector<int>& samples,
    const SurveyKind& kind, std::uint64_t seed);

/// The same trials, surveyed once more: as they stand, or after every adjustable edge was turned by
/// a known random stroke within 5 mm and a twentieth of its length either way.
/// @throws std::invalid_argument as simulate_trials(), and where a net as turned finds no
///   equilibrium
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::vector<Trial> surveyed_again(const CableNet& net,
                                                                       std::vector<Trial> trials,
                                                                       const SurveyKind& kind,
                                                                       bool is_turned,
                                                                       std::uint64_t seed);

}  // namespace taut
