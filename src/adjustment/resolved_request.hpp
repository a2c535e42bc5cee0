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
/// @throws RequestError, std::invalid_argument as plan_turns()
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT ResolvedRequest resolve(const CableNet& net,
                                                             const BuiltNet& built,
                                                             const PlanRequest& request);

}  // namespace taut
