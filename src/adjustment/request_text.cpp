// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/adjustment/request_text.hpp"

#include <fast_float/fast_float.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "taut/adjustment/request_error.hpp"
#include "taut/net/units.hpp"

namespace taut {
namespace {

std::optional<double> number_in(std::string_view text) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = fast_float::from_chars(text.data(), end, value);
    return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

/// Cuts "@GROUP" off.
std::optional<std::string> take_group(std::string& text) {
    const size_t at = text.find('@');
    if (at == std::string::npos) {
        return std::nullopt;
    }
    std::string group = text.substr(at + 1);
    text.resize(at);
    return group;
}

std::optional<TensionBound> parse_tension_bound(const std::string& text) {
    if (text.empty()) {
        return std::nullopt;
    }
    const bool is_part = text.find('%') != std::string::npos;
    return TensionBound{.value = is_part ? parse_part(text) : parse_force(text),
                        .is_part = is_part};
}

}  // namespace

double parse_part_of_turn(const std::string& text) {
    const size_t bar = text.find('/');
    const std::optional<double> above = number_in(std::string_view(text).substr(0, bar));
    const std::optional<double> below =
        bar == std::string::npos ? 1.0 : number_in(std::string_view(text).substr(bar + 1));
    if (!above || !below || !(*above > 0.0) || !(*below > 0.0)) {
        throw RequestError("step",
                           fmt::format("is '{}', expected a part of a turn, such as 1/4", text));
    }
    return *above / *below;
}

TensionRange parse_tension_range(const std::string& text) {
    std::string range = text;
    std::optional<std::string> group = take_group(range);
    const size_t dots = range.find("..");
    if (dots == std::string::npos || range.find("...") != std::string::npos) {
        throw RequestError(
            "tension",
            fmt::format("is '{}', expected a range such as 1.5kN..10kN, 1kN.. or ..60%", text));
    }
    return {.least = parse_tension_bound(range.substr(0, dots)),
            .most = parse_tension_bound(range.substr(dots + 2)),
            .group = std::move(group)};
}

ReactionBound parse_reaction_bound(const std::string& text) {
    std::string force = text;
    std::optional<std::string> group = take_group(force);
    return {.upper = parse_force(force), .group = std::move(group)};
}

GivenTension parse_target_tension(const std::string& text) {
    std::string forces = text;
    GivenTension given{.group = take_group(forces)};
    const size_t colon = std::min(forces.find(':'), forces.size());
    given.tension = parse_force(forces.substr(0, colon));
    if (colon < forces.size()) {
        given.tolerance = parse_tension_bound(forces.substr(colon + 1)).value_or(given.tolerance);
    }
    return given;
}

std::vector<GivenStage> parse_stages(const std::string& text) {
    std::vector<GivenStage> stages;
    for (size_t begin = 0; begin <= text.size();) {
        const size_t end = std::min(text.find(',', begin), text.size());
        const std::string one = text.substr(begin, end - begin);
        const size_t colon = std::min(one.find(':'), one.size());
        const double part = colon < one.size() ? parse_part(one.substr(colon + 1)) : 1.0;
        if (colon == 0) {
            throw RequestError(
                "stages",
                fmt::format("is '{}', expected groups and parts such as ridge:50%,valley,ridge",
                            text));
        }
        stages.push_back({.group = one.substr(0, colon), .part = part});
        begin = end + 1;
    }
    return stages;
}

DeviationWeights parse_weights(const std::string& text) {
    DeviationWeights weights;
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::string_view one = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(rest.size(), one.size() + 1));
        const size_t colon = std::min(one.find(':'), one.size());
        const std::string_view name = one.substr(0, colon);
        const std::optional<double> value = number_in(one.substr(std::min(colon + 1, one.size())));
        if ((name != "normal" && name != "tangential") || !value ||
            !(*value >= 0.0 && std::isfinite(*value))) {
            throw RequestError(
                "weights",
                fmt::format(
                    "is '{}', expected weights of 0 or more such as normal:1,tangential:0.1",
                    text));
        }
        (name == "normal" ? weights.normal : weights.tangential) = *value;
    }
    return weights;
}

}  // namespace taut
