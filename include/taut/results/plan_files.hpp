// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/adjustment/suggested_edges.hpp"
#include "taut/adjustment/plan.hpp"
#include "taut/adjustment/turn_order.hpp"
#include "taut/export/io.hpp"
#include "taut/identification/trust.hpp"
#include "taut/results/results_json.hpp"

namespace taut {

/// All that a saved plan tells of. It refers to what it tells of, which must live until it is
/// written; all pointers must be set, and to what belongs together: not checked.
struct PlanRecord {
    const CableNet* net = nullptr;                    ///< as designed
    const BuiltNet* built = nullptr;                  ///< that the plan begins with
    const Trust* trust = nullptr;                     ///< of the identification that it stands on
    const FormTarget* target = nullptr;               ///< of the plan
    const Limits* limits = nullptr;                   ///< as told, not as narrowed by the plan
    const PlanOptions* options = nullptr;             ///< that the plan was made with
    const Plan* plan = nullptr;                       ///< strokes, and what comes of them
    const TurnOrder* order = nullptr;                 ///< of the plan's strokes
    std::optional<std::vector<SuggestedEdge>> further;  ///< where they were asked for
    int crews = 1;                                    ///< that `order` is for
    std::optional<Thread> thread;  ///< of all, in place of what the net tells of each
};

/// What forbids to turn by a plan, the worst first, in a line each; the first lines of all lists.
[[nodiscard]] TAUT_IO_EXPORT std::vector<std::string> plan_warnings(const PlanRecord& record);

/// plan.json: format "taut-plan", version 1; all numbers in SI units.
[[nodiscard]] TAUT_IO_EXPORT std::string plan_to_json(const PlanRecord& record,
                                                      const RunRecord& run = {});

/// The list that a crew works from, a line each turning, in the order of the work: crew, pass,
/// moment, edge, sense, rotation (empty where the thread is not told), stroke [mm], turns, reading
/// afterwards [mm], tension after all [kN]. Before it, with #, plan_warnings().
[[nodiscard]] TAUT_IO_EXPORT std::string plan_to_csv(const PlanRecord& record);

/// "shorten", or "lengthen" for 0 and more.
[[nodiscard]] TAUT_IO_EXPORT std::string_view action_of(double stroke);

/// "clockwise" or "counterclockwise", seen from the support along the cable; nothing where the
/// thread is not told.
[[nodiscard]] TAUT_IO_EXPORT std::optional<std::string_view> rotation_of(
    double stroke, std::optional<Thread> thread);

}  // namespace taut
