// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a path that ends far from the equilibrium, or takes many steps where edges go
// slack.
#include "statics/interior_point.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>

#include "support/hilo_roof.hpp"
#include "support/random_nets.hpp"
#include "support/steel_roof.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/statics/duality.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {
namespace {

struct Approach {
    Points form;
    int steps;
};

/// Interior-point steps alone, from the nominal form.
Approach approach(const CableNet& net, const Eigen::VectorXd& lengths, int max_steps = 500) {
    const LocalNet local = number_for_elimination(net);
    Stiffness stiffness(local);
    NetState state(local);
    state.set_unstressed_lengths(local, lengths);
    state.update(local);
    const int steps = InteriorPoint(local).run(local, stiffness, state, max_steps);
    return {local.scatter(state.form()), steps};
}

TEST(InteriorPoint, FindsTheFormThatNewtonsMethodFinds) {
    const CableNet net = hilo_quarter();
    test::Random random(3);
    for (const double reach : {1e-3, 5e-3, 10e-3}) {
        const Eigen::VectorXd lengths = with_length_deviations(
            net, test::uniform_vector(random, net.interior_edge_count(), reach));
        const Equilibrium newton = EquilibriumSolver(net).solve(lengths, net.nodes());
        ASSERT_EQ(newton.status, EquilibriumStatus::converged);
        const Approach found = approach(net, lengths);
        EXPECT_LT((found.form - newton.form).cwiseAbs().maxCoeff(), 1e-6) << reach;
        EXPECT_LT(energy_certificate(net, lengths, found.form).relative_gap, 1e-6) << reach;
    }
}

RC_GTEST_PROP(InteriorPointOnARandomNet, LeavesAGapThatHardlyMatters, ()) {
    test::Random random = test::any_random();
    const CableNet net = test::random_net(random);
    const Approach found = approach(net, net.unstressed_lengths());
    RC_ASSERT(found.steps < 300);
    const Equilibrium rest = solve_equilibrium(net);
    const double scale =
        energy_certificate(net, net.unstressed_lengths(), rest.form).complementary_energy;
    RC_ASSERT(potential_energy(net, net.unstressed_lengths(), found.form) - scale <
              1e-6 * (1.0 + std::abs(scale)));
}

// Edges may turn so fast that they grow taut, though they slacken to first order. The step at which
// they run out of play must be found.
TEST(InteriorPoint, StaysOnItsPathWhereEdgesTurn) {
    for (const std::uint64_t seed : {16749703548055632920ULL, 171420508ULL, 447295527ULL}) {
        test::Random random(seed);
        const CableNet net = test::random_net(random);
        const Eigen::VectorXd& lengths = net.unstressed_lengths();
        const Points form = approach(net, lengths).form;
        const double lowest = potential_energy(net, lengths, solve_equilibrium(net).form);
        EXPECT_LT(potential_energy(net, lengths, form) - lowest, 1e-6 * (1.0 + std::abs(lowest)))
            << seed;
    }
}

TEST(InteriorPoint, StopsAtItsLimit) {
    CableNetData data = hypar(8, 8).data();
    data.unstressed_lengths *= 1.05;
    data.loads.row(2).setConstant(-1.0);
    const CableNet net(std::move(data));
    EXPECT_EQ(approach(net, net.unstressed_lengths(), 0).steps, 0);
    EXPECT_EQ(approach(net, net.unstressed_lengths(), 0).form, net.nodes());
    EXPECT_EQ(approach(net, net.unstressed_lengths(), 3).steps, 3);
}

void expect_few_steps(const CableNet& net, size_t least_slack) {
    EquilibriumSolver solver(net);
    test::Random random(5);
    for (int i = 0; i < 5; ++i) {
        const Eigen::VectorXd lengths = with_length_deviations(
            net, test::uniform_vector(random, net.interior_edge_count(), 5e-3));
        const Equilibrium e = solver.solve(lengths, net.nodes());
        EXPECT_EQ(e.status, EquilibriumStatus::converged);
        EXPECT_LT(e.iterations, 25);
        EXPECT_GT(e.slack_edges.size(), least_slack);
        EXPECT_LT(energy_certificate(net, lengths, e.form).relative_gap, 1e-9);
    }
}

TEST(InteriorPoint, TakesFewStepsWhereEdgesOfASteelRoofGoSlackOnTheWay) {
    expect_few_steps(test::steel_lattice(), 5);
}

TEST(InteriorPoint, TakesFewStepsWhereHundredsOfEdgesOfTheHiloRoofGoSlackOnTheWay) {
    TAUT_NEEDS_HILO_ROOF();
    expect_few_steps(test::hilo_roof(), 20);
}

}  // namespace
}  // namespace taut
