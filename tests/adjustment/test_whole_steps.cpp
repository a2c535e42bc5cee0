// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against whole steps that lose what the free strokes have: the form, or the confidence
// with which limits hold.
#include "adjustment/whole_steps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "adjustment/force_ranges.hpp"
#include "support/random_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {
namespace {

TEST(WholeSteps, Explore) {
    for (const auto& net : {hypar(4, 4), hypar(6, 6), hypar(8, 8)}) {
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            test::Random random(seed);
            CableNetData data = net.data();
            data.unstressed_lengths = with_length_deviations(
                net, test::uniform_vector(random, net.interior_edge_count(), 3e-3));
            data.nodes = EquilibriumSolver(net).solve(data.unstressed_lengths, net.nodes()).form;
            const CableNet built(data);
            const auto count = static_cast<Eigen::Index>(net.adjustable_edges().size());
            const FormTarget target(net, net.nodes());
            const StrokeTask task{.target = &target,
                                  .shortest = Eigen::VectorXd::Constant(count, -15e-3),
                                  .longest = Eigen::VectorXd::Constant(count, 15e-3),
                                  .violation_weight = 1.0};
            std::vector<LimitedResponse> responses;
            responses.push_back({.response = StrokeResponse(built, net.adjustable_edges(), {}),
                                 .range = range_of(built, TensionLimits::no_slack(built), {}),
                                 .start = built.nodes()});
            const StrokedState start =
                state_at(responses, task, Eigen::VectorXd::Zero(count), nullptr);
            const StrokedState free = search_strokes(responses, task, start).found;
            const double step = 1.25e-3;
            const StrokedState whole = in_whole_steps(responses, task, free, step);
            Eigen::VectorXd rounded = free.strokes;
            for (double& s : rounded) {
                s = step * std::round(s / step);
            }
            const StrokedState plain = state_at(responses, task, rounded, &free);
            std::cout << count << " " << seed << " free " << merit_of(task, free) << " whole "
                      << merit_of(task, whole) / merit_of(task, free) << " rounded "
                      << merit_of(task, plain) / merit_of(task, free) << "\n";
        }
    }
}

}  // namespace
}  // namespace taut
