// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Arguments that are given as text, as on the command line: 'uniform:5mm', 'stiffness:5%', '0.5mm'.
#pragma once

#include <fmt/core.h>
#include <nanobind/nanobind.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "taut/net/cable_net.hpp"
#include "taut/net/units.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut::python {

namespace nb = nanobind;

/// A number in SI units, or text with its unit: 0.0005, '0.5mm'.
class QuantityLike : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(QuantityLike, nb::object, "float | str", is_any)
};

/// @throws nb::type_error for a value of another type
template <class T>
T of_type(nb::handle value, const char* name, const char* expected) {
    try {
        return nb::cast<T>(value);
    } catch (const nb::cast_error&) {
        const auto type = nb::cast<std::string>(nb::str(value.type().attr("__name__")));
        throw nb::type_error(fmt::format("{}: got {}, expected {}", name, type, expected).c_str());
    }
}

/// @param parse of its text, as of taut/net/units.hpp
/// @throws nb::type_error, nb::value_error
inline double quantity_given(nb::handle given, const char* name, double (*parse)(std::string_view),
                             const char* expected) {
    if (!nb::isinstance<nb::str>(given)) {
        return of_type<double>(given, name, expected);
    }
    try {
        return parse(nb::cast<std::string>(given));
    } catch (const std::invalid_argument& error) {
        throw nb::value_error(fmt::format("{}: {}", name, error.what()).c_str());
    }
}

/// [m]
inline double length_given(nb::handle given, const char* name) {
    return quantity_given(given, name, parse_length, "a length in m, or '5mm'");
}
inline std::optional<double> length_given(const std::optional<QuantityLike>& given,
                                          const char* name) {
    return given ? std::optional(length_given(*given, name)) : std::nullopt;
}
/// [N]
inline double force_given(nb::handle given, const char* name) {
    return quantity_given(given, name, parse_force, "a force in N, or '5kN'");
}

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
