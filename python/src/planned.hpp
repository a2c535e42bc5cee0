// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "taut/adjustment/built_net.hpp"
#include "taut/adjustment/limits.hpp"
#include "taut/adjustment/plan.hpp"
#include "taut/adjustment/suggested_edges.hpp"
#include "taut/adjustment/turn_order.hpp"
#include "taut/identification/trust.hpp"
#include "taut/net/cable_net.hpp"

namespace taut::python {

/// A plan with what it was made from.
struct Planned {
    CableNet net;
    BuiltNet built;
    Trust trust;
    Points target;  ///< 3 x n [m]
    Limits limits;
    PlanOptions options;
    Plan plan;
    TurnOrder order;
    std::optional<std::vector<SuggestedEdge>> suggested_adjustable;
    int crews = 1;
    std::optional<Thread> thread;
};

}  // namespace taut::python
