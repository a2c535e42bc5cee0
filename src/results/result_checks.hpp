// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "files/json_value.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

// Consistency of the parts of a result. All throw InputError at the part that contradicts another.

/// Every "edge" and "node" outside of "cable_net" is one of the net; "id", "edge_id" and "nodes"
/// beside it belong to it.
void check_names(const JsonValue& root, const CableNet& net);

/// The supports of a form (3 x n) are at the given places.
/// @param form that the points were read from
/// @param where of the places, for the message: "/cable_net"
void check_supports(const JsonValue& form, const Points& points, const CableNet& net,
                    const Points& places, const std::string& where);

/// An edge's standard deviation agrees with its 95 % interval.
/// @param farthest largest distance of two lengths that the prior allows [m]
void check_std(const JsonValue& value, const IdentifiedEdge& edge, double farthest);

}  // namespace taut
