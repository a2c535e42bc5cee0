// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/assumptions.hpp"

#include <algorithm>

namespace taut {

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

}  // namespace taut
