// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Arguments that are given as text, as on the command line: 'uniform:5mm', 'stiffness:5%'.
#pragma once

#include <fmt/core.h>
#include <nanobind/nanobind.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut::python {

namespace nb = nanobind;

/// All but "none".
/// @throws std::invalid_argument as parse_uncertain_parameter() and check_uncertain_parameters()
[[nodiscard]] inline std::vector<UncertainParameter> uncertain_given(
    const CableNet& net, const std::vector<std::string>& texts) {
    std::vector<UncertainParameter> uncertain;
    for (const std::string& text : texts) {
        if (text != "none") {
            uncertain.push_back(parse_uncertain_parameter(text));
        }
    }
    check_uncertain_parameters(net, uncertain);
    return uncertain;
}

/// Whether taut assumes what is not given: with_site_assumptions().
[[nodiscard]] inline bool assumes_site(const std::vector<std::string>& texts) {
    return std::ranges::find(texts, "none") == texts.end();
}

/// @throws std::invalid_argument as parse_length_prior()
[[nodiscard]] inline std::optional<LengthPrior> prior_given(
    const std::optional<std::string>& text) {
    return text ? std::optional(parse_length_prior(*text)) : std::nullopt;
}

/// @throws nb::value_error for other than 'right' and 'left'
[[nodiscard]] inline Thread thread_named(const std::string& name) {
    if (name != "right" && name != "left") {
        throw nb::value_error(
            fmt::format("thread: got '{}', expected 'right' or 'left'", name).c_str());
    }
    return name == "right" ? Thread::right : Thread::left;
}

}  // namespace taut::python
