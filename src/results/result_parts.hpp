// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "taut/identification/trust.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/results/results_json.hpp"

namespace taut {

/// JSON of all results; it keeps the order of keys.
using ResultJson = nlohmann::ordered_json;

/// The value, or null.
template <typename T>
[[nodiscard]] ResultJson or_null(const std::optional<T>& value) {
    return value ? ResultJson(*value) : ResultJson();
}

/// {"name", "free_nodes", "supports", "interior_edges", "adjustable_edges", "fingerprint"}
[[nodiscard]] ResultJson counts_json(const CableNet& net);

/// The net in taut's own format, whole.
[[nodiscard]] ResultJson net_json(const CableNet& net);

/// {"verdict", "reasons"}
[[nodiscard]] ResultJson trust_json(const Trust& trust);

/// Numbers rounded to so many significant digits, to keep a result small.
[[nodiscard]] ResultJson numbers_json(const Eigen::Ref<const Eigen::VectorXd>& numbers, int digits);

/// Adds date and command.
void add_run(ResultJson& document, const RunRecord& run);

/// [[x, y, z]...], to 10 nm for a net of some 10 m.
[[nodiscard]] ResultJson points_json(const Points& points);

/// The document as readable text: one line per key, lists of numbers on one line, other lists with
/// one line per entry.
[[nodiscard]] std::string to_text(const ResultJson& document);

}  // namespace taut
