// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "taut/adjustment/plan.hpp"
#include "taut/export/adjustment.hpp"

namespace taut {

/// One action of a crew at one turnbuckle.
struct Turning {
    int edge = 0;            ///< index in the net
    double stroke = 0.0;     ///< [m]
    int pass = 1;            ///< over the net, from 1
    int crew = 1;            ///< from 1
    int step = 0;            ///< from 0; in one step each crew turns at most one edge
    double tension = 0.0;    ///< of the edge after the step, in the estimate [N]
    double length = 0.0;     ///< between its ends then [m]
    double frequency = 0.0;  ///< its first natural one then; 0 without mass, see plan_turns() [Hz]
};

/// The step with the worst breach: in the estimate, else in most samples.
struct WorstStep {
    int step = -1;       ///< Turning::step; -1: no limit is broken
    LimitBreach breach;  ///< its probability is that the limit is kept at this step
};

/// A part of the work that is finished before the next begins: some edges, up to a part of their
/// strokes.
struct WorkStage {
    std::string name;        ///< for people
    std::vector<int> edges;  ///< of the net; those that are not turned do not count
    double part = 1.0;       ///< of their strokes that is done then, above 0 and at most 1
};

/// What is at the end of a stage.
struct StageEnd {
    std::string name;            ///< WorkStage::name; "rest" of what no stage holds
    double part = 1.0;           ///< of the strokes of its edges
    int step = -1;               ///< Turning::step of the last; -1: nothing was turned so far
    double least_tension = 0.0;  ///< over all edges, in the estimate [N]
    double most_tension = 0.0;   ///< likewise
    /// Probability that no step until then breaks a limit, as TurnOrder::safe_probability.
    double safe_probability = 0.0;
};

/// The order in which strokes are turned.
struct TurnOrder {
    std::vector<Turning> turnings;  ///< in the order of the work
    /// Over the net: 1, 2, 4 or 8 in each stage, counted through all of them; 0 where nothing is
    /// turned.
    int passes = 0;
    std::vector<StageEnd> stages;  ///< in their order; none where none were given
    double walk = 0.0;             ///< of all crews, along straight lines between stations [m]
    /// Probability that no step breaks a limit: the part of the samples; 0 or 1 without samples. A
    /// limit that was broken before the work counts as kept while it is broken by no more.
    double safe_probability = 0.0;
    /// No step breaks a limit in the estimate, nor in the samples with the required probability.
    bool is_safe = false;
    WorstStep worst;  ///< where the order is not safe
};

/// Crews, and how finely they turn.
struct TurnOrderOptions {
    int crews = 1;  ///< that work at the same time, 1 to 100
    /// One after the other; what none holds comes last. Empty: all at once.
    std::vector<WorkStage> stages = {};
    double turn_step = 0.0;     ///< smallest change of length; 0: any [m]
    double confidence = 0.95;   ///< required probability that the work is safe
    double actuator_std = 0.0;  ///< as PlanOptions::actuator_std [m]
    std::uint64_t seed = 1;     ///< of the random errors of the strokes
};

/// Orders the turnings so that no step breaks a limit, from neighbour to neighbour: in one pass
/// over the net if possible, else in two, four or eight, each with its part of every stroke. Every
/// step is checked in exact equilibrium, of the estimate and of the samples. Where no order is safe
/// with the required probability, the safest one found. docs/theory.md (turn-order).
/// @param built, limits that the plan was made with
/// @param plan of this net
/// @param progress gets the stage "ordering", 0 of 0
/// @throws std::invalid_argument for a stage whose part is not above 0 and at most 1, or is not
/// more
///   than what a stage before has done of an edge; for crews below 1 or above 100, a negative
///   turn_step or actuator_std, a confidence outside (0, 1), what plan_strokes() refuses of limits,
///   and a plan of another net or other limits
/// @throws std::out_of_range for an edge of a stage that the net does not have
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT TurnOrder order_turns(const BuiltNet& built,
                                                           const Limits& limits, const Plan& plan,
                                                           const TurnOrderOptions& options = {},
                                                           const Progress& progress = {});

}  // namespace taut
