// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "results/description.hpp"
#include "taut/version.hpp"

namespace taut {

/// The net's counts.
[[nodiscard]] Description<CableNet> describe(const CableNet* type);

/// The net in taut's own format, whole.
[[nodiscard]] ResultJson net_json(const CableNet& net);

/// A net in taut's own format, whose reader checks it further.
[[nodiscard]] Rule net_rule();

/// Reasons of all findings.
[[nodiscard]] std::vector<std::string> reasons_of(const Trust& trust);

/// Numbers rounded to so many significant digits, to keep a result small.
[[nodiscard]] ResultJson numbers_json(const Eigen::Ref<const Eigen::VectorXd>& numbers, int digits);

/// [[x, y, z]...], to 10 nm for a net of some 10 m.
[[nodiscard]] ResultJson points_json(const Points& points);

/// Of each matrix xx, xy, xz, yy, yz, zz; null where there are none.
[[nodiscard]] ResultJson covariances_json(const std::vector<Eigen::Matrix3d>& covariances);
[[nodiscard]] Rule covariances_rule();

/// The text, where it is not empty.
[[nodiscard]] std::optional<std::string> unless_empty(const std::string& text);

/// The description of a document, as it begins: "taut-NAME", version 2.
template <class T>
Description<T> document(const std::string& name, const std::string& text) {
    Description<T> result(name, text);
    result.key(
              "format", [name](const T&) { return "taut-" + name; }, Rule::only("taut-" + name))
        .key("version", TAUT_VALUE(2), Rule::only(2))
        .newer("program", TAUT_VALUE("taut " + std::string(version())));
    return result;
}

/// Adds date and command.
template <class T>
Description<T>& add_run(Description<T>& document) {
    return document.optional("date", TAUT_VALUE(unless_empty(c.run->date)))
        .optional("command", TAUT_VALUE(unless_empty(c.run->command)));
}

/// The document as readable text: one line per key, lists of numbers on one line, other lists with
/// one line per entry.
[[nodiscard]] std::string to_text(const ResultJson& document);

}  // namespace taut
