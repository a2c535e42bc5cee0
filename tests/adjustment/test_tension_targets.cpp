// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against plans that turn away from target tensions, that report as reached what is not, and
// that do not say what is in the way.
#include "adjustment/tension_targets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "adjustment/built_nets.hpp"
#include "adjustment/resolved_request.hpp"
#include "adjustment/target_deviations.hpp"
#include "support/finite_differences.hpp"
#include "taut/adjustment/plan_turns.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using ::testing::Each;
using ::testing::Field;
using ::testing::HasSubstr;

/// A net built with random lengths, its design, and the tensions as it stands.
class TensionTargets : public ::testing::Test {
protected:
    [[nodiscard]] std::vector<TensionTarget> targets_at(const std::vector<int>& edges,
                                                        double factor,
                                                        double tolerance = 0.01) const {
        std::vector<TensionTarget> targets;
        for (const int edge : edges) {
            targets.push_back({.edge = edge,
                               .tension = factor * now(edge),
                               .tolerance = tolerance * factor * now(edge)});
        }
        return targets;
    }

    [[nodiscard]] Plan planned(const PlanOptions& options, double stroke = 15e-3,
                               DeviationWeights weights = {},
                               FormObjective objective = FormObjective::rms) const {
        return plan_strokes(built, FormTarget(design, design.nodes(), weights, objective),
                            test::strokes_up_to(built.net, stroke), options);
    }

    static void expect_target_refused(const auto& action, const char* text) {
        try {
            static_cast<void>(action());
            ADD_FAILURE() << "expected: " << text;
        } catch (const RequestError& error) {
            EXPECT_EQ(error.field(), "target_tension");
            EXPECT_THAT(error.problem(), HasSubstr(text));
        }
    }

    static auto all_have(TensionObstacle obstacle) {
        return Each(Field(&ReachedTension::obstacle, obstacle));
    }

    CableNet design = hypar(5, 5);
    BuiltNet built = test::random_built(design, 7, 2e-3);
    Eigen::VectorXd now = tensions_of(built.net, built.net.unstressed_lengths(), built.net.nodes());
    std::vector<int> some = {design.adjustable_edges()[0], design.adjustable_edges()[5],
                             design.adjustable_edges()[11]};
};

constexpr DeviationWeights no_form{.normal = 0.0, .tangential = 0.0};

TEST_F(TensionTargets, HaveTheRatesOfSolvedTensions) {
    StrokeResponse response(built.net, design.adjustable_edges(), {});
    const Eigen::VectorXd none =
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(design.adjustable_edges().size()));
    const Eigen::VectorXd lengths = built.net.unstressed_lengths();
    const StrokedNet at = response.at(lengths, none, built.net.nodes());
    for (const FormObjective objective : {FormObjective::rms, FormObjective::largest}) {
        const FormTarget target(design, design.nodes(), {}, objective);
        const StrokeTask task{
            .target = &target, .tensions = targets_at({2, 9, 30}, 1.2), .form_tolerance = 4e-3};
        const Eigen::MatrixXd differences = test::finite_differences(
            [&](const Eigen::VectorXd& strokes) {
                return deviations_from_targets(task, built.net,
                                               response.at(lengths, strokes, at.equilibrium.form))
                    .values;
            },
            none, 1e-6);
        const auto [values, rates] =
            deviations_from_targets(task, built.net, at, response.rates(at));
        EXPECT_LT((rates - differences).cwiseAbs().maxCoeff(),
                  2e-5 * differences.cwiseAbs().maxCoeff());
        // (tension-targets): targets 20 % above are 1 / 0.01 / 6 tolerances away.
        const double of_tensions = std::pow(4e-3 * 0.2 / (0.01 * 1.2), 2);
        const double of_form =
            cost_of({.target = &target}, values.head(Eigen::Index{3} * design.free_node_count()));
        EXPECT_NEAR(cost_of(task, values),
                    objective == FormObjective::rms ? of_form + of_tensions
                                                    : std::max(of_form, of_tensions),
                    1e-9);
    }
}

TEST_F(TensionTargets, AreReachedWhereThereAreTurnbucklesEnough) {
    const Plan before = planned({});
    for (const double factor : {0.8, 1.25}) {
        const PlanOptions options{.target_tensions = targets_at(some, factor)};
        const Plan plan = planned(options, 15e-3, no_form);
        EXPECT_TRUE(plan.is_feasible);
        ASSERT_EQ(plan.target_tensions.size(), some.size());
        EXPECT_THAT(plan.target_tensions, all_have(TensionObstacle::none));
        for (const ReachedTension& one : plan.target_tensions) {
            EXPECT_NEAR(one.planned, one.target, 0.05 * one.tolerance);
            EXPECT_NEAR(one.planned, plan.tensions(one.edge), 1e-9);
            EXPECT_NEAR(one.as_built, now(one.edge), 1e-3 * one.tolerance);
            EXPECT_FALSE(one.probability.has_value());
        }
        // Beside the form the tensions are weighed against it.
        const Plan both = planned(options);
        EXPECT_THAT(both.target_tensions, all_have(TensionObstacle::none));
        EXPECT_LT(both.planned.normal_rmse, plan.planned.normal_rmse);
        EXPECT_GE(both.planned.normal_rmse, 0.999 * before.planned.normal_rmse);
    }
}

TEST_F(TensionTargets, SayWhatIsInTheWay) {
    const std::vector<TensionTarget> raised = targets_at(some, 1.3);
    EXPECT_THAT(planned({.target_tensions = raised}, 0.05e-3, no_form).target_tensions,
                all_have(TensionObstacle::limits));
    const Plan stiff = planned({.target_tensions = raised, .form_tolerance = 1e-6}, 15e-3);
    EXPECT_THAT(stiff.target_tensions, all_have(TensionObstacle::form));
    // One turnbuckle does not bring two cables apart that share a node of the net.
    const int first = design.adjustable_edges()[0];
    int inner = 0;
    while (std::ranges::find(design.interior_edges(), inner) == design.interior_edges().end()) {
        ++inner;
    }
    std::vector<TensionTarget> apart = targets_at({first}, 0.5);
    for (const TensionTarget& other : targets_at({inner}, 2.0)) {
        apart.push_back(other);
    }
    std::ranges::sort(apart, {}, &TensionTarget::edge);
    const Plan few = plan_strokes(built, FormTarget(design, design.nodes(), no_form),
                                  stroke_limits(built.net, {first}, 15e-3),
                                  {.edges = {first}, .target_tensions = apart});
    EXPECT_TRUE(std::ranges::any_of(few.target_tensions, [](const ReachedTension& one) {
        return one.obstacle == TensionObstacle::turnbuckles;
    }));
}

TEST_F(TensionTargets, TightenSlackEdges) {
    Eigen::VectorXd lengths = design.unstressed_lengths();
    lengths(some[0]) += 40e-3;
    built.net = test::with_lengths(design, lengths);
    const double slack =
        tensions_of(built.net, built.net.unstressed_lengths(), built.net.nodes())(some[0]);
    ASSERT_EQ(slack, 0.0);
    const Plan plan = planned({.target_tensions = targets_at(some, 1.0)}, 60e-3, no_form);
    EXPECT_EQ(plan.target_tensions[0].as_built, 0.0);
    EXPECT_THAT(plan.target_tensions, all_have(TensionObstacle::none));
}

TEST_F(TensionTargets, AreReachedInTheMeanOfTheSamples) {
    // Samples of a stiffer net: their mean is above the estimate.
    test::Random random(3);
    std::normal_distribution<double> normal;
    constexpr int draws = 100;
    built.length_draws = built.net.unstressed_lengths().replicate(1, draws);
    for (int d = 0; d < draws; ++d) {
        ModelPerturbation one = unperturbed(built.net);
        one.stiffness.setConstant(0.1 + 0.03 * normal(random));
        built.perturbations.push_back(one);
    }
    const Plan plan = planned({.target_tensions = targets_at(some, 1.1, 0.02)}, 15e-3, no_form);
    for (const ReachedTension& one : plan.target_tensions) {
        EXPECT_NEAR(*one.mean, one.target, 0.1 * one.tolerance);
        EXPECT_GT(std::abs(one.planned - one.target), one.tolerance);
        EXPECT_EQ(one.obstacle, TensionObstacle::none);
        EXPECT_NEAR(*one.std_dev, 0.03 * one.target, 0.015 * one.target);
        // The probability of a normal distribution between its tolerances.
        EXPECT_NEAR(*one.probability, std::erf(one.tolerance / (*one.std_dev * std::sqrt(2.0))),
                    0.15);
    }
}

TEST_F(TensionTargets, AreKeptByFewEdgesAndInWholeSteps) {
    PlanOptions options{.tolerance = 1.0, .target_tensions = targets_at(some, 1.2, 0.05)};
    const Plan all = planned({.target_tensions = options.target_tensions});
    const Plan few = planned(options);  // the form is always within a metre
    EXPECT_EQ(few.is_within_tolerance, true);
    EXPECT_LT(few.strokes.size(), all.strokes.size() / 2);
    EXPECT_LE(tension_rmse(options.target_tensions, few.tensions), 1.0);
    ASSERT_TRUE(few.fewest_bound);
    EXPECT_LE(*few.fewest_bound, static_cast<int>(few.strokes.size()));
    options.tolerance = 1e-6;
    EXPECT_EQ(planned(options).is_within_tolerance, false);
    options = {.turn = TurnSize{.pitch = 2e-3, .smallest = 0.25},
               .target_tensions = options.target_tensions};
    const Plan steps = planned(options, 15e-3, no_form);
    for (const PlannedStroke& stroke : steps.strokes) {
        EXPECT_NEAR(std::remainder(stroke.stroke, 0.5e-3), 0.0, 1e-9);
    }
    EXPECT_LE(tension_rmse(options.target_tensions, steps.tensions), 1.0);
}

TEST_F(TensionTargets, HaveTheSmallestLargestDeviationIfAskedTo) {
    const PlanOptions options{.target_tensions = targets_at({1, 2, 3, 10, 20, 30}, 1.2)};
    const auto largest = [](const Plan& plan) {
        double most = 0.0;
        for (const ReachedTension& one : plan.target_tensions) {
            most = std::max(most, std::abs(one.deviation()));
        }
        return most;
    };
    const Plan mean = planned(options, 1e-3, no_form);
    const Plan least = planned(options, 1e-3, no_form, FormObjective::largest);
    EXPECT_TRUE(least.has_converged);
    EXPECT_LT(largest(least), 0.95 * largest(mean));
}

TEST_F(TensionTargets, SuggestTheEdgeThatReachesThem) {
    // One turnbuckle is turned, and one interior cable is to be tightened.
    const int inner = design.interior_edges()[design.interior_edge_count() / 2];
    const std::vector<int> edges = {design.adjustable_edges()[0]};
    const PlanOptions options{.edges = edges, .target_tensions = targets_at({inner}, 1.5)};
    const FormTarget target(design, design.nodes(), no_form);
    const Limits limits = stroke_limits(built.net, edges, 10e-3);
    const Plan plan = plan_strokes(built, target, limits, options);
    ASSERT_GT(std::abs(plan.target_tensions[0].deviation()), 1.0);
    const std::vector<SuggestedEdge> suggested =
        suggested_edges(built, target, limits, options, plan, 1);
    ASSERT_EQ(suggested.size(), 1U);
    EXPECT_LT(suggested[0].tension_rmse_after.value(), 0.1);
}

TEST_F(TensionTargets, OfEdgesOverrideThoseOfGroupsAndTheseThoseOfAll) {
    CableNetData data = design.data();
    data.groups = {{"ridge", {3, 4}}, {"valley", {4, 5}}};
    const CableNet net(data);
    const auto resolved = [&](const std::vector<GivenTension>& given) {
        return resolve(net, {.net = net}, {.target_tension = given}).options.target_tensions;
    };
    const GivenTension edge{.tension = 3e3, .tolerance = {.value = 40.0}, .edge = 3};
    const GivenTension ridge{.tension = 2e3, .group = "ridge"};
    const GivenTension all{.tension = 1e3, .tolerance = {.value = 0.1, .is_part = true}};
    const std::vector<TensionTarget> targets = resolved({edge, all, ridge});
    ASSERT_EQ(targets.size(), static_cast<size_t>(net.edge_count()));
    EXPECT_EQ(targets[3].tension, 3e3);
    EXPECT_EQ(targets[3].tolerance, 40.0);
    EXPECT_EQ(targets[4].tension, 2e3);
    EXPECT_EQ(targets[4].tolerance, 100.0);
    EXPECT_EQ(targets[5].tension, 1e3);
    EXPECT_EQ(targets[5].tolerance, 100.0);
    const auto refused = [&](const std::vector<GivenTension>& given, const char* text) {
        expect_target_refused([&] { return resolved(given); }, text);
    };
    refused({ridge, {.tension = 1e3, .group = "valley"}}, "is given twice: 2000 +- 100 N and 1000");
    refused({{.tension = 1e3, .group = "roof"}}, "names the group 'roof'");
    refused({{.tension = 1e3, .edge = net.edge_count()}}, "names edge ");
    EXPECT_THROW(
        static_cast<void>(resolve(net, {.net = net}, {.options = {.form_tolerance = 1e-3}})),
        RequestError);
}

TEST_F(TensionTargets, AreRefusedWhereNoPlanCanReachThem) {
    Limits limits = test::strokes_up_to(built.net, 15e-3);
    limits.tension.lower(some[0]) = 0.9 * now(some[0]);
    limits.tension.upper(some[0]) = 1.1 * now(some[0]);
    const auto refused = [&](const std::vector<TensionTarget>& targets, const char* text) {
        expect_target_refused(
            [&] {
                return plan_strokes(built, FormTarget(design, design.nodes()), limits,
                                    {.target_tensions = targets});
            },
            text);
    };
    refused(targets_at({some[0]}, 1.2), "but its tension is limited to");
    refused(targets_at({some[0]}, 0.8), "but its tension is limited to");
    refused({{.edge = 1, .tension = 0.0, .tolerance = 1.0}}, "no edge may go slack");
    refused({{.edge = 1, .tension = std::nan(""), .tolerance = 1.0}}, "no edge may go slack");
    refused({{.edge = 1, .tension = 1e3, .tolerance = 0.0}}, "has the tolerance 0 N");
    refused({{.edge = -1, .tension = 1e3, .tolerance = 1.0}}, "names edge -1");
    refused(targets_at({2, 2}, 1.0), "at most once");
    EXPECT_THROW(static_cast<void>(planned({}, 15e-3, no_form)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(
                     planned({.target_tensions = targets_at(some, 1.0), .form_tolerance = 0.0})),
                 RequestError);
}

}  // namespace
}  // namespace taut
