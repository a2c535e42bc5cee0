// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/json_value.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

// Readers for parts of a result that the schema accepts. All throw InputError at a value that
// breaks a rule which no schema can express.

/// Member of an object that the schema says it has.
[[nodiscard]] JsonValue member(const JsonValue& parent, const std::string& key);

/// A member that may be missing or null.
[[nodiscard]] std::optional<JsonValue> find_unless_null(const JsonValue& parent, const char* key);

/// Such a member that is a number.
[[nodiscard]] std::optional<double> optional_number(const JsonValue& parent, const char* key);

/// Entries of a list that may be missing.
[[nodiscard]] std::vector<JsonValue> entries(const JsonValue& parent, const char* key);

/// A member that lists so many numbers.
/// @param what for the message: "a number for each edge"
[[nodiscard]] Eigen::VectorXd require_list(const JsonValue& parent, const std::string& key,
                                           Eigen::Index size, const std::string& what);

/// A member that lists a point [x, y, z] for each node of a net.
[[nodiscard]] Points require_form(const JsonValue& parent, const std::string& key,
                                  const CableNet& net);

/// Checks a member that may be missing or null and lists a covariance for each node of a net.
void check_covariances(const JsonValue& parent, const char* key, const CableNet& net);

/// A node of the net.
[[nodiscard]] int read_node(const JsonValue& value, const CableNet& net);

/// An edge of the net.
[[nodiscard]] int read_edge_index(const JsonValue& value, const CableNet& net);

/// The net of a result, checked against the fingerprint and counts beside it.
[[nodiscard]] CableNet require_net(const JsonValue& root);

/// A count that may be missing.
/// @param why for the message: "as /cable_net has"
void require_equal(const JsonValue& parent, const char* key, int expected, std::string_view why);

/// A number of an object that is at most another one; each may be missing.
void require_at_most(const JsonValue& parent, const char* key, const char* whole);

/// Checks a list of the tensions of all edges, of which only struts may have negative ones.
void require_tension_list(const JsonValue& parent, const char* key, const CableNet& net);

/// Refuses a negative number or null under any of these keys, which may be missing: the tension of
/// a cable. Negative are those of struts.
/// @param edge of the tensions; -1: of all edges together
void require_tensions(const JsonValue& parent, std::initializer_list<const char*> keys,
                      const CableNet& net, int edge = -1);

}  // namespace taut
