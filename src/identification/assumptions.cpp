// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/assumptions.hpp"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

constexpr double wider = 1.2;

bool is_given(const UncertainParameter& parameter, const std::vector<UncertainParameter>& given) {
    return std::ranges::any_of(given, [&](const UncertainParameter& one) {
        return one.kind == parameter.kind && one.group == parameter.group;
    });
}

}  // namespace

std::vector<Assumption> assumptions_of(const std::vector<UncertainParameter>& uncertain,
                                       const std::vector<UncertainParameter>& given,
                                       const Identification& result) {
    std::vector<Assumption> assumptions;
    for (const UncertainParameter& one : uncertain) {
        const auto is_shown = [&](const ParameterEstimate& estimate) {
            return estimate.parameter.kind == one.kind && estimate.parameter.group == one.group &&
                   estimate.is_observed();
        };
        assumptions.push_back({.parameter = one,
                               .is_default = std::ranges::find(given, one) == given.end(),
                               .is_testable = std::ranges::any_of(result.uncertain, is_shown)});
    }
    return assumptions;
}

std::vector<UncertainParameter> with_uncertain_widths(
    std::vector<UncertainParameter> uncertain, const std::vector<UncertainParameter>& given) {
    for (UncertainParameter& one : uncertain) {
        one.std_dev *= is_given(one, given) ? 1.0 : wider;
    }
    return uncertain;
}

void name_assumed_widths(Identification& result, const std::vector<UncertainParameter>& uncertain,
                         const std::vector<UncertainParameter>& given) {
    constexpr double alike = 1e-2;
    for (ParameterEstimate& estimate : result.uncertain) {
        UncertainParameter& parameter = estimate.parameter;
        const auto assumed = std::ranges::find_if(uncertain, [&](const UncertainParameter& one) {
            return one.kind == parameter.kind && one.group == parameter.group &&
                   std::abs(parameter.std_dev - wider * one.std_dev) < alike * parameter.std_dev;
        });
        if (assumed != uncertain.end() && !is_given(parameter, given)) {
            parameter.std_dev = assumed->std_dev;
        }
    }
}

}  // namespace taut
