// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "parameter_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>

#include "terminal.hpp"

namespace taut::app {
namespace {

/// A value of an uncertain parameter, in the unit that people use.
std::string in_unit(const UncertainParameter& parameter, double value) {
    const auto scaled = [value](double scale, int digits) {
        const double unit = std::pow(10.0, digits);
        const double rounded = std::round(scale * value * unit) / unit + 0.0;  // no -0
        return fmt::format("{:+.{}f}", rounded, digits);
    };
    const std::string_view unit = parameter.unit();
    return unit == "K"   ? scaled(1.0, 1) + " K"
           : unit == "m" ? scaled(1e3, 2) + " mm"
           : unit == "N"
               ? scaled(1.0, 2) + " N"
               : scaled(100.0, parameter.kind == UncertainParameter::Kind::creep ? 4 : 2) + " %";
}

}  // namespace

void print_uncertain(const CableNet& net, const Identification& result) {
    for (auto first = result.uncertain.begin(); first != result.uncertain.end();) {
        const auto last = std::find_if(first, result.uncertain.end(), [&](const auto& other) {
            return other.parameter != first->parameter;
        });
        const UncertainParameter& parameter = first->parameter;
        const auto text = [&](double value) { return in_unit(parameter, value); };
        const auto count = std::distance(first, last);
        if (count == 1 && first->edge < 0 && first->node < 0) {
            say("{}: {} from the {}, std {}{}\n", to_string(parameter), text(first->mean),
                parameter.kind == UncertainParameter::Kind::creep ? "first survey" : "design",
                text(first->std_dev).substr(1),
                first->is_observed() ? "" : " (not shown by the survey)");
        } else {
            const auto shown = std::count_if(
                first, last, [](const ParameterEstimate& one) { return one.is_observed(); });
            const auto farthest = std::max_element(first, last, [](const auto& a, const auto& b) {
                return std::abs(a.mean) < std::abs(b.mean);
            });
            say("{}: the survey determines {} of {}; the farthest from the design is {}{} by {}, "
                "std {}\n",
                to_string(parameter), shown, count,
                farthest->edge >= 0 ? net.edge_id(farthest->edge) : net.node_id(farthest->node),
                farthest->axis >= 0 ? fmt::format(" ({})", "xyz"[farthest->axis]) : "",
                text(farthest->mean), text(farthest->std_dev).substr(1));
        }
        first = last;
    }
}

}  // namespace taut::app
