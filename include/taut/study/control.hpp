// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "taut/adjustment/plan.hpp"
#include "taut/export/adjustment.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/progress.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {

/// What is known of the net when turns are planned.
enum class ControlStrategy {
    truth,       ///< the true net: the best that turning can do
    identified,  ///< lengths identified from the survey of each round
    nominal,     ///< no identification: the design, moved by what the survey tells
    once,        ///< the same, in the first round alone
};

/// "true lengths", "identified", "design", "design, once".
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::string_view to_string(ControlStrategy strategy);

/// A job: nets are built, surveyed, turned, and so on.
struct ControlSettings {
    LengthPrior prior;  ///< of the length deviations as built; "identified" is told
    /// What else is uncertain: each net is built with values of its own, and "identified" knows the
    /// widths alone. Empty: nothing; with_site_assumptions() has what the program assumes.
    std::vector<UncertainParameter> uncertain = {};
    double noise_std = 0.5e-3;     ///< of a surveyed coordinate [m]
    double hidden_part = 0.1;      ///< of the free nodes, in each survey
    double actuator_std = 0.0;     ///< of what is turned, from what was told [m]
    double stroke = 15e-3;         ///< of a turnbuckle since installation, either way [m]
    double least_tension = 0.0;    ///< [N]
    double most_tension = 0.0;     ///< 0: no limit [N]
    double confidence = 0.95;      ///< of the limits, of plans on identified lengths
    std::optional<TurnSize> turn;  ///< empty: any stroke can be turned
    int draws = 200;         ///< of each identification; 0: limits are held for the estimate alone
    int rounds = 4;          ///< of survey, plan and turns, 1 to 100
    int trials = 20;         ///< nets that are built, 1 to 100,000; the same for all strategies
    std::uint64_t seed = 1;  ///< of lengths, surveys and play
};

/// The true net after a round; round 0 is as built.
struct ControlState {
    int trial = 0;               ///< from 0
    int round = 0;               ///< from 0, as built
    FormDeviation deviation;     ///< of the true form from the design
    double least_tension = 0.0;  ///< of all edges [N]
    double most_tension = 0.0;   ///< of all edges [N]
    /// Edges whose true tension is beyond a limit, and by how much the worst is, as a part of the
    /// limit.
    int broken = 0;
    double worst_excess = 0.0;  ///< 0 where none is; 1 of a slack edge
    double turned = 0.0;        ///< sum of the sizes of this round's strokes [m]
    bool has_failed = false;    ///< no identification or plan came about; nothing was turned
};

/// All jobs of one strategy.
struct TAUT_ADJUSTMENT_EXPORT ControlRecord {
    ControlStrategy strategy = ControlStrategy::identified;  ///< by which all was planned
    std::vector<ControlState> states;                        ///< by trial, then round

    /// Means over the trials after a round.
    struct Round {
        double normal_rmse = 0.0;    ///< root of the mean square over trials [m]
        double normal_mean = 0.0;    ///< along the target's normal [m]
        double normal_max = 0.0;     ///< the most in any trial [m]
        double mean = 0.0;           ///< in all directions [m]
        double max = 0.0;            ///< the most in any trial [m]
        double least_tension = 0.0;  ///< the least in any trial [N]
        double most_tension = 0.0;   ///< the most in any trial [N]
        double turned = 0.0;         ///< mean of ControlState::turned [m]
        int broken_trials = 0;       ///< number of those with an edge beyond a limit
        double worst_excess = 0.0;   ///< the most in any trial
        int failed = 0;              ///< number of trials in which nothing could be planned
    };
    /// Means of one round.
    /// @param round one that there is, from 0: of another all means are no numbers
    [[nodiscard]] Round after(int round) const;
};

/// The whole loop, simulated: survey, identification, plan, turns, again, beside its rivals. The
/// net of a trial, its surveys and the play of its turnbuckles follow from the seed.
/// @throws std::invalid_argument for settings that cannot be meant, as
/// check_uncertain_parameters(), and as
///   plan_strokes()
/// @param progress told of the stage "control" before each job and at the end
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::vector<ControlRecord> simulate_control(
    const CableNet& net, const ControlSettings& settings, const Progress& progress = {});

}  // namespace taut
