// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

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

/// The worst that forces do on the way.
struct WorstMoment {
    int moment = -1;     ///< of TurnOrder::turnings; -1: nothing is worse than before the work
    LimitBreach breach;  ///< then
};

/// In which order strokes are turned.
struct TurnOrder {
    std::vector<Turning> turnings;  ///< in the order of the work
    int passes = 0;                 ///< over the net: 1, 2, 4 or 8; 0 where nothing is to be turned
    double walk = 0.0;              ///< of all crews, along straight lines between stations [m]
    /// No force is beyond its limits at any moment, but for what was beyond before the work began
    /// and then is no worse.
    bool is_safe = false;
    WorstMoment worst;  ///< where it is not
};

/// Who turns, and how finely.
struct TurnOrderOptions {
    int crews = 1;      ///< that work at the same time, 1 to 100
    double step = 0.0;  ///< of what is turned at once; 0: any [m]
};

/// Looks for passes over the net in which no cable leaves its limits at any moment: neighbouring
/// stations together, in one pass if that can be, else in two, four or eight, each with its part of
/// every stroke. Exact equilibrium after every moment. docs/theory.md (turn-order).
/// @param built, limits as the plan was made with
/// @param plan of this net; its limits hold for the estimate, narrowed by nine tenths of what the
///   plan's were
/// @param progress told of the stage "ordering", 0 of 0
/// @throws std::invalid_argument for crews below 1 or above 100, a step that is negative, and what
///   plan_strokes() refuses of limits; for a plan of another net or other limits
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT TurnOrder order_turns(const BuiltNet& built,
                                                           const Limits& limits, const Plan& plan,
                                                           const TurnOrderOptions& options = {},
                                                           const Progress& progress = {});

}  // namespace taut
