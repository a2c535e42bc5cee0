// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/adjustment/plan_turns.hpp"
#include "taut/export/io.hpp"
#include "taut/identification/trust.hpp"
#include "taut/results/results_json.hpp"

namespace taut {

/// The parts of a saved plan. All pointers must be set, to parts that belong together and live
/// until the plan is written: not checked.
struct PlanRecord {
    const CableNet* net = nullptr;        ///< as designed
    const BuiltNet* built = nullptr;      ///< that the plan begins with
    const Trust* trust = nullptr;         ///< of the identification that it is based on
    const FormTarget* target = nullptr;   ///< of the plan
    const PlannedTurns* turns = nullptr;  ///< the plan, and what it was made with
};

/// Why nobody should turn by a plan, the worst reason first, one line each; they head all lists.
[[nodiscard]] TAUT_IO_EXPORT std::vector<std::string> plan_warnings(const PlanRecord& record);

/// plan.json: format "taut-plan", version 2; all numbers in SI units.
[[nodiscard]] TAUT_IO_EXPORT std::string plan_to_json(const PlanRecord& record,
                                                      const RunRecord& run = {});

/// The work list of the crews, one line per turning in the order of the work: number (from 1),
/// crew, pass, step (from 1), edge, id of the support at the edge's end (empty where it has none),
/// action, rotation (empty without thread), turns, stroke [mm], scale reading afterwards [mm],
/// tension after all work [kN], first natural frequency of the edge after this step [Hz]. Lines
/// with # before it hold plan_warnings().
[[nodiscard]] TAUT_IO_EXPORT std::string plan_to_csv(const PlanRecord& record);

/// "shorten", or "lengthen" for 0 and more.
[[nodiscard]] TAUT_IO_EXPORT std::string_view action_of(double stroke);

/// "clockwise" or "counterclockwise", seen from the support along the cable; empty without thread.
[[nodiscard]] TAUT_IO_EXPORT std::optional<std::string_view> rotation_of(
    double stroke, std::optional<Thread> thread);

}  // namespace taut
