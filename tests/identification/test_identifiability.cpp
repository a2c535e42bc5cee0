// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against lengths that a form does not contain: slack edges, and edges whose tension
// another edge can take over without any node moving.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "support/small_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identifiability.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/equilibrium_matrix.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Singular values of B = A_I diag(EA l), by a dense decomposition.
Eigen::VectorXd singular_values(const CableNet& net, const Points& form,
                                const std::vector<int>& edges) {
    const Eigen::VectorXd length = edge_lengths(net, form);
    Eigen::MatrixXd B(equilibrium_matrix(net, form, edges));
    for (size_t k = 0; k < edges.size(); ++k) {
        B.col(static_cast<Eigen::Index>(k)) *= net.axial_stiffness()(edges[k]) * length(edges[k]);
    }
    return Eigen::JacobiSVD<Eigen::MatrixXd>(B, 0).singularValues();
}

TEST(Identifiability, OfABuiltInNetIsWholeAndConditionedAsByADenseDecomposition) {
    const CableNet net = hypar(6, 7);
    const Equilibrium e = solve_equilibrium(net);
    const Identifiability i = identifiability(net, net.unstressed_lengths(), e.form);
    EXPECT_EQ(i.determined, net.interior_edges());
    EXPECT_THAT(i.undetermined, IsEmpty());
    EXPECT_THAT(i.slack, IsEmpty());
    EXPECT_EQ(i.free_self_stress, 0);
    const Eigen::VectorXd values = singular_values(net, e.form, net.interior_edges());
    EXPECT_NEAR(i.largest_singular_value, values.maxCoeff(), 1e-3 * values.maxCoeff());
    EXPECT_NEAR(i.smallest_singular_value, values.minCoeff(), 1e-3 * values.minCoeff());
    EXPECT_DOUBLE_EQ(i.condition(), i.largest_singular_value / i.smallest_singular_value);
}

TEST(Identifiability, LacksEdgesInAFreeSelfStressAndKeepsTheOthers) {
    // Of two crossed lines each can be tighter at will, with the same form. With the length of edge
    // 0 known, so is edge 1, and the other line stays free.
    CableNetData data = test::cross_data(0.02);
    data.adjustable = {0};
    const CableNet net(std::move(data));
    const Identifiability i = identifiability(net, net.unstressed_lengths(), net.nodes());
    EXPECT_THAT(i.determined, ElementsAre(1));
    EXPECT_THAT(i.undetermined, ElementsAre(2, 3));
    EXPECT_EQ(i.free_self_stress, 1);
    // The determined one alone maps 1/l_0 to a force of EA l along x.
    EXPECT_NEAR(i.largest_singular_value, 100e3, 1e-2);
    EXPECT_NEAR(i.smallest_singular_value, 100e3, 1e-2);
}

TEST(Identifiability, LacksSlackEdges) {
    CableNetData data = test::cross_data(0.02);
    data.unstressed_lengths(2) = 1.5;
    data.unstressed_lengths(3) = 1.5;
    data.adjustable = {0};
    const CableNet net(std::move(data));
    const Identifiability i = identifiability(net, net.unstressed_lengths(), net.nodes());
    EXPECT_THAT(i.determined, ElementsAre(1));
    EXPECT_THAT(i.undetermined, IsEmpty());
    EXPECT_THAT(i.slack, ElementsAre(2, 3));
}

TEST(Identifiability, OfANetWithoutInteriorEdgesIsEmpty) {
    const CableNet net(test::cross_data(0.02));
    const Identifiability i = identifiability(net, net.unstressed_lengths(), net.nodes());
    EXPECT_THAT(i.determined, IsEmpty());
    EXPECT_EQ(i.condition(), 0.0);
}

}  // namespace
}  // namespace taut
