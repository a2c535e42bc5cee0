// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against forms reported as equilibrium in which forces do not balance, and against failures
// of the solver on nets and lengths as built.
#include "taut/statics/equilibrium.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/balance.hpp"
#include "support/not_finite.hpp"
#include "support/random_nets.hpp"
#include "support/small_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/imbalance.hpp"

namespace taut {
namespace {

using ::testing::Each;
using ::testing::Ge;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// What every result with status converged promises.
void expect_converged(const CableNet& net, const Eigen::VectorXd& lengths, const Equilibrium& e) {
    ASSERT_EQ(e.status, EquilibriumStatus::converged);
    EXPECT_TRUE(e.balanced());
    const double imbalance = test::largest_imbalance(net, lengths, e.form);
    const double tension = test::mean_tension(net, lengths, e.form);
    EXPECT_LE(imbalance, 1e-10 * tension);
    EXPECT_NEAR(e.out_of_balance, imbalance, 1e-11 * tension);
    EXPECT_NEAR(e.mean_tension, tension, 1e-11 * tension);
    EXPECT_EQ(e.slack_edges, slack_edges(net, lengths, e.form));
    EXPECT_THAT(e.energy_decreases, SizeIs(::testing::Le(e.iterations)));
    // In the last steps the decrease may be a rounding error.
    const double rounding = 1e-12 * std::abs(potential_energy(net, lengths, e.form));
    EXPECT_THAT(e.energy_decreases, Each(Ge(-rounding)));
    for (const int support : net.supports()) {
        EXPECT_EQ(e.form.col(support), net.nodes().col(support));
    }
}

/// Solves a net for random length deviations, several times.
/// @return how often an edge was slack
int solve_for_random_lengths(const CableNet& net, double reach, int times, std::uint64_t seed) {
    test::Random random(seed);
    EquilibriumSolver solver(net);
    int with_slack = 0;
    for (int i = 0; i < times; ++i) {
        const Eigen::VectorXd lengths = with_length_deviations(
            net, test::uniform_vector(random, net.interior_edge_count(), reach));
        const Equilibrium e = solver.solve(lengths, net.nodes());
        expect_converged(net, lengths, e);
        with_slack += e.slack_edges.empty() ? 0 : 1;
    }
    return with_slack;
}

TEST(Equilibrium, IsFoundForRandomLengthsAndSlackEdges) {
    solve_for_random_lengths(hilo_quarter(), 5e-3, 20, 1);
    EXPECT_GT(solve_for_random_lengths(hilo_quarter(), 10e-3, 20, 2), 10);
    for (const auto& [rows, columns] : {std::pair{1, 1}, {1, 9}, {2, 2}, {12, 7}, {30, 30}}) {
        solve_for_random_lengths(hypar(rows, columns), 3e-3, 3, 3);
    }
}

TEST(Equilibrium, OfANetThatBalancesIsItsNominalForm) {
    for (const CableNet& net : {hilo_quarter(), hypar(6, 9)}) {
        const Equilibrium e = solve_equilibrium(net);
        expect_converged(net, net.unstressed_lengths(), e);
        EXPECT_LT((e.form - net.nodes()).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_THAT(e.slack_edges, IsEmpty());
    }
}

TEST(Equilibrium, OfACrossUnderLoadIsThatComputedByHand) {
    // l_0 = 0.8 m, moved 0.75 m down all edges are 1.25 m long: a load of 4 T 0.75 / 1.25.
    CableNetData data = test::cross_data(0.25);
    data.loads = Points::Zero(3, 5);
    data.loads(2, 0) = -4.0 * 100e3 * (1.25 / 0.8 - 1.0) * 0.6;
    const CableNet net(std::move(data));
    const Equilibrium e = solve_equilibrium(net);
    expect_converged(net, net.unstressed_lengths(), e);
    EXPECT_LT((e.form.col(0) - Eigen::Vector3d(0.0, 0.0, -0.75)).norm(), 1e-13);
}

TEST(EquilibriumSolver, GivesTheSameBitsWhateverItSolvedBefore) {
    CableNetData data = hypar(5, 6).data();
    data.loads.row(2).setConstant(-2.0);
    const CableNet net(std::move(data));
    const Eigen::VectorXd tense = net.unstressed_lengths();
    const Eigen::VectorXd loose = 1.1 * tense;  // needs interior-point steps
    EquilibriumSolver solver(net);
    const Equilibrium first = solver.solve(tense, net.nodes());
    const Equilibrium hanging = solver.solve(loose, net.nodes());
    EXPECT_EQ(hanging.status, EquilibriumStatus::converged);
    EquilibriumSolver moved = std::move(solver);
    const Equilibrium again = moved.solve(tense, net.nodes());
    EXPECT_EQ(again.form, first.form);
    EXPECT_EQ(again.energy_decreases, first.energy_decreases);
    EXPECT_EQ(moved.solve(loose, net.nodes()).form, hanging.form);
    EXPECT_EQ(EquilibriumSolver(net).solve(loose, net.nodes()).form, hanging.form);
}

TEST(EquilibriumSolver, ReportsItsIterationLimit) {
    const CableNet net = hilo_quarter();
    test::Random random(4);
    const Eigen::VectorXd lengths =
        with_length_deviations(net, test::uniform_vector(random, net.interior_edge_count(), 5e-3));
    for (const int limit : {0, 1, 2}) {
        EquilibriumSolver solver(net, {.max_iterations = limit});
        const Equilibrium e = solver.solve(lengths, net.nodes());
        EXPECT_EQ(e.status, EquilibriumStatus::iteration_limit);
        EXPECT_FALSE(e.balanced());
        EXPECT_EQ(e.iterations, limit);
        EXPECT_NEAR(e.out_of_balance, test::largest_imbalance(net, lengths, e.form), 1e-6);
        EXPECT_GT(e.out_of_balance, 1e-10 * e.mean_tension);
    }
    CableNetData loose = hypar(8, 8).data();  // needs interior-point steps
    loose.unstressed_lengths *= 1.2;
    loose.loads.row(2).setConstant(-1e-3);
    const int needed = solve_equilibrium(CableNet(loose)).iterations;
    ASSERT_GT(needed, 10);
    for (const int limit : {1, 2, 5, needed / 2}) {
        const Equilibrium e = solve_equilibrium(CableNet(loose), {.max_iterations = limit});
        EXPECT_EQ(e.status, EquilibriumStatus::iteration_limit);
        EXPECT_EQ(e.iterations, limit);
    }
}

TEST(EquilibriumSolver, StopsEarlierForACoarserTolerance) {
    const CableNet net = hilo_quarter();
    test::Random random(5);
    const Eigen::VectorXd lengths =
        with_length_deviations(net, test::uniform_vector(random, net.interior_edge_count(), 5e-3));
    const Equilibrium fine = EquilibriumSolver(net).solve(lengths, net.nodes());
    const Equilibrium coarse =
        EquilibriumSolver(net, {.relative_tolerance = 1e-2}).solve(lengths, net.nodes());
    EXPECT_EQ(coarse.status, EquilibriumStatus::converged);
    EXPECT_LT(coarse.iterations, fine.iterations);
    EXPECT_LE(coarse.out_of_balance, 1e-2 * coarse.mean_tension);
}

TEST(EquilibriumSolver, RefusesSettingsThatEveryFormWouldMeet) {
    const CableNet net = hypar(2, 2);
    for (const double tolerance : {0.0, -1.0, test::nan, test::infinity}) {
        EXPECT_THROW(EquilibriumSolver(net, {.relative_tolerance = tolerance}),
                     std::invalid_argument);
    }
    EXPECT_THROW(EquilibriumSolver(net, {.max_iterations = -1}), std::invalid_argument);
}

TEST(EquilibriumSolver, BalancesANetInTheCoordinatesOfANationalGrid) {
    CableNetData content = hypar(5, 5).data();
    content.unstressed_lengths *= 0.999;
    const Equilibrium near = solve_equilibrium(CableNet(content));
    const Eigen::Vector3d grid(2.6e6, 1.2e6, 450.0);
    content.nodes.colwise() += grid;
    const Equilibrium far = solve_equilibrium(CableNet(content));
    ASSERT_EQ(far.status, EquilibriumStatus::converged);
    // The grid's coordinates resolve 5e-10 m, which changes the tensions of the four cables at a
    // node.
    const double change =
        5e-10 * (content.axial_stiffness.array() / content.unstressed_lengths.array()).maxCoeff();
    EXPECT_LE(far.out_of_balance, 4.0 * change);
    EXPECT_LE(far.out_of_balance, 1e-6 * far.mean_tension);
    EXPECT_NEAR(far.out_of_balance,
                imbalance_of(CableNet(content), content.unstressed_lengths, far.form).largest,
                4.0 * change);
    EXPECT_LT((far.form.colwise() - grid - near.form).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(EquilibriumSolver, ClaimsNoBalanceThatTheCoordinatesOfAGridDoNotResolve) {
    // Tensions of some 0.1 N by a strain of 1e-9, which the grid's coordinates do not resolve.
    CableNetData content = hypar(5, 5).data();
    const CableNet net(content);
    content.nodes = solve_equilibrium(net).form;
    for (size_t e = 0; e < content.edges.size(); ++e) {
        const auto [s, t] = content.edges[e];
        content.unstressed_lengths(static_cast<Eigen::Index>(e)) =
            (content.nodes.col(s) - content.nodes.col(t)).norm() * (1.0 - 1e-9);
    }
    EXPECT_TRUE(solve_equilibrium(CableNet(content)).balanced());
    content.nodes.colwise() += Eigen::Vector3d(2.6e6, 1.2e6, 450.0);
    const Equilibrium far = solve_equilibrium(CableNet(content));
    EXPECT_EQ(far.status, EquilibriumStatus::iteration_limit);
    EXPECT_GT(far.out_of_balance, 1e-4 * far.mean_tension);
}

TEST(EquilibriumSolver, FindsTheFormFromANodeGivenAbsurdlyFarOff) {
    const CableNet net = hypar(5, 5);
    const Equilibrium expected = solve_equilibrium(net);
    for (const double far : {1e3, 1e6, 1e9, 1e12, 1e15}) {
        CableNetData content = net.data();
        content.nodes.col(net.free_nodes()[7]) = Eigen::Vector3d(far, -far, 0.3 * far);
        const CableNet moved(content);
        const Equilibrium found = solve_equilibrium(moved);
        ASSERT_EQ(found.status, EquilibriumStatus::converged) << far;
        EXPECT_LE(found.out_of_balance, 1e-10 * found.mean_tension) << far;
        EXPECT_LT((found.form - expected.form).cwiseAbs().maxCoeff(), 1e-9) << far;
        const Imbalance left = imbalance_of(moved, moved.unstressed_lengths(), found.form);
        EXPECT_LE(left.share(), 1e-8) << far;
        // Likewise if the start is far off.
        EquilibriumSolver solver(net);
        const Equilibrium from_far = solver.solve(net.unstressed_lengths(), moved.nodes());
        EXPECT_EQ(from_far.status, EquilibriumStatus::converged) << far;
        EXPECT_LT((from_far.form - expected.form).cwiseAbs().maxCoeff(), 1e-9) << far;
    }
}

TEST(EquilibriumSolver, GivesFiniteNumbersAtTheLimitsOfANet) {
    CableNetData content = hypar(2, 2).data();
    content.loads.setConstant(3, content.nodes.cols(), 1e15);
    content.axial_stiffness.setConstant(1e15);
    content.unstressed_lengths.setConstant(1e-15);
    const Equilibrium e = solve_equilibrium(CableNet(content));
    EXPECT_TRUE(e.form.allFinite());
    EXPECT_TRUE(std::isfinite(e.out_of_balance));
    EXPECT_TRUE(std::isfinite(e.mean_tension));
}

}  // namespace
}  // namespace taut
