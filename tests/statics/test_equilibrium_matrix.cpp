// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a rank that a sparse factor gets wrong, and against columns in another order than
// the edges asked for.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/QR>
#include <Eigen/SVD>

#include "statics/self_stress.hpp"
#include "support/random_nets.hpp"
#include "support/small_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/equilibrium_matrix.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using test::all_edges;

/// Singular values of at least 1e-5, by a dense decomposition.
int dense_rank(const Eigen::SparseMatrix<double>& matrix) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(Eigen::MatrixXd(matrix), 0);
    return static_cast<int>((svd.singularValues().array() >= 1e-5).count());
}

TEST(EquilibriumMatrix, TimesTheTensionsIsTheForceAtTheNodes) {
    const CableNet net(test::two_node_net_data());
    const Eigen::VectorXd tension = tensions_of(net, net.unstressed_lengths(), net.nodes());
    const std::vector<int> order = {4, 2, 0, 1, 3};
    const Eigen::VectorXd forces =
        equilibrium_matrix(net, net.nodes(), order) * Eigen::VectorXd(tension(order));
    const Eigen::VectorXd expected =
        out_of_balance_forces(net, net.unstressed_lengths(), net.nodes()) +
        free_coordinates(net, net.loads());
    EXPECT_LT((forces - expected).norm(), 1e-9);
}

TEST(EquilibriumMatrix, RefusesEdgesThatAreNotInTheNetOrHaveNoLength) {
    const CableNet net(test::cross_data(0.02));
    EXPECT_THROW(static_cast<void>(equilibrium_matrix(net, net.nodes(), std::vector{0, 4})),
                 std::invalid_argument);
    Points form = net.nodes();
    form.col(0) = form.col(1);
    EXPECT_THROW(static_cast<void>(equilibrium_matrix(net, form, all_edges(net))),
                 std::invalid_argument);
}

TEST(StressStates, OfACrossAreThoseOfItsTautEdges) {
    // Two lines through one node: each can be tensioned by itself; the node moves freely out of the
    // plane.
    const CableNet net(test::cross_data(0.02));
    const StressStates s = stress_states(net, net.unstressed_lengths(), net.nodes());
    EXPECT_EQ(s.rank, 2);
    EXPECT_EQ(s.self_stress, 2);
    EXPECT_EQ(s.mechanisms, 1);
    Eigen::VectorXd lengths = net.unstressed_lengths();
    lengths(0) = 1.5;
    const StressStates with_slack = stress_states(net, lengths, net.nodes());
    EXPECT_EQ(with_slack.rank, 2);
    EXPECT_EQ(with_slack.self_stress, 1);
    const StressStates none = stress_states(net, Eigen::VectorXd::Constant(4, 2.0), net.nodes());
    EXPECT_EQ(none.rank, 0);
    EXPECT_EQ(none.self_stress, 0);
    EXPECT_EQ(none.mechanisms, 3);
}

TEST(StressStates, OfTheBuiltInNetsAreThoseOfADenseDecomposition) {
    for (const auto* name : {"hilo-quarter", "hypar:8x10"}) {
        const CableNet net = builtin_net(name);
        const Equilibrium e = solve_equilibrium(net);
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(
            Eigen::MatrixXd(equilibrium_matrix(net, e.form, all_edges(net))));
        qr.setThreshold(1e-5);
        const auto rank = static_cast<int>(qr.rank());
        const StressStates s = stress_states(net, net.unstressed_lengths(), e.form);
        EXPECT_EQ(s.rank, rank) << name;
        EXPECT_EQ(s.self_stress, net.edge_count() - rank) << name;
        EXPECT_EQ(s.mechanisms, 3 * net.free_node_count() - rank) << name;
    }
}

TEST(SelfStress, IsABasisOfTensionsThatBalance) {
    const CableNet net = hypar(8, 10);
    const auto A = equilibrium_matrix(net, solve_equilibrium(net).form, all_edges(net));
    const SelfStress self_stress(A);
    const Eigen::MatrixXd basis = self_stress.basis();
    ASSERT_EQ(basis.cols(), self_stress.count());
    ASSERT_GT(basis.cols(), 1);
    EXPECT_LT((A * basis).norm(), 1e-7);
    EXPECT_LT(
        (basis.transpose() * basis - Eigen::MatrixXd::Identity(basis.cols(), basis.cols())).norm(),
        1e-12);
}

RC_GTEST_PROP(StressStatesOfARandomNet, AreThoseOfADenseDecomposition, ()) {
    test::Random random = test::any_random();
    const CableNet net = test::random_net(random);
    const auto A = equilibrium_matrix(net, net.nodes(), all_edges(net));
    RC_ASSERT(SelfStress(A).count() == net.edge_count() - dense_rank(A));
}

}  // namespace
}  // namespace taut
