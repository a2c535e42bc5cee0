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
    truth,       ///< the true net: the best possible result
    identified,  ///< lengths identified from the survey of each round
    nominal,     ///< no identification: the design, moved by the surveyed deviations
    once,        ///< as nominal, in the first round alone
};

/// "true lengths", "identified", "design", "design, once".
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::string_view to_string(ControlStrategy strategy);

/// Simulated jobs: nets are built, surveyed, turned, surveyed again, and so on.
struct ControlSettings {
    LengthPrior prior;  ///< of the length deviations as built; given to "identified"
    /// What else is uncertain: each net is built with values of its own, and "identified" is given
    /// their standard deviations alone. with_site_assumptions() has the program's defaults.
    std::vector<UncertainParameter> uncertain = {};
    double noise_std = 0.5e-3;   ///< of a surveyed coordinate [m]
    double hidden_part = 0.1;    ///< of the free nodes, in each survey
    double actuator_std = 0.0;   ///< standard deviation of a stroke from the planned one [m]
    double stroke = 15e-3;       ///< of a turnbuckle since installation, either way [m]
    double least_tension = 0.0;  ///< [N]
    double most_tension = 0.0;   ///< 0: no limit [N]
    double confidence =
        0.95;  ///< required probability of keeping limits, of plans on identified lengths
    std::optional<TurnSize> turn;  ///< empty: any stroke can be turned
    int draws = 200;               ///< posterior samples of each identification; 0: none
    int rounds = 4;                ///< of survey, plan and turns, 1 to 100
    int trials = 20;         ///< nets that are built, 1 to 100,000; the same for all strategies
    std::uint64_t seed = 1;  ///< of lengths, surveys and errors of strokes
};

/// The true net after a round; round 0 is as built.
struct ControlState {
    int trial = 0;               ///< from 0
    int round = 0;               ///< from 0, as built
    FormDeviation deviation;     ///< of the true form from the design
    double least_tension = 0.0;  ///< of all edges [N]
    double most_tension = 0.0;   ///< of all edges [N]
    int broken = 0;              ///< edges whose true tension breaks a limit
    double worst_excess = 0.0;   ///< over a limit, relative to it; 0: none; 1 of a slack edge
    double turned = 0.0;         ///< sum of this round's strokes in absolute value [m]
    bool has_failed = false;     ///< no identification or plan came about; nothing was turned
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
        double mean = 0.0;           ///< 3D deviation [m]
        double max = 0.0;            ///< the most in any trial [m]
        double least_tension = 0.0;  ///< the least in any trial [N]
        double most_tension = 0.0;   ///< the most in any trial [N]
        double turned = 0.0;         ///< mean of ControlState::turned [m]
        int broken_trials = 0;       ///< number of those in which an edge breaks a limit
        double worst_excess = 0.0;   ///< the most in any trial
        int failed = 0;              ///< number of trials in which nothing could be planned
    };
    /// Means of one round.
    /// @param round an existing one, from 0; else all means are NaN
    [[nodiscard]] Round after(int round) const;
};

/// Simulates the whole loop of survey, identification, plan and turns under each strategy. The net
/// of a trial, its surveys and the errors of its strokes follow from the seed.
/// @throws std::invalid_argument for settings out of range, and as check_uncertain_parameters() and
///   plan_strokes()
/// @param progress gets the stage "control" before each job and at the end
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::vector<ControlRecord> simulate_control(
    const CableNet& net, const ControlSettings& settings, const Progress& progress = {});

}  // namespace taut
