// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/adjustment/plan_turns.hpp"
#include "taut/export/adjustment.hpp"

namespace taut {

/// A request in terms of a net.
struct ResolvedRequest {
    PlanOptions options;  ///< with the edges that may be turned, ascending
    Limits limits;        ///< of these edges and of the net
};

/// The edges that a request allows to turn, and all limits by edge and support.
/// @param net as designed
/// @param built the same net as it stands: not checked
/// @throws RequestError for a stroke or total stroke that is not positive, a turnbuckle that
///   is further from its designed length than the total stroke, strokes of an edge that is not
///   adjustable or of none that may be turned, a group that the net does not have, a range of
///   tensions whose lower end is negative or not below its upper, parts above 1 or without breaking
///   loads, a limit of reactions at a group without support, target tensions of what the net does
///   not have or that contradict each other, and a form tolerance without target tensions
/// @throws std::invalid_argument for added loads of a wrong size
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT ResolvedRequest resolve(const CableNet& net,
                                                             const BuiltNet& built,
                                                             const PlanRequest& request);

}  // namespace taut
