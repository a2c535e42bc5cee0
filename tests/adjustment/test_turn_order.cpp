// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against an order of work in which a cable leaves its limits on the way.
#include "taut/adjustment/turn_order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "adjustment/built_nets.hpp"
#include "support/refusals.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using test::expect_refused;

class TurnOrderOfHilo : public ::testing::Test {
protected:
    TurnOrderOfHilo() {
        plan = plan_strokes(built, FormTarget(net, net.nodes()), limits,
                            {.turn = TurnSize{.pitch = 5e-3, .smallest = 0.25}});
    }

    [[nodiscard]] TurnOrder order_of(const TurnOrderOptions& options) const {
        return order_turns(built, limits, plan, options);
    }

    CableNet net = hilo_quarter();
    BuiltNet built = test::random_built(net, 2, 5e-3);
    Limits limits = test::limits_between(net, 15e-3, 1e3, 11e3);
    Plan plan;
};

TEST_F(TurnOrderOfHilo, EndsAtThePlanAndKeepsLimitsAtEveryStep) {
    ASSERT_TRUE(plan.is_feasible);
    for (const int crews : {1, 3}) {
        const TurnOrder order = order_of({.crews = crews, .turn_step = 1.25e-3});
        EXPECT_TRUE(order.is_safe);
        std::map<int, double> done;
        // A limit that was broken before the work may stay broken, but by no more.
        const Eigen::VectorXd before =
            tensions_of(built.net, built.net.unstressed_lengths(), built.net.nodes());
        const Eigen::VectorXd least = before.cwiseMin(1e3);
        const Eigen::VectorXd most = before.cwiseMax(11e3);
        Eigen::VectorXd lengths = built.net.unstressed_lengths();
        Points form = built.net.nodes();
        for (size_t i = 0; i < order.turnings.size(); ++i) {
            const Turning& turning = order.turnings[i];
            EXPECT_LE(turning.crew, crews);
            done[turning.edge] += turning.stroke;
            lengths(turning.edge) += turning.stroke;
            if (i + 1 < order.turnings.size() && order.turnings[i + 1].step == turning.step) {
                continue;
            }
            form = EquilibriumSolver(built.net).solve(lengths, form).form;
            const Eigen::VectorXd now = tensions_of(built.net, lengths, form);
            EXPECT_NEAR(turning.tension, now(turning.edge), 1.0);
            EXPECT_NEAR(turning.length, edge_lengths(built.net, form)(turning.edge), 1e-6);
            EXPECT_GT((now - least).minCoeff(), -1.0);
            EXPECT_LT((now - most).maxCoeff(), 1.0);
        }
        ASSERT_EQ(done.size(), plan.strokes.size());
        for (const PlannedStroke& stroke : plan.strokes) {
            EXPECT_NEAR(done[stroke.edge], stroke.stroke, 1e-12);
        }
    }
}

TEST_F(TurnOrderOfHilo, GoesStageByStage) {
    std::vector<int> first;
    std::vector<int> second;
    for (const PlannedStroke& stroke : plan.strokes) {
        (stroke.edge % 3 == 0 ? first : second).push_back(stroke.edge);
    }
    second.resize(second.size() / 2);
    const std::vector<WorkStage> stages{{.name = "a", .edges = first, .part = 0.5},
                                        {.name = "b", .edges = second},
                                        {.name = "a", .edges = first}};
    const TurnOrder order = order_of({.stages = stages, .turn_step = 1.25e-3});
    ASSERT_EQ(order.stages.size(), 4u);
    EXPECT_EQ(order.stages[3].name, "rest");
    EXPECT_EQ(order.passes % 4, 0);
    std::map<int, double> done;
    size_t stage = 0;
    for (const Turning& turning : order.turnings) {
        while (turning.step > order.stages[stage].step) {
            ++stage;
        }
        const auto is_in = [&](const std::vector<int>& edges) {
            return std::ranges::find(edges, turning.edge) != edges.end();
        };
        EXPECT_EQ(is_in(first), stage == 0 || stage == 2);
        EXPECT_EQ(is_in(second), stage == 1);
        done[turning.edge] += turning.stroke;
        if (stage == 0) {
            EXPECT_NEAR(std::remainder(done[turning.edge], 1.25e-3), 0.0, 1e-9);
        }
    }
    Eigen::VectorXd lengths = built.net.unstressed_lengths();
    for (const PlannedStroke& stroke : plan.strokes) {
        EXPECT_NEAR(done[stroke.edge], stroke.stroke, 1e-12);
        lengths(stroke.edge) += stroke.stroke;
    }
    const Eigen::VectorXd at_end = test::solved_tensions(built.net, lengths, net.nodes());
    EXPECT_NEAR(order.stages[3].least_tension, std::max(0.0, at_end.minCoeff()), 1.0);
    EXPECT_NEAR(order.stages[3].most_tension, at_end.maxCoeff(), 1.0);
    EXPECT_EQ(order.stages[3].safe_probability, order.is_safe ? 1.0 : 0.0);
}

TEST_F(TurnOrderOfHilo, RefusesStagesThatGoBack) {
    const std::vector<int> edges{plan.strokes[0].edge};
    const auto with = [&](std::vector<WorkStage> stages) {
        return [this, stages = std::move(stages)] { return order_of({.stages = stages}); };
    };
    expect_refused(
        with({{.name = "a", .edges = edges}, {.name = "b", .edges = edges, .part = 0.5}}),
        "a stage before has done 1 of");
    expect_refused(with({{.name = "a", .edges = edges, .part = 0.0}}), "expected above 0");
    EXPECT_THROW(with({{.name = "a", .edges = {net.edge_count()}}})(), std::out_of_range);
}

TEST_F(TurnOrderOfHilo, WalksFromNeighbourToNeighbour) {
    const TurnOrder order = order_turns(built, limits, plan);
    // The outline of the net, with its five touch-downs, is some 17 m long.
    EXPECT_LT(order.walk, 30.0 * order.passes);
}

TEST_F(TurnOrderOfHilo, SaysWhereNoOrderIsSafe) {
    // The net keeps these limits before and after the work, but on no way.
    const Eigen::VectorXd before =
        tensions_of(built.net, built.net.unstressed_lengths(), built.net.nodes());
    plan.strokes.resize(20);  // each is tried at most steps, which takes long
    limits.tension.lower = 0.999 * before.cwiseMin(plan.tensions);
    limits.tension.upper = 1.001 * before.cwiseMax(plan.tensions);
    plan.effective_limits = {{.lower = limits.tension.lower, .upper = limits.tension.upper}};
    const TurnOrder order = order_turns(built, limits, plan);
    EXPECT_FALSE(order.is_safe);
    EXPECT_GE(order.worst.step, 0);
    // It names the limit that is broken.
    const LimitBreach& worst = order.worst.breach;
    ASSERT_EQ(worst.kind, LimitBreach::Kind::tension);
    const double lower = limits.tension.lower(worst.index);
    const double upper = limits.tension.upper(worst.index);
    EXPECT_TRUE(worst.value < lower || worst.value > upper);
    EXPECT_EQ(worst.limit, worst.value < lower ? lower : upper);
    EXPECT_EQ(order.safe_probability, 0.0);
}

/// A net whose lengths are known to 0.5 mm, and a plan that keeps its limits in the samples.
class TurnOrderOfDraws : public ::testing::Test {
protected:
    TurnOrderOfDraws() {
        built.length_draws = lengths_drawn(200, 11);
        limits.tension.lower.setConstant(least);
        plan = plan_strokes(built, FormTarget(net, net.nodes()), limits);
    }

    /// Samples of the lengths, one per column.
    [[nodiscard]] Eigen::MatrixXd lengths_drawn(int count, std::uint64_t seed) const {
        test::Random random(seed);
        std::normal_distribution<double> error(0.0, 0.5e-3);
        Eigen::MatrixXd lengths = built.net.unstressed_lengths().replicate(1, count);
        for (auto column : lengths.colwise()) {
            for (const int edge : net.interior_edges()) {
                column(edge) += error(random);
            }
        }
        return lengths;
    }

    /// The part of some nets in which no step takes a tension below the limit that was above it.
    [[nodiscard]] double part_kept(const TurnOrder& order, const Eigen::MatrixXd& nets) const {
        int kept = 0;
        for (Eigen::VectorXd lengths : nets.colwise()) {
            Points form = EquilibriumSolver(built.net).solve(lengths, built.net.nodes()).form;
            const Eigen::VectorXd allowed =
                tensions_of(built.net, lengths, form).cwiseMin(least).array() - 0.1;
            bool is_kept = true;
            for (size_t i = 0; i < order.turnings.size() && is_kept; ++i) {
                lengths(order.turnings[i].edge) += order.turnings[i].stroke;
                if (i + 1 < order.turnings.size() &&
                    order.turnings[i + 1].step == order.turnings[i].step) {
                    continue;
                }
                form = EquilibriumSolver(built.net).solve(lengths, form).form;
                is_kept = (tensions_of(built.net, lengths, form) - allowed).minCoeff() >= 0.0;
            }
            kept += is_kept ? 1 : 0;
        }
        return static_cast<double>(kept) / static_cast<double>(nets.cols());
    }

    static constexpr double least = 2.2e3;
    CableNet net = hypar(6, 6);
    BuiltNet built = test::random_built(net, 7, 3e-3);
    Limits limits = test::strokes_up_to(net, 15e-3);
    Plan plan;
};

TEST_F(TurnOrderOfDraws, IsSafeInAsManySamplesAsItSays) {
    ASSERT_TRUE(plan.is_feasible);
    for (const int crews : {1, 2}) {
        const TurnOrder order = order_turns(built, limits, plan, {.crews = crews});
        EXPECT_NEAR(order.safe_probability, part_kept(order, built.length_draws), 1e-9);
        EXPECT_EQ(order.is_safe, order.safe_probability >= 191.0 / 200.0);
    }
}

TEST_F(TurnOrderOfDraws, KeepsItsConfidenceInOtherSamplesThanItsOwn) {
    const TurnOrder order = order_turns(built, limits, plan);
    ASSERT_TRUE(order.is_safe);
    EXPECT_GE(part_kept(order, lengths_drawn(200, 12)), 0.9);  // 95 % required
}

TEST_F(TurnOrderOfDraws, IsNotSafeWhereTheConfidenceCannotBeKept) {
    // More than the plan itself has.
    ASSERT_TRUE(plan.limit_probability.has_value());
    const double most = *plan.limit_probability + 0.5 * (1.0 - *plan.limit_probability);
    const TurnOrder order = order_turns(built, limits, plan, {.confidence = most});
    ASSERT_LT(plan.limit_probability, 1.0);
    EXPECT_FALSE(order.is_safe);
    EXPECT_GT(order.safe_probability, 0.0);
    ASSERT_GE(order.worst.step, 0);
    EXPECT_EQ(order.worst.breach.limit, least);
    EXPECT_LT(order.worst.breach.probability, 1.0);
    EXPECT_GT(order.worst.breach.probability, 0.0);
}

TEST_F(TurnOrderOfHilo, RefusesOptionsOutOfRange) {
    expect_refused([&] { return order_of({.crews = 0}); }, "0 crews");
    expect_refused([&] { return order_of({.turn_step = -1.0}); }, "smallest turn is -1 m");
    expect_refused([&] { return order_of({.confidence = 1.0}); }, "confidence is 1");
    expect_refused([&] { return order_of({.actuator_std = -1.0}); }, "actuator std is -1 m");
}

TEST_F(TurnOrderOfHilo, RefusesAPlanOfAnotherNetOrOtherLimits) {
    const auto expect_other_refused = [&](auto change, const char* text) {
        Plan other = plan;
        change(other);
        expect_refused([&] { return order_turns(built, limits, other); }, text);
    };
    const int edges = built.net.edge_count();
    expect_other_refused([&](Plan& p) { p.strokes[0].edge = edges; }, "expected 0 to");
    expect_other_refused([](Plan& p) { p.strokes[1].edge = p.strokes[0].edge; }, "twice");
    expect_other_refused([](Plan& p) { p.strokes[0].stroke = std::nan(""); }, "by nan m");
    expect_other_refused([](Plan& p) { p.effective_limits.clear(); },
                         "0 sets of loads, expected 1");
    expect_other_refused([](Plan& p) { p.effective_limits[0].lower.conservativeResize(3); },
                         "limits of 3 and");
}

}  // namespace
}  // namespace taut
