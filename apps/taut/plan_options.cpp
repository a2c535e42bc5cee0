// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "plan_options.hpp"

#include <fast_float/fast_float.h>
#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "taut/net/units.hpp"

namespace taut::app {
namespace {

/// "1/4" or "0.25": a part of a turn.
double parse_part_of_turn(const std::string& text) {
    const auto number = [&](std::string_view part) {
        double value = 0.0;
        const auto [end, error] =
            fast_float::from_chars(part.data(), part.data() + part.size(), value);
        if (error != std::errc() || end != part.data() + part.size() || !(value > 0.0)) {
            throw std::invalid_argument(
                fmt::format("--step is '{}', expected a part of a turn, such as 1/4", text));
        }
        return value;
    };
    const size_t bar = text.find('/');
    const double part = bar == std::string::npos
                            ? number(text)
                            : number(std::string_view(text).substr(0, bar)) /
                                  number(std::string_view(text).substr(bar + 1));
    if (!(part > 0.0 && part <= 1.0)) {
        throw std::invalid_argument(
            fmt::format("--step is '{}', expected no more than a whole turn", text));
    }
    return part;
}

}  // namespace

std::optional<TurnSize> parse_turn(const std::string& turn, const std::string& step) {
    if (turn.empty()) {
        return std::nullopt;
    }
    return TurnSize{.pitch = parse_length(turn),
                    .smallest = step.empty() ? 0.0 : parse_part_of_turn(step)};
}

TensionRange parse_tension_range(const std::string& text) {
    const size_t dots = text.find("..");
    if (dots == std::string::npos) {
        throw std::invalid_argument(fmt::format(
            "--tension is '{}', expected a range such as 1.5kN..10kN, 1kN.. or ..60%", text));
    }
    const auto end_of = [](const std::string& end, double none) -> TensionRange::End {
        if (end.empty()) {
            return {.value = none, .is_part = false, .is_given = false};
        }
        const bool is_part = end.find('%') != std::string::npos;
        return {.value = is_part ? parse_part(end) : parse_force(end),
                .is_part = is_part,
                .is_given = true};
    };
    const TensionRange range{
        .least = end_of(text.substr(0, dots), 0.0),
        .most = end_of(text.substr(dots + 2), std::numeric_limits<double>::infinity())};
    const bool is_comparable =
        range.least.is_part == range.most.is_part || std::isinf(range.most.value);
    if (!(range.least.value >= 0.0) || !(range.most.value > 0.0) ||
        (is_comparable && !(range.most.value > range.least.value))) {
        throw std::invalid_argument(fmt::format(
            "--tension is '{}', expected a lower limit of 0 or more and an upper one above it",
            text));
    }
    for (const TensionRange::End& end : {range.least, range.most}) {
        if (end.is_part && end.value > 1.0) {
            throw std::invalid_argument(fmt::format(
                "--tension is '{}', expected no more than 100 % of the breaking load", text));
        }
    }
    return range;
}

}  // namespace taut::app
