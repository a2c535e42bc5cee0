// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against suggested edges that help less than others.
#include "taut/adjustment/suggested_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "adjustment/built_nets.hpp"
#include "support/refusals.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {
namespace {

BuiltNet built_of(const CableNet& net, const Eigen::VectorXd& deviations) {
    return test::without_draws(test::with_lengths(net, with_length_deviations(net, deviations)));
}

TEST(SuggestedEdges, BeginWithTheOneEdgeThatIsWrong) {
    const CableNet net = hypar(6, 6);
    Eigen::VectorXd deviations = Eigen::VectorXd::Zero(net.interior_edge_count());
    const int at = net.interior_edge_count() / 2;
    deviations(at) = 4e-3;
    const BuiltNet built = built_of(net, deviations);
    const FormTarget target(net, net.nodes(), {.normal = 1.0, .tangential = 1.0});
    const Limits limits = test::strokes_up_to(built.net, 10e-3);
    const Plan plan = plan_strokes(built, target, limits);
    const std::vector<SuggestedEdge> suggested =
        suggested_edges(built, target, limits, {}, plan, 1);
    ASSERT_EQ(suggested.size(), 1U);
    EXPECT_EQ(suggested[0].edge, net.interior_edges()[at]);
    EXPECT_NEAR(suggested[0].stroke, -4e-3, 0.2e-3);
    EXPECT_LT(suggested[0].normal_rmse_after, 0.05 * plan.planned.normal_rmse);
}

TEST(SuggestedEdges, AreTheBestOfAllTriedOneByOne) {
    const CableNet net = hypar(4, 4);
    const BuiltNet built = test::random_built(net, 12, 4e-3);
    const FormTarget target(net, net.nodes(), {.normal = 1.0, .tangential = 1.0});
    constexpr double stroke = 6e-3;
    const Limits limits = test::strokes_up_to(built.net, stroke);
    const Plan plan = plan_strokes(built, target, limits);
    const std::vector<SuggestedEdge> suggested =
        suggested_edges(built, target, limits, {}, plan, 2);
    ASSERT_EQ(suggested.size(), 2U);
    PlanOptions options{.edges = net.adjustable_edges()};
    for (const SuggestedEdge& one : suggested) {
        EXPECT_LE(std::abs(one.stroke), stroke + 1e-9);
        double least = std::numeric_limits<double>::infinity();
        double with_it = 0.0;
        double normal_with_it = 0.0;
        const std::vector<int> before = options.edges;
        for (const int edge : net.interior_edges()) {
            if (std::ranges::find(before, edge) != before.end()) {
                continue;
            }
            options.edges = before;
            options.edges.push_back(edge);
            std::ranges::sort(options.edges);
            const Plan tried = plan_strokes(
                built, target, stroke_limits(built.net, options.edges, stroke), options);
            least = std::min(least, tried.planned.rmse);
            if (edge == one.edge) {
                with_it = tried.planned.rmse;
                normal_with_it = tried.planned.normal_rmse;
            }
        }
        EXPECT_LT(with_it, 1.001 * least);
        EXPECT_NEAR(one.normal_rmse_after, normal_with_it, 0.01 * normal_with_it);
        options.edges = before;
        options.edges.push_back(one.edge);
        std::ranges::sort(options.edges);
    }
}

TEST(SuggestedEdges, AreNoneWhereNothingIsWrongAndRefuseOtherPlans) {
    const CableNet net = hypar(4, 4);
    const BuiltNet built = built_of(net, Eigen::VectorXd::Zero(net.interior_edge_count()));
    const FormTarget target(net, built.net.nodes());
    const Limits limits = test::strokes_up_to(built.net, 5e-3);
    Plan plan = plan_strokes(built, target, limits);
    test::expect_refused([&] { return suggested_edges(built, target, limits, {}, plan, 0); },
                         "0 suggested edges");
    for (const SuggestedEdge& one : suggested_edges(built, target, limits, {}, plan, 1)) {
        EXPECT_LT(std::abs(one.stroke), 1e-6);
    }
    plan.strokes = {{.edge = net.interior_edges().front(), .stroke = 1e-3}};
    test::expect_refused([&] { return suggested_edges(built, target, limits, {}, plan, 1); },
                         "not one of its adjustable");
}

}  // namespace
}  // namespace taut
