// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "taut/adjustment/plan.hpp"
#include "taut/export/adjustment.hpp"

namespace taut {

/// One thing that a crew does at one turnbuckle.
struct Turning {
    int edge = 0;         ///< index in the net
    double stroke = 0.0;  ///< [m]
    int pass = 1;         ///< over the net, from 1
    int crew = 1;         ///< from 1
    int moment = 0;       ///< those of one moment are turned at once, one a crew; from 0
};

/// The worst that forces do on the way: in the estimate, else in most draws.
struct WorstMoment {
    int moment = -1;     ///< of TurnOrder::turnings; -1: nothing is worse than before the work
    LimitBreach breach;  ///< then; its probability is that it is kept at that moment
};

/// In which order strokes are turned.
struct TurnOrder {
    std::vector<Turning> turnings;  ///< in the order of the work
    int passes = 0;                 ///< over the net: 1, 2, 4 or 8; 0 where nothing is to be turned
    double walk = 0.0;              ///< of all crews, along straight lines between stations [m]
    /// That no force is beyond its limits at any moment, but for what was beyond before the work
    /// began and then is no worse: the part of the draws; 0 or 1 without draws.
    double safe_probability = 0.0;
    /// So it is in the estimate, and over the draws with the confidence wanted.
    bool is_safe = false;
    WorstMoment worst;  ///< where it is not
};

/// Who turns, and how finely.
struct TurnOrderOptions {
    int crews = 1;              ///< that work at the same time, 1 to 100
    double step = 0.0;          ///< of what is turned at once; 0: any [m]
    double confidence = 0.95;   ///< with which the work is to be safe, over the draws
    double actuator_std = 0.0;  ///< as PlanOptions::actuator_std [m]
    std::uint64_t seed = 1;     ///< of the play of the turnbuckles
};

/// Looks for passes over the net in which no cable leaves its limits at any moment: neighbouring
/// stations together, in one pass if that can be, else in two, four or eight, each with its part of
/// every stroke. Exact equilibrium after every moment, of the estimate and of the draws. Where no
/// order is safe with the confidence, the one that is safe in most draws. docs/theory.md
/// (turn-order).
/// @param built, limits as the plan was made with
/// @param plan of this net
/// @param progress told of the stage "ordering", 0 of 0
/// @throws std::invalid_argument for crews below 1 or above 100, a step or play that is negative, a
///   confidence outside (0, 1), and what
///   plan_strokes() refuses of limits; for a plan of another net or other limits
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT TurnOrder order_turns(const BuiltNet& built,
                                                           const Limits& limits, const Plan& plan,
                                                           const TurnOrderOptions& options = {},
                                                           const Progress& progress = {});

}  // namespace taut
