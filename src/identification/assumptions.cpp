// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/assumptions.hpp"

#include <algorithm>

namespace taut {
namespace {

constexpr double wider = 1.2;

bool is_given(const Unknown& unknown, const std::vector<Unknown>& given) {
    return std::ranges::any_of(given, [&](const Unknown& one) {
        return one.kind == unknown.kind && one.group == unknown.group;
    });
}

}  // namespace

std::vector<Assumption> assumptions_of(const std::vector<Unknown>& uncertain,
                                       const std::vector<Unknown>& given,
                                       const Identification& result) {
    std::vector<Assumption> assumptions;
    for (const Unknown& one : uncertain) {
        const auto is_shown = [&](const UnknownEstimate& estimate) {
            return estimate.unknown.kind == one.kind && estimate.unknown.group == one.group &&
                   estimate.is_observed();
        };
        assumptions.push_back({.parameter = one,
                               .is_default = std::ranges::find(given, one) == given.end(),
                               .is_testable = std::ranges::any_of(result.unknowns, is_shown)});
    }
    return assumptions;
}

std::vector<Unknown> with_uncertain_widths(std::vector<Unknown> uncertain,
                                           const std::vector<Unknown>& given) {
    for (Unknown& one : uncertain) {
        one.std *= is_given(one, given) ? 1.0 : wider;
    }
    return uncertain;
}

void name_assumed_widths(Identification& result, const std::vector<Unknown>& given) {
    for (UnknownEstimate& estimate : result.unknowns) {
        estimate.unknown.std /= is_given(estimate.unknown, given) ? 1.0 : wider;
    }
}

}  // namespace taut
