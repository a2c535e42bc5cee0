// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/check_plan.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "adjustment/force_ranges.hpp"

namespace taut {
namespace {

void check_strokes(const CableNet& net, const std::vector<PlannedStroke>& strokes) {
    std::vector<bool> is_named(net.edge_count(), false);
    for (const PlannedStroke& stroke : strokes) {
        if (stroke.edge < 0 || stroke.edge >= net.edge_count()) {
            throw std::invalid_argument(fmt::format("the plan turns edge {}, expected 0 to {}",
                                                    stroke.edge, net.edge_count() - 1));
        }
        if (is_named[stroke.edge]) {
            throw std::invalid_argument(
                fmt::format("the plan turns edge '{}' twice", net.edge_id(stroke.edge)));
        }
        if (!std::isfinite(stroke.stroke)) {
            throw std::invalid_argument(fmt::format("the plan turns edge '{}' by {:g} m",
                                                    net.edge_id(stroke.edge), stroke.stroke));
        }
        is_named[stroke.edge] = true;
    }
}

}  // namespace

void check_plan(const CableNet& net, const Limits& limits, const Plan& plan) {
    check_strokes(net, plan.strokes);
    if (plan.effective_limits.size() != limits.load_cases.size() + 1) {
        throw std::invalid_argument(
            fmt::format("the plan has effective limits for {} sets of loads, expected {}",
                        plan.effective_limits.size(), limits.load_cases.size() + 1));
    }
    const auto reactions = static_cast<Eigen::Index>(supports_of(limits.reactions).size());
    const Eigen::Index expected = net.edge_count() + reactions;
    for (const ForceRange& range : plan.effective_limits) {
        if (range.lower.size() != expected || range.upper.size() != expected) {
            throw std::invalid_argument(
                fmt::format("the plan has effective limits of {} and {} forces, expected {}",
                            range.lower.size(), range.upper.size(), expected));
        }
    }
}

}  // namespace taut
