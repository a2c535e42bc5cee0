// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against plans for cables that slide which hold for the model alone: turned on the true
// net, which slides on from where it stands with a friction that the plan does not know.
#include <gtest/gtest.h>

#include <cmath>

#include "adjustment/built_net_parts.hpp"
#include "adjustment/resolved_request.hpp"
#include "identification/simulated_survey.hpp"
#include "support/identify_lengths.hpp"
#include "taut/adjustment/built_net.hpp"
#include "taut/adjustment/plan_turns.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"

namespace taut {
namespace {

CableNet ridge(std::optional<double> friction) {
    CableNetData data = sliding_ridge().data();
    data.runs.at(0).friction = friction;
    return CableNet(std::move(data));
}

TEST(PlanOfASlidingCable, HoldsOnTheTrueNet) {
    const CableNet net = ridge({});
    const FormTarget target(net, net.nodes());
    constexpr int surveys = 20;
    double squares = 0.0;
    double inside = 0.0;
    for (int seed = 0; seed < surveys; ++seed) {
        const CableNet built = ridge(0.1 * (seed + 0.5) / surveys);  // all that taut assumes
        const test::SimulatedSurvey s =
            test::simulate(built, {LengthPrior::Kind::normal, 2e-3}, 0.5e-3, seed);
        const Identification found = test::identify_lengths(
            net, s.survey, {.prior = LengthPrior{LengthPrior::Kind::normal, 2e-3}, .draws = 100});
        const BuiltNet identified = built_net_of(net, found);
        const Plan plan = plan_turns(net, identified, target).plan;
        Eigen::VectorXd lengths = s.truth.unstressed_lengths;
        for (const PlannedStroke& one : plan.strokes) {
            lengths(one.edge) += one.stroke;
        }
        const Equilibrium after = EquilibriumSolver(built).solve(lengths, plan.form);
        ASSERT_TRUE(after.balanced());
        const Eigen::VectorXd tension = tensions_of(built, after.unstressed_lengths, after.form);
        inside += ((tension.array() >= plan.tension_lower.array()) &&
                   (tension.array() <= plan.tension_upper.array()))
                      .cast<double>()
                      .mean() /
                  surveys;
        squares += (after.form - plan.form)(Eigen::all, net.free_nodes())
                       .cwiseQuotient(plan.form_std(Eigen::all, net.free_nodes()))
                       .squaredNorm() /
                   (3.0 * net.free_node_count() * surveys);
        // Nothing slides before something is turned.
        EXPECT_LT((identified.net.nodes() - found.predicted.form).cwiseAbs().maxCoeff(), 1e-6);
    }
    EXPECT_NEAR(std::sqrt(squares), 1.0, 0.25);
    EXPECT_GT(inside, 0.9);
}

TEST(PlanOfASlidingCable, CountsTurnsWithoutWhatSlid) {
    const CableNet net = ridge(0.0);
    const test::SimulatedSurvey s =
        test::simulate(net, {LengthPrior::Kind::normal, 2e-3}, 0.5e-3, 4,
                       [](Eigen::VectorXd& deviations) { deviations(0) += 30e-3; });
    const Identification found = test::identify_lengths(
        net, s.survey, {.prior = LengthPrior{LengthPrior::Kind::normal, 20e-3}, .draws = 0});
    const BuiltNet built = built_net_of(net, found);
    const int end = net.data().runs.at(0).edges.front();
    // Its turnbuckle was not touched.
    ASSERT_GT(std::abs(built.net.unstressed_lengths()(end) - net.unstressed_lengths()(end)), 1e-3);
    EXPECT_LT(std::abs(turned_from_design(net, built, end)), 1e-9);
    EXPECT_NO_THROW((void)resolve(net, built, {.total_stroke = 1e-3}));
}

}  // namespace
}  // namespace taut
