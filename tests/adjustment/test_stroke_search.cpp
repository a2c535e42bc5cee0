// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a search that reports convergence without an equilibrium to start from.
#include "adjustment/stroke_search.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "adjustment/force_ranges.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

TEST(StrokeSearch, HasNotConvergedWhereItsStartHasNoEquilibrium) {
    const CableNet net = hypar(3, 3);
    const auto edges = static_cast<Eigen::Index>(net.adjustable_edges().size());
    const FormTarget target(net, net.nodes());
    const StrokeTask task{.target = &target,
                          .shortest = Eigen::VectorXd::Constant(edges, -5e-3),
                          .longest = Eigen::VectorXd::Constant(edges, 5e-3),
                          .violation_weight = 1.0};
    std::vector<LimitedResponse> responses;
    responses.push_back({.response = StrokeResponse(net, net.adjustable_edges(), {}),
                         .range = range_of(net, TensionLimits::no_slack(net), {}),
                         .start = net.nodes()});
    StrokedState start = state_at(responses, task, Eigen::VectorXd::Zero(edges), nullptr);
    ASSERT_TRUE(search_strokes(responses, task, start).has_converged);
    start.nets.front().equilibrium.status = EquilibriumStatus::iteration_limit;
    start.cost = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(search_strokes(responses, task, start).has_converged);
}

}  // namespace
}  // namespace taut
