// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// What is told in words, as on the command line: 'uniform:5mm', 'stiffness:5%'.
#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_law.hpp"
#include "taut/sampling/unknown.hpp"

namespace taut::python {

/// @throws std::invalid_argument as parse_unknown() and check_unknowns()
[[nodiscard]] inline std::vector<Unknown> unknowns_told(const CableNet& net,
                                                        const std::vector<std::string>& texts) {
    std::vector<Unknown> unknowns;
    for (const std::string& text : texts) {
        unknowns.push_back(parse_unknown(text));
    }
    check_unknowns(net, unknowns);
    return unknowns;
}

/// Whether what is not given is as on a site: with_site_assumptions().
[[nodiscard]] inline bool assumes_site(const std::vector<std::string>& uncertain,
                                       const std::optional<std::vector<std::string>>& unknowns) {
    return !unknowns && std::ranges::find(uncertain, "none") == uncertain.end();
}

/// @throws std::invalid_argument for both, and as unknowns_told()
[[nodiscard]] inline std::vector<Unknown> uncertain_told(
    const CableNet& net, std::vector<std::string> uncertain,
    const std::optional<std::vector<std::string>>& unknowns) {
    if (unknowns && !uncertain.empty()) {
        throw std::invalid_argument(
            "uncertain and unknowns cannot stand together: unknowns=[...] is uncertain=['none', "
            "...]");
    }
    std::erase(uncertain, "none");
    return unknowns_told(net, unknowns.value_or(uncertain));
}

/// @throws std::invalid_argument as parse_length_law()
[[nodiscard]] inline std::optional<LengthLaw> law_told(const std::optional<std::string>& text) {
    return text ? std::optional(parse_length_law(*text)) : std::nullopt;
}

}  // namespace taut::python
