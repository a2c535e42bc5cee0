// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/adjustment/built_net.hpp"
#include "taut/adjustment/form_target.hpp"
#include "taut/adjustment/plan_turns.hpp"
#include "taut/identification/trust.hpp"
#include "taut/net/cable_net.hpp"

namespace taut::python {

/// A plan with what it was made from.
struct Planned {
    CableNet net;
    BuiltNet built;
    Trust trust;
    GivenTarget target;
    PlannedTurns turns;
};

}  // namespace taut::python
