// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards, on random nets with slack edges and loads, against results that depend on the start, the
// frame of the coordinates, or the order of nodes and edges. That the energy is the lowest:
// test_duality.cpp.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "support/balance.hpp"
#include "support/random_nets.hpp"
#include "support/small_nets.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {
namespace {

/// Rounding errors of coordinates of some 3 m, times EA/l_0 of the edges at a node [N].
double rounding(const CableNet& net) {
    return 1e-14 * (net.axial_stiffness().array() / net.unstressed_lengths().array()).sum();
}

RC_GTEST_PROP(EquilibriumOfARandomNet, Balances, ()) {
    test::Random random = test::any_random();
    const CableNet net = test::random_net(random);
    const Equilibrium e = solve_equilibrium(net);
    RC_ASSERT(e.balanced());
    RC_ASSERT(test::largest_imbalance(net, net.unstressed_lengths(), e.form) <=
              1e-10 * e.mean_tension + rounding(net));
    RC_ASSERT(e.slack_edges == slack_edges(net, net.unstressed_lengths(), e.form));
}

RC_GTEST_PROP(EquilibriumOfARandomNet, LosesTheReportedEnergyInEveryStep, ()) {
    test::Random random = test::any_random();
    const CableNet net = test::random_net(random);
    const Points start =
        with_free_coordinates(net, test::uniform_vector(random, 3 * net.free_node_count(), 5.0));
    const Equilibrium e = EquilibriumSolver(net).solve(net.unstressed_lengths(), start);
    const double before = potential_energy(net, net.unstressed_lengths(), start);
    const double after = potential_energy(net, net.unstressed_lengths(), e.form);
    double sum = 0.0;
    for (const double decrease : e.energy_decreases) {
        RC_ASSERT(decrease >= -1e-12 * (std::abs(before) + std::abs(after)));
        sum += decrease;
    }
    RC_ASSERT(std::abs(before - sum - after) <= 1e-12 * (std::abs(before) + std::abs(after)));
}

RC_GTEST_PROP(EquilibriumOfARandomNet, DoesNotDependOnTheStart, ()) {
    test::Random random = test::any_random();
    const CableNet net = test::random_net(random);
    EquilibriumSolver solver(net);
    const Equilibrium near = solver.solve(net.unstressed_lengths(), net.nodes());
    const Points far_start = test::uniform_points(random, net.node_count(), 10.0);
    const Equilibrium far = solver.solve(net.unstressed_lengths(), far_start);
    RC_ASSERT(far.status == near.status);
    if (near.status == EquilibriumStatus::converged) {
        RC_ASSERT((far.form - near.form).norm() < 1e-7);
    }
}

RC_GTEST_PROP(EquilibriumOfARandomNet, MovesWithItsFrameAndDoesNothingElse, ()) {
    test::Random random = test::any_random();
    const CableNet net = test::random_net(random);
    const CableNetData data = net.data();
    const Eigen::Vector3d shift = test::uniform_points(random, 1, 10.0);
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond(Eigen::Vector4d(test::uniform_vector(random, 4, 1.0)))
            .normalized()
            .toRotationMatrix();
    const auto moved = [&](const Points& points) -> Points {
        return (turn * points).colwise() + shift;
    };
    CableNetData moved_data = data;
    moved_data.nodes = moved(data.nodes);
    moved_data.loads = turn * data.loads;
    for (ElasticSupport& support : moved_data.elastic_supports) {
        const Eigen::Matrix3d stiffness = turn * support.stiffness * turn.transpose();
        support.stiffness = 0.5 * (stiffness + stiffness.transpose());
        support.place = moved(support.place);
    }
    for (SupportCoupling& coupling : moved_data.support_couplings) {
        coupling.stiffness = turn * coupling.stiffness * turn.transpose();
    }
    const CableNet moved_net(std::move(moved_data));

    const Equilibrium e = solve_equilibrium(net);
    const Equilibrium f = solve_equilibrium(moved_net);
    RC_ASSERT(f.status == e.status);
    if (e.status == EquilibriumStatus::converged) {
        RC_ASSERT((f.form - moved(e.form)).norm() < 1e-7);
        const Eigen::VectorXd change = tensions_of(moved_net, net.unstressed_lengths(), f.form) -
                                       tensions_of(net, net.unstressed_lengths(), e.form);
        RC_ASSERT(change.norm() <= 1e-6 * (1.0 + e.mean_tension));
    }
}

RC_GTEST_PROP(EquilibriumOfARandomNet, DoesNotDependOnTheOrderOfNodesAndEdges, ()) {
    test::Random random = test::any_random();
    const CableNetData data = test::random_net_data(random);
    const CableNet net(data);
    std::vector<int> node_from;
    const CableNetData renumbered = test::renumbered(random, data, node_from);
    std::vector<int> edge_from = test::all_edges(net);
    std::ranges::shuffle(edge_from, random);

    CableNetData other = renumbered;
    other.axial_stiffness = data.axial_stiffness(edge_from);
    other.unstressed_lengths = data.unstressed_lengths(edge_from);
    other.adjustable.clear();
    for (size_t e = 0; e < edge_from.size(); ++e) {
        const auto [s, t] = renumbered.edges[edge_from[e]];
        other.edges[e] = {t, s};
    }
    const CableNet other_net(std::move(other));

    const Equilibrium e = solve_equilibrium(net);
    const Equilibrium f = solve_equilibrium(other_net);
    RC_ASSERT(f.status == e.status);
    if (e.status == EquilibriumStatus::converged) {
        RC_ASSERT((f.form - Points(e.form(Eigen::all, node_from))).norm() < 1e-7);
    }
}

}  // namespace
}  // namespace taut
