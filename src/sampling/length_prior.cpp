// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/sampling/length_prior.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "taut/net/units.hpp"

namespace taut {
namespace {

constexpr std::array<std::pair<std::string_view, LengthPrior::Kind>, 3> names{
    {{"uniform", LengthPrior::Kind::uniform},
     {"normal", LengthPrior::Kind::normal},
     {"bimodal", LengthPrior::Kind::bimodal}}};

/// Standard deviation of each mode of the bimodal prior, relative to its distance from zero.
constexpr double mode_spread = 0.2;

/// |normal_quantile(u)| is below this.
constexpr double normal_reach = 8.3;

/// Standard normal quantile, of u clamped to where it is finite.
double normal_quantile(double u) {
    return -std::numbers::sqrt2 *
           boost::math::erfc_inv(2.0 * std::clamp(u, 0x1p-54, 1.0 - 0x1p-53));
}

std::string_view name_of(LengthPrior::Kind kind) {
    const auto* const found =
        std::ranges::find(names, kind, [](const auto& n) { return n.second; });
    return found != names.end() ? found->first : "unknown";
}

}  // namespace

void LengthPrior::check() const {
    if (!(scale > 0.0) || !std::isfinite(scale)) {
        throw std::invalid_argument(fmt::format(
            "the scale of the {} prior of length deviations is {} m, expected a positive "
            "and finite length",
            name_of(kind), scale));
    }
}

double LengthPrior::std_dev() const {
    switch (kind) {
        case Kind::uniform:
            return scale / std::numbers::sqrt3;
        case Kind::normal:
            return scale;
        case Kind::bimodal:
            return scale * std::sqrt(1.0 + mode_spread * mode_spread);
    }
    return scale;
}

double LengthPrior::reach() const {
    switch (kind) {
        case Kind::uniform:
            return scale;
        case Kind::normal:
            return normal_reach * scale;
        case Kind::bimodal:
            return scale * (1.0 + mode_spread * normal_reach);
    }
    return scale;
}

double LengthPrior::draw(double u) const {
    switch (kind) {
        case Kind::uniform:
            return scale * (2.0 * u - 1.0);
        case Kind::normal:
            return scale * normal_quantile(u);
        case Kind::bimodal:
            // Each half of (0, 1) is one mode, stretched to (0, 1) again.
            return u < 0.5 ? scale * (-1.0 + mode_spread * normal_quantile(2.0 * u))
                           : scale * (1.0 - mode_spread * normal_quantile(2.0 * (1.0 - u)));
    }
    return 0.0;
}

std::string to_string(const LengthPrior& prior) {
    for (const auto& [name, named_kind] : names) {
        if (named_kind == prior.kind) {
            return fmt::format("{}:{}", name, format_length_exactly(prior.scale));
        }
    }
    return {};
}

LengthPrior parse_length_prior(std::string_view text) {
    const size_t colon = text.find(':');
    if (colon != std::string_view::npos) {
        for (const auto& [name, kind] : names) {
            if (text.substr(0, colon) == name) {
                const double scale = parse_length(text.substr(colon + 1));
                if (!(scale > 0.0)) {
                    throw std::invalid_argument(
                        fmt::format("the prior '{}' has the scale {} m, expected a positive length",
                                    text, scale));
                }
                return {.kind = kind, .scale = scale};
            }
        }
    }
    throw std::invalid_argument(
        fmt::format("'{}' is no prior of length deviations: expected uniform:5mm, normal:2mm or "
                    "bimodal:5mm, with any length",
                    text));
}

}  // namespace taut
