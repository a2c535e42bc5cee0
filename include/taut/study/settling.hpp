// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "taut/export/adjustment.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/progress.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/study/slack_reliability.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Which surveys are tried.
struct TAUT_ADJUSTMENT_EXPORT SettlingSettings {
    int surveys = 100;  ///< of each net
    int first = 0;      ///< number of the first: a survey follows from net, seed and its number
    std::uint64_t seed = 1;  ///< of all surveys of a net

    /// Whether there is a survey to try.
    /// @throws std::invalid_argument naming the field, for fewer than one survey or a first below 0
    void check() const;
};

/// A random survey whose truth is known. Drawn: the prior, uniform to +-2 or +-5 mm; the noise of a
/// coordinate, 0.05 to 2 mm, its logarithm uniform; none or a tenth of the free nodes hidden; none
/// or 5 % of the targets (at least one) off by 10 to 50 standard deviations of the noise, in any
/// direction.
struct SettlingSurvey {
    int number = 0;              ///< from 0; with net and seed it tells the survey
    LengthPrior prior;           ///< that the lengths were drawn from
    double noise_std = 0.0;      ///< [m]
    int gross_errors = 0;        ///< number of targets that have one
    Eigen::VectorXd deviations;  ///< true length deviations of the interior edges (m_I) [m]
    std::vector<bool> slack;     ///< interior edges without tension in the true form (m_I)
    Eigen::VectorXd tensions;    ///< true ones of all edges (m) [N]
    Survey survey;               ///< with the noise as it is
};

/// Survey `number` of a net. Where its drawn lengths find no equilibrium others are drawn.
/// @throws std::invalid_argument as check_prior()
/// @throws std::runtime_error where a hundred draws find none
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT SettlingSurvey settling_survey(const CableNet& net,
                                                                    std::uint64_t seed, int number);

/// What maximum a posteriori made of one survey.
struct SettlingOutcome {
    int number = 0;           ///< SettlingSurvey::number
    LengthPrior prior;        ///< that the lengths were drawn from; the method is told
    double noise_std = 0.0;   ///< [m]
    int hidden_nodes = 0;     ///< number of free nodes not surveyed
    int gross_errors = 0;     ///< number of targets that have one
    int slack_edges = 0;      ///< interior, in the true form
    bool settled = false;     ///< its status is "converged"
    std::string message;      ///< where it did not
    double seconds = 0.0;     ///< of a processor
    int inside = 0;           ///< true lengths in their 95 % interval, of all interior edges
    int tensions_told = 0;    ///< of all edges; 0 where the survey does not tell them
    int tensions_inside = 0;  ///< true ones of these in their 95 % interval
    int slack_called = 0;     ///< edges called slack
    int taut_as_slack = 0;    ///< of these, taut
    int slack_as_taut = 0;    ///< slack and called identified
    SlackReliability slack_reliability;  ///< of all edges whose tension was told
};

/// All surveys of one net. Coverage and the calls of slack count those that settled.
struct TAUT_ADJUSTMENT_EXPORT SettlingRecord {
    std::string net;                        ///< its name
    int free_nodes = 0;                     ///< n_I
    int interior_edges = 0;                 ///< m_I
    std::vector<SettlingOutcome> outcomes;  ///< one a survey, by number

    /// How many surveys settled.
    [[nodiscard]] int settled() const;
    /// Of all surveys; 0 where there is none [s].
    [[nodiscard]] double median_seconds() const;
    /// Of all surveys; 0 where there is none [s].
    [[nodiscard]] double largest_seconds() const;
    [[nodiscard]] double coverage() const;  ///< of the 95 % intervals; 0 where none settled
    /// Sum of a count over the surveys that settled.
    [[nodiscard]] int sum(int SettlingOutcome::* count) const;
    /// Over the surveys that settled.
    [[nodiscard]] SlackReliability slack_reliability() const;
};

/// Identifies random surveys of a net by maximum a posteriori, one after the other, so that times
/// can be compared.
/// @param progress told of the stage "identification" after each survey
/// @throws std::invalid_argument as SettlingSettings::check() and settling_survey()
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT SettlingRecord try_settling(const CableNet& net,
                                                                 const SettlingSettings& settings,
                                                                 const Progress& progress = {});

}  // namespace taut
