// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against the effects of slack edges on a solver: a stiffness that is singular or zero,
// loose nodes reported as a unique form, and slack nets under light loads, where Newton's method is
// slow.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/balance.hpp"
#include "support/small_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(SlackNet, ThatIsSlackFromTheStartStaysWhereItIs) {
    const CableNet net = hilo_quarter();
    const Equilibrium e = EquilibriumSolver(net).solve(1.5 * net.unstressed_lengths(), net.nodes());
    EXPECT_EQ(e.status, EquilibriumStatus::slack_mechanism);
    EXPECT_TRUE(e.balanced());
    EXPECT_EQ(e.form, net.nodes());
    EXPECT_EQ(e.iterations, 0);
    EXPECT_EQ(e.out_of_balance, 0.0);
    EXPECT_EQ(e.mean_tension, 0.0);
    EXPECT_THAT(e.slack_edges, SizeIs(net.edge_count()));
}

TEST(SlackNet, WithAnEdgeAtItsUnstressedLengthIsAMechanism) {
    // One edge, pulled back from 3 m: it ends at l_0 or, by rounding errors, slightly above.
    CableNetData data = test::chain_data(2, 1.0, 0.0);
    data.supports = {0};
    data.nodes(0, 1) = 3.0;
    data.nodes(0, 2) = 5.0;
    const CableNet net(std::move(data));
    for (const double length : {1.0, 0.7, 1.0 / 3.0, 0.1234}) {
        const Equilibrium e =
            EquilibriumSolver(net).solve(Eigen::Vector2d::Constant(length), net.nodes());
        EXPECT_EQ(e.status, EquilibriumStatus::slack_mechanism) << length;
        EXPECT_LT(e.out_of_balance, 1e-8);
    }
}

TEST(SlackNet, WithOneLooseNodeIsAMechanism) {
    CableNetData data = test::cross_with_a_loose_node_data();
    const CableNet net(data);
    const Equilibrium e = solve_equilibrium(net);
    EXPECT_EQ(e.status, EquilibriumStatus::slack_mechanism);
    EXPECT_THAT(e.slack_edges, ElementsAre(4));
    EXPECT_LT((e.form.col(5) - data.nodes.col(5)).norm(), 1e-12);

    // A load makes it hang straight down: the form is unique again.
    data.loads = Points::Zero(3, 6);
    data.loads(2, 5) = -1000.0;
    const CableNet loaded(std::move(data));
    const Equilibrium hanging = solve_equilibrium(loaded);
    EXPECT_EQ(hanging.status, EquilibriumStatus::converged);
    EXPECT_THAT(hanging.slack_edges, IsEmpty());
    EXPECT_LT((hanging.form.col(5) - hanging.form.col(0)).head<2>().norm(), 1e-9);
    EXPECT_NEAR(hanging.form(2, 0) - hanging.form(2, 5), 0.5 * (1.0 + 1000.0 / 100e3), 1e-9);
}

class HangingChain : public ::testing::TestWithParam<double> {};

TEST_P(HangingChain, FindsItsFormFromASlackStart) {
    // All edges are slack on a straight line: the stiffness is zero, and every load acts downwards.
    const double weight = GetParam();
    const CableNet net(test::chain_data(12, 9.0, weight));
    const Equilibrium e = solve_equilibrium(net);
    ASSERT_EQ(e.status, EquilibriumStatus::converged);
    EXPECT_THAT(e.slack_edges, IsEmpty());
    // The horizontal force is the same everywhere; the vertical one grows by a weight a node.
    const Eigen::VectorXd tension = tensions_of(net, net.unstressed_lengths(), e.form);
    const Eigen::VectorXd length = edge_lengths(net, e.form);
    const double scale = tension.maxCoeff();
    const auto pull = [&](int edge) -> Eigen::Vector3d {
        return tension(edge) / length(edge) * (e.form.col(edge + 1) - e.form.col(edge));
    };
    // Rounding errors of the coordinates alone cause forces of some EA * 1e-15 in edges of 1 m.
    const double tolerance = 1e-9 * scale + 1e-13 * 100e3;
    for (int edge = 1; edge < net.edge_count(); ++edge) {
        EXPECT_NEAR(pull(edge).x(), pull(0).x(), tolerance);
        EXPECT_NEAR(pull(edge).z() - pull(edge - 1).z(), weight, tolerance);
    }
    EXPECT_NEAR(e.form(0, 6), 4.5, 1e-6);
    EXPECT_LT(e.form(2, 6), -3.0);
}

INSTANTIATE_TEST_SUITE_P(Weights, HangingChain, ::testing::Values(1e-3, 1.0, 1e2, 1e4));

class SlackNetUnderLoad : public ::testing::TestWithParam<double> {};

TEST_P(SlackNetUnderLoad, ConvergesInFewSteps) {
    CableNetData data = hilo_quarter().data();
    data.unstressed_lengths *= 1.1;
    for (Eigen::Index i = 0; i < data.nodes.cols(); ++i) {
        data.loads.col(i) << 0.0, 0.0, -GetParam();
    }
    const CableNet net(std::move(data));
    const Equilibrium e = solve_equilibrium(net);
    EXPECT_EQ(e.status, EquilibriumStatus::converged);
    EXPECT_LT(e.iterations, 50);
    // Rounding errors of coordinates up to 4.3 m, times EA/l_0 of four edges and more.
    const double rounding = 4.0 * 2.2e-16 * 4.3 * 4.0 * 200e3 / 0.07;
    EXPECT_LE(e.out_of_balance, 1e-10 * e.mean_tension + rounding);
}

INSTANTIATE_TEST_SUITE_P(Loads, SlackNetUnderLoad, ::testing::Values(1e-3, 0.1, 10.0, 1e3, 1e5));

TEST(NetOfUnlikeEdges, ConvergesWithStiffnessesThatDifferByAMillion) {
    CableNetData data = hilo_quarter().data();
    for (Eigen::Index e = 0; e < data.axial_stiffness.size(); ++e) {
        data.axial_stiffness(e) *= std::pow(10.0, static_cast<double>(e * 7919 % 601) / 100 - 3.0);
        data.unstressed_lengths(e) *= 1.0 + 1e-4 * static_cast<double>(e * 104729 % 201 - 100);
    }
    const CableNet net(std::move(data));
    const Equilibrium e = solve_equilibrium(net);
    EXPECT_EQ(e.status, EquilibriumStatus::converged);
    EXPECT_LT(e.iterations, 50);
}

}  // namespace
}  // namespace taut
