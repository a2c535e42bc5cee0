// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "taut/adjustment/limits.hpp"
#include "taut/adjustment/plan.hpp"
#include "taut/adjustment/request_error.hpp"
#include "taut/adjustment/suggested_edges.hpp"
#include "taut/adjustment/turn_order.hpp"
#include "taut/export/adjustment.hpp"

namespace taut {

/// A stage of the work as it is given.
struct GivenStage {
    std::string group;  ///< of edges of the net
    double part = 1.0;  ///< WorkStage::part
};

/// What a plan is to keep to and to find, in terms that need no net: groups go by their names.
struct PlanRequest {
    PlanOptions options = {};  ///< their edges in any order; empty: the net's adjustable edges
    double stroke = 15e-3;     ///< largest change of length of an edge from now on, either way [m]
    /// In place of `stroke`; edges that are not named are not turned. Empty: `stroke` of all.
    std::vector<StrokeRange> stroke_ranges = {};
    /// Largest deviation of an edge to turn from its designed length, either way [m].
    std::optional<double> total_stroke = {};
    std::vector<TensionRange> tension = {};    ///< those of groups override those of all edges
    std::vector<ReactionBound> reaction = {};  ///< all hold together
    std::vector<AddedLoads> load_cases = {};   ///< under each, all limits of forces hold as well
    int crews = 1;                             ///< TurnOrderOptions::crews
    std::vector<GivenStage> stages = {};       ///< become TurnOrderOptions::stages
    int suggest_adjustable = 0;                ///< count of suggested_edges(); 0: none
    std::optional<Thread> thread = {};         ///< of all turnbuckles; empty: as in the net
    std::vector<GivenTension> target_tension = {};  ///< become options.target_tensions
};

/// Checks a range by itself; what it is of, plan_turns() does.
/// @throws RequestError for a lower limit that is negative or not below the upper one, and parts
///   above 1
TAUT_ADJUSTMENT_EXPORT void check_tension_range(const TensionRange& range);

/// A plan, the order of its work, and what it was made with.
struct PlannedTurns {
    PlanOptions options;  ///< as resolved
    Limits limits;        ///< as resolved, without the plan's margins
    Plan plan;            ///< strokes, and their results
    TurnOrder order;      ///< of the plan's strokes
    std::optional<std::vector<SuggestedEdge>> suggested_adjustable;  ///< where asked for
    int crews = 1;                                                   ///< that `order` is for
    std::optional<Thread> thread;  ///< of all turnbuckles; empty: as in the net
};

/// All of a plan: the edges that a request allows to turn and all limits by edge and support, then
/// plan_strokes(), order_turns() and, where asked for, suggested_edges(). Turnings get
/// expected_frequency() of the designed net.
/// @param net as designed
/// @param built the net as it stands
/// @param target of the same net, which is not checked
/// @throws RequestError for a stroke or total stroke that is not positive, a turnbuckle that is
///   further from its designed length than the total stroke, strokes of an edge that is not
///   adjustable or of none that may be turned, a group that the net does not have, a range of
///   tensions whose lower end is negative or not below its upper, parts above 1 or without breaking
///   loads, a limit of reactions at a group without support, target tensions of what the net does
///   not have or that contradict each other, a form tolerance without target tensions, a negative
///   suggest_adjustable, and a stage of which no edge may be turned
/// @throws std::invalid_argument for added loads of a wrong size
/// @throws what plan_strokes(), order_turns() and suggested_edges() throw
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT PlannedTurns plan_turns(const CableNet& net,
                                                             const BuiltNet& built,
                                                             const FormTarget& target,
                                                             const PlanRequest& request = {},
                                                             const Progress& progress = {});

}  // namespace taut
