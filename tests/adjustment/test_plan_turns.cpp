// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against limits of other edges and supports than those that were asked for, and against
// requests that no net can meet.
#include "taut/adjustment/plan_turns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "adjustment/built_nets.hpp"
#include "adjustment/resolved_request.hpp"
#include "support/not_finite.hpp"
#include "support/refusals.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/survey/cable_vibration.hpp"

namespace taut {
namespace {

using test::expect_refused;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using test::infinity;

TensionBound newtons(double value) {
    return {.value = value};
}

TensionBound part(double value) {
    return {.value = value, .is_part = true};
}

/// A net with the groups "first", of an adjustable edge, and "inner", of one without support.
CableNet grouped(bool has_breaking_load = true) {
    CableNetData data = hypar(3, 3).data();
    const CableNet net(data);
    int inner = 0;
    while (net.free_index(net.edges()[inner][0]) < 0 || net.free_index(net.edges()[inner][1]) < 0) {
        ++inner;
    }
    data.groups = {{"first", {net.adjustable_edges()[0]}}, {"inner", {inner}}};
    if (has_breaking_load) {
        data.breaking_load = Eigen::VectorXd::LinSpaced(net.edge_count(), 1e4, 2e4);
    }
    return CableNet(data);
}

TEST(LimitsOfStruts, AreTheirBucklingLoadsAndWhatIsAskedOfTheirGroup) {
    CableNetData data = cable_dome().data();
    const int strut = data.groups.at("strut")[3];
    data.buckling_load = Eigen::VectorXd::Constant(std::ssize(data.edges), infinity);
    data.buckling_load(strut) = 4e4;
    const CableNet net(std::move(data));
    PlanRequest request;
    request.tension = {{.least = newtons(1e3), .most = newtons(9e4)}};
    const TensionLimits by_default = resolve(net, {.net = net}, request).limits.tension;
    for (int e = 0; e < net.edge_count(); ++e) {
        EXPECT_EQ(by_default.lower(e), e == strut ? -4e4 : net.is_strut(e) ? -infinity : 1e3);
        EXPECT_EQ(by_default.upper(e), net.is_strut(e) ? infinity : 9e4);
    }
    request.tension = {{.least = newtons(-2e4), .most = newtons(-1e3), .group = "strut"}};
    const TensionLimits of_group = resolve(net, {.net = net}, request).limits.tension;
    EXPECT_EQ(of_group.lower(strut), -2e4);
    EXPECT_EQ(of_group.upper(strut), -1e3);
    EXPECT_EQ(of_group.lower(net.data().groups.at("ridge")[0]), 0.0);
    // Looser than the buckling load.
    request.tension = {{.least = newtons(-2e5), .group = "strut"}};
    EXPECT_EQ(resolve(net, {.net = net}, request).limits.tension.lower(strut), -4e4);
    request.tension = {{.least = newtons(-2e4), .group = "ridge"}};
    const auto resolved = [&] { return resolve(net, {.net = net}, request); };
    expect_refused<RequestError>(resolved, "only struts carry compression");
    request.tension = {{.least = newtons(-2e4)}};
    expect_refused<RequestError>(resolved, "0 or more");
}

class PlanRequestOfAHypar : public ::testing::Test {
protected:
    [[nodiscard]] Limits limits_of(const PlanRequest& request) const {
        return resolve(net, {.net = net}, request).limits;
    }

    static void expect_field(const CableNet& net, const CableNet& built, const PlanRequest& request,
                             const char* field, const char* text) {
        try {
            static_cast<void>(resolve(net, {.net = built}, request));
            ADD_FAILURE() << "took " << field << ", expected: " << text;
        } catch (const RequestError& error) {
            EXPECT_EQ(error.field(), field);
            EXPECT_THAT(error.problem(), HasSubstr(text));
        }
    }

    void expect_field(const PlanRequest& request, const char* field, const char* text) const {
        expect_field(net, net, request, field, text);
    }

    CableNet net = grouped();
    int first = net.data().groups.at("first")[0];
    int inner = net.data().groups.at("inner")[0];
};

TEST_F(PlanRequestOfAHypar, LimitsTensionsOfGroupsOverThoseOfAllOnlyWhereTheyAreGiven) {
    const TensionRange all{.least = newtons(1e3), .most = newtons(9e3)};
    const TensionRange group{.most = newtons(5e3), .group = "first"};
    for (const PlanRequest& request :
         {PlanRequest{.tension = {all, group}}, PlanRequest{.tension = {group, all}}}) {
        const TensionLimits limits = limits_of(request).tension;
        EXPECT_EQ(limits.upper(first), 5e3);
        EXPECT_EQ(limits.lower(first), 1e3);
        EXPECT_EQ(limits.upper(inner), 9e3);
    }
    EXPECT_EQ(limits_of({}).tension.upper(first), infinity);
}

TEST_F(PlanRequestOfAHypar, LimitsTensionsByPartsOfTheBreakingLoadOfEachEdge) {
    const TensionLimits limits =
        limits_of({.tension = {{.least = part(0.2), .most = part(0.6)}}}).tension;
    for (int edge = 0; edge < net.edge_count(); ++edge) {
        EXPECT_DOUBLE_EQ(limits.lower(edge), 0.2 * net.data().breaking_load(edge));
        EXPECT_DOUBLE_EQ(limits.upper(edge), 0.6 * net.data().breaking_load(edge));
    }
    const CableNet without = grouped(false);
    expect_field(without, without, {.tension = {{.most = part(0.6)}}}, "tension",
                 "has no breaking_load");
}

TEST_F(PlanRequestOfAHypar, LimitsReactionsAtAllSupportsOrThoseOfAGroup) {
    const Limits limits =
        limits_of({.reaction = {{.upper = 2e4}, {.upper = 1e4, .group = "first"}}});
    ASSERT_EQ(limits.reactions.size(), 2U);
    EXPECT_EQ(limits.reactions[0].supports, net.supports());
    const auto [s, t] = net.edges()[first];
    EXPECT_THAT(limits.reactions[1].supports, ElementsAre(net.free_index(s) < 0 ? s : t));
    EXPECT_EQ(limits.reactions[1].upper, 1e4);
    expect_field({.reaction = {{.upper = 1e4, .group = "inner"}}}, "reaction",
                 "is at the group 'inner', but no edge of that is at a support");
}

TEST_F(PlanRequestOfAHypar, NarrowsStrokesToTheTotalSinceTheDesign) {
    CableNetData data = net.data();
    data.unstressed_lengths(first) += 3e-3;
    const CableNet built(data);
    const auto [options, limits] =
        resolve(net, {.net = built}, {.stroke = 10e-3, .total_stroke = 4e-3});
    ASSERT_EQ(options.edges, net.adjustable_edges());
    for (size_t k = 0; k < options.edges.size(); ++k) {
        const double offset = options.edges[k] == first ? 3e-3 : 0.0;
        const auto at = static_cast<Eigen::Index>(k);
        EXPECT_NEAR(limits.shortest_stroke(at), -4e-3 - offset, 1e-12);
        EXPECT_NEAR(limits.longest_stroke(at), 4e-3 - offset, 1e-12);
    }
    expect_field(net, built, {.total_stroke = 2e-3}, "total_stroke",
                 "is 2mm, but the turnbuckle of edge '");
    expect_field({.total_stroke = 0.0}, "total_stroke", "is 0mm, expected more than 0");
    expect_refused<RequestError>(
        [&] { return resolve(net, {.net = built}, {.total_stroke = -1.0}); },
        "the total stroke is -1000mm");
}

TEST_F(PlanRequestOfAHypar, TurnsOnlyTheEdgesThatRangesOfStrokesName) {
    const int second = net.adjustable_edges()[1];
    const StrokeRange range{.edge = second, .shortest = -1e-3, .longest = 2e-3};
    const auto [options, limits] = resolve(net, {.net = net}, {.stroke_ranges = {range}});
    EXPECT_THAT(options.edges, ElementsAre(second));
    EXPECT_EQ(limits.shortest_stroke(0), -1e-3);
    EXPECT_EQ(limits.longest_stroke(0), 2e-3);
    expect_field({.stroke_ranges = {{.edge = inner}}}, "stroke", "which is not adjustable");
    expect_field({.stroke_ranges = {{.edge = second, .shortest = 1e-3, .longest = 2e-3}}}, "stroke",
                 "goes from 0.001 to 0.002 m, expected a range that holds 0");
    expect_field({.options = {.edges = {first}}, .stroke_ranges = {range}}, "stroke",
                 "leaves no edge that may be turned");
    // An interior edge may be turned where that is asked for, and then no other.
    EXPECT_THAT(resolve(net, {.net = net},
                        {.options = {.edges = {inner}}, .stroke_ranges = {{.edge = inner}, range}})
                    .options.edges,
                ElementsAre(inner));
}

TEST_F(PlanRequestOfAHypar, IsRefusedWhereNoNetCanMeetIt) {
    expect_field({.stroke = -5e-3}, "stroke", "is -5mm, expected more than 0");
    expect_field({.stroke = infinity}, "stroke", "expected more than 0");
    expect_field({.tension = {{.least = newtons(1e3), .group = "ridge"}}}, "tension",
                 "names the group 'ridge'");
    expect_field({.reaction = {{.upper = 1e3, .group = "ridge"}}}, "reaction",
                 "names the group 'ridge'");
    const char* const above = "an upper one above it";
    expect_field({.tension = {{.least = newtons(3e3), .most = newtons(1e3)}}}, "tension",
                 "is 3000 N..1000 N");
    expect_field({.tension = {{.least = part(0.6), .most = part(0.2)}}}, "tension", above);
    expect_field({.tension = {{.most = part(-0.05)}}}, "tension", above);
    expect_field({.tension = {{.least = newtons(std::nan(""))}}}, "tension", above);
    expect_field({.tension = {{.most = part(1.2)}}}, "tension", "no more than 100 %");
    const PlanRequest of_no_edge{.options = {.edges = {net.edge_count()}}};
    EXPECT_THROW(static_cast<void>(limits_of(of_no_edge)), std::invalid_argument);
    const PlanRequest of_few_nodes{.load_cases = {{.name = "wet", .loads = Points::Zero(3, 2)}}};
    expect_refused([&] { return limits_of(of_few_nodes); }, "wet");
}

TEST(PlanTurns, AreThoseOfTheirParts) {
    const CableNet net = grouped();
    BuiltNet built = test::random_built(net, 5, 2e-3);
    built.length_draws = built.net.unstressed_lengths().replicate(1, 40);
    const FormTarget target(net, net.nodes());
    Points wet = Points::Zero(3, net.node_count());
    wet.row(2).setConstant(-10.0);
    PlanRequest request{.options = {.turn = TurnSize{.pitch = 4e-3, .smallest = 0.25}},
                        .stroke = 10e-3,
                        .tension = {{.least = newtons(1.0)}},
                        .load_cases = {{.name = "wet", .loads = wet}},
                        .crews = 2,
                        .suggest_adjustable = 1,
                        .thread = Thread::left};
    const PlannedTurns turns = plan_turns(net, built, target, request);
    EXPECT_EQ(turns.limits.load_cases[0].loads, built.net.loads() + wet);
    EXPECT_EQ(turns.limits.load_cases[0].tension.lower, turns.limits.tension.lower);
    EXPECT_EQ(turns.thread, Thread::left);
    EXPECT_EQ(turns.plan.draws_needed, 39) << "0.95 * 41, rounded up";
    const Plan plan = plan_strokes(built, target, turns.limits, turns.options);
    ASSERT_FALSE(plan.strokes.empty());
    EXPECT_EQ(turns.plan.form, plan.form);
    EXPECT_DOUBLE_EQ(plan.gain(), plan.as_built.normal_rmse - plan.planned.normal_rmse);
    const TurnOrder order = order_turns(built, turns.limits, plan, {.crews = 2, .turn_step = 1e-3});
    ASSERT_EQ(turns.order.turnings.size(), order.turnings.size());
    EXPECT_EQ(turns.order.walk, order.walk);
    EXPECT_LE(turns.suggested_adjustable.value().size(), 1U);
    EXPECT_EQ(turns.order.turnings.front().frequency, 0.0) << "no mass is known";

    CableNetData heavy = net.data();
    heavy.mass = Eigen::VectorXd::LinSpaced(net.edge_count(), 0.01, 0.02);
    request.stages = {{.group = "first", .part = 0.5}};
    const PlannedTurns staged = plan_turns(CableNet(heavy), built, target, request);
    const Turning turning = staged.order.turnings.front();
    EXPECT_EQ(turning.edge, net.data().groups.at("first")[0]);
    EXPECT_EQ(staged.order.stages.size(), 2U);
    EXPECT_GT(turning.frequency, 0.0);
    EXPECT_EQ(turning.frequency,
              expected_frequency(CableNet(heavy), turning.edge, turning.length, turning.tension));
    request.stages = {{.group = "inner"}};
    const auto planned = [&] { return plan_turns(net, built, target, request); };
    expect_refused<RequestError>(planned, "no edge of that may be turned");
    request.stages = {};

    request.suggest_adjustable = -1;
    EXPECT_EQ(test::refusal_of<RequestError>(planned),
              "the suggest adjustable is -1, expected 0 or more");
}

}  // namespace
}  // namespace taut
