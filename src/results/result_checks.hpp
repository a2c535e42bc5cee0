// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "files/json_value.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

// What no part of a result may say against another. All throw InputError at the part that does.

/// Wherever an "edge" or a "node" is named, outside of "cable_net", it is one of the net; "id",
/// "edge_id" and "nodes" beside it are its own.
void check_names(const JsonValue& root, const CableNet& net);

/// The supports of a form (3 x n) stand at their places in another.
/// @param form that the points were read from
/// @param where of the places, for the message: "/cable_net"
void check_supports(const JsonValue& form, const Points& points, const CableNet& net,
                    const Points& places, const std::string& where);

/// An edge's standard deviation is one that its 95 % interval allows.
/// @param farthest distance between two lengths that the prior allows [m]
void check_std(const JsonValue& value, const IdentifiedEdge& edge, double farthest);

}  // namespace taut
