// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against solutions and pivots other than those of the dense matrix, and against loose nodes
// that are not found.
#include "statics/stiffness_factor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Dense>

#include "statics/net_state.hpp"
#include "support/random_nets.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

/// The stiffness of a net at its nominal form, with the nodes in the order of elimination.
Stiffness stiffness_of(const CableNet& net, double shift) {
    const LocalNet local = number_for_elimination(net);
    NetState state(local);
    state.set_unstressed_lengths(local, net.unstressed_lengths());
    state.update(local);
    Stiffness result(local);
    result.matrix.assemble(local, state.edges());
    result.matrix.add_shift(shift);
    return result;
}

void expect_that_it_solves(const Stiffness& s) {
    const Eigen::SparseMatrix<double> matrix = s.matrix.to_sparse();
    test::Random random(1);
    const Eigen::VectorXd x = test::uniform_vector(random, matrix.rows(), 1.0);
    Eigen::VectorXd found = matrix * x;
    s.factor.solve(found);
    EXPECT_LT((found - x).norm(), 1e-9 * x.norm());
}

RC_GTEST_PROP(StiffnessFactorOfARandomNet, HasTheDeterminantAndTheSolutionsOfADenseOne, ()) {
    test::Random random = test::any_random();
    Stiffness s = stiffness_of(test::random_net(random), 1e-3);
    RC_ASSERT(s.factorize());
    const Eigen::MatrixXd dense = s.matrix.to_sparse();
    const Eigen::VectorXd diagonal = dense.llt().matrixLLT().diagonal();
    RC_ASSERT(std::abs(s.factor.pivots().array().log().sum() - 2.0 * diagonal.array().log().sum()) <
              1e-9);
    const Eigen::VectorXd x = test::uniform_vector(random, dense.rows(), 1.0);
    Eigen::VectorXd found = dense * x;
    s.factor.solve(found);
    RC_ASSERT((found - x).norm() < 1e-8 * x.norm());
}

// A small net, and a large one, which uses another factor.
class OnNetsOfEachSize : public testing::TestWithParam<int> {
protected:
    CableNet m_net = hypar(GetParam(), 100);
};

INSTANTIATE_TEST_SUITE_P(StiffnessFactor, OnNetsOfEachSize, testing::Values(2, 51));

TEST_P(OnNetsOfEachSize, RefusesAMatrixThatIsNotPositiveDefiniteAndFactorisesTheNextOne) {
    Stiffness s = stiffness_of(m_net, 0.0);
    s.matrix.add_shift(-0.5);
    EXPECT_FALSE(s.factorize());
    EXPECT_FALSE(s.factor.positive_definite());
    EXPECT_TRUE(s.has_loose_nodes());
    s.matrix.add_shift(0.5);
    ASSERT_TRUE(s.factorize());
    EXPECT_FALSE(s.has_loose_nodes());
    expect_that_it_solves(s);
}

TEST_P(OnNetsOfEachSize, FindsNodesThatHangOnSlackEdges) {
    CableNetData data = m_net.data();
    data.unstressed_lengths *= 1.2;
    Stiffness s = stiffness_of(CableNet(std::move(data)), 0.0);
    EXPECT_FALSE(s.factorize());
    EXPECT_TRUE(s.has_loose_nodes());
    s.matrix.add_shift(1e-14);
    EXPECT_TRUE(s.factorize());
    EXPECT_TRUE(s.has_loose_nodes());
}

TEST_P(OnNetsOfEachSize, HasThePivotsOfTheOtherFactor) {
    Stiffness s = stiffness_of(m_net, 0.0);
    ASSERT_TRUE(s.factorize());
    NodalFactor nodal(s.matrix);
    ASSERT_TRUE(nodal.factorize(s.matrix));
    // The order of elimination is the same along each branch of the tree, and so are the pivots.
    EXPECT_LT((s.factor.pivots() - nodal.pivots()).cwiseAbs().maxCoeff(),
              1e-9 * nodal.pivots().maxCoeff());
}

}  // namespace
}  // namespace taut
