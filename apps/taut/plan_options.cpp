// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "plan_options.hpp"

#include <fmt/core.h>

#include <charconv>
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
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
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

std::pair<double, double> parse_tension_range(const std::string& text) {
    const size_t dots = text.find("..");
    if (dots == std::string::npos) {
        throw std::invalid_argument(fmt::format(
            "--tension is '{}', expected a range such as 1.5kN..10kN, 1kN.. or ..10kN", text));
    }
    const std::string lower = text.substr(0, dots);
    const std::string upper = text.substr(dots + 2);
    const double least = lower.empty() ? 0.0 : parse_force(lower);
    const double most =
        upper.empty() ? std::numeric_limits<double>::infinity() : parse_force(upper);
    if (!(least >= 0.0) || !(most > least)) {
        throw std::invalid_argument(fmt::format(
            "--tension is '{}', expected a lower limit of 0 or more and an upper one above it",
            text));
    }
    return {least, most};
}

}  // namespace taut::app
