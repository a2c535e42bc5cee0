// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against forms that do not balance, and against forms made of rounding errors for nets that
// have none.
#include "taut/design/force_density.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <vector>

#include "support/not_finite.hpp"
#include "support/random_nets.hpp"

namespace taut {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Node 1 between the supports 0 and 2, node 3 between 1 and 2.
struct Chain {
    Points nodes = Points::Zero(3, 4);
    std::vector<int> supports{0, 2};
    std::vector<Edge> edges{{0, 1}, {1, 3}, {3, 2}};
    Eigen::VectorXd force_densities{{1.0, 2.0, 2.0}};
    Points loads{3, 0};

    Chain() {
        nodes.col(0) << 1.0, 0.0, 2.0;
        nodes.col(2) << 5.0, 8.0, 2.0;
        nodes.col(1) << 77.0, 77.0, 77.0;  // of a free node: not used
    }
    [[nodiscard]] Points form() const {
        return form_from_force_densities(nodes, supports, edges, force_densities, loads);
    }
};

TEST(ForceDensities, GiveTheFormUnderLoadsComputedByHand) {
    // 3 r1 - 2 r3 = r0 + p and -2 r1 + 4 r3 = 2 r2 with p at node 1: r1 = (r0 + r2) / 2 + p / 2,
    // r3 = r0 / 4 + 3 r2 / 4 + p / 4.
    Chain chain;
    chain.loads = Points::Zero(3, 4);
    chain.loads.col(1) << 0.0, 0.4, -2.0;
    chain.loads.col(0) << 9.0, 9.0, 9.0;  // on a support: carried by the frame
    const Points form = chain.form();
    EXPECT_TRUE(form.col(1).isApprox(Eigen::Vector3d(3.0, 4.2, 1.0), 1e-14));
    EXPECT_TRUE(form.col(3).isApprox(Eigen::Vector3d(4.0, 6.1, 1.5), 1e-14));
}

RC_GTEST_PROP(ForceDensities, BalanceAtEveryFreeNode, ()) {
    test::Random random = test::any_random();
    CableNetData data = test::random_net_data(random);
    if (data.loads.cols() == 0) {
        data.loads = Points::Zero(3, data.nodes.cols());
    }
    const auto m = static_cast<Eigen::Index>(data.edges.size());
    const Eigen::VectorXd q = test::uniform_vector(random, m, 1.0).array() * 900.0 + 1000.0;
    const Points form =
        form_from_force_densities(data.nodes, data.supports, data.edges, q, data.loads);
    Points forces = -data.loads;
    for (Eigen::Index e = 0; e < m; ++e) {
        const auto [s, t] = data.edges[e];
        const Eigen::Vector3d force = q(e) * (form.col(s) - form.col(t));
        forces.col(s) += force;
        forces.col(t) -= force;
    }
    for (Eigen::Index node = 0; node < data.nodes.cols(); ++node) {
        if (std::ranges::find(data.supports, node) == data.supports.end()) {
            RC_ASSERT(forces.col(node).norm() < 1e-9);
        } else {
            RC_ASSERT(form.col(node) == data.nodes.col(node));
        }
    }
}

TEST(ForceDensities, LeaveANetOfSupportsAsItIs) {
    Chain chain;
    chain.supports = {0, 1, 2, 3};
    EXPECT_EQ(chain.form(), chain.nodes);
}

TEST(ForceDensities, IgnoreTheCoordinatesOfFreeNodes) {
    Chain chain;
    chain.nodes.col(1).setConstant(test::nan);
    EXPECT_TRUE(chain.form().allFinite());
}

TEST(ForceDensities, RefuseWrongSizesAndValuesAndNodesWithoutSupport) {
    struct Case {
        std::function<void(Chain&)> change;
        std::vector<const char*> words;
    };
    const std::vector<Case> cases{
        {[](Chain& c) { c.force_densities.setOnes(2); }, {"2 entries", "expected 3"}},
        {[](Chain& c) { c.loads.setZero(3, 3); }, {"3 columns", "expected 4"}},
        {[](Chain& c) { c.force_densities(1) = 0.0; }, {"is 0", "positive and finite"}},
        {[](Chain& c) { c.force_densities(1) = -1.0; }, {"is -1", "positive and finite"}},
        {[](Chain& c) { c.force_densities(1) = test::nan; }, {"is nan", "positive and finite"}},
        {[](Chain& c) { c.force_densities(1) = test::infinity; },
         {"is inf", "positive and finite"}},
        {[](Chain& c) { c.nodes(2, 2) = test::nan; }, {"(5, 8, nan) at support 2", "finite"}},
        {[](Chain& c) { c.loads.setConstant(3, 4, test::nan); }, {"loads", "not finite"}},
        {[](Chain& c) { c.supports[1] = 4; }, {"supports", "node 4"}},
        {[](Chain& c) { c.supports[0] = -1; }, {"supports", "node -1"}},
        {[](Chain& c) { c.edges[2] = {3, 4}; }, {"edges", "node 4"}},
        {[](Chain& c) { c.edges[0] = {-2, 1}; }, {"edges", "node -2"}},
        {[](Chain& c) { c.edges = {{0, 1}, {1, 2}, {2, 0}}; }, {"free node 3", "no support"}},
        // A triangle without support and with force densities in tenths: rounding errors remain
        // where its pivots cancel.
        {[](Chain& c) {
             c.nodes = Points::Zero(3, 6);
             c.edges = {{0, 1}, {1, 2}, {3, 4}, {4, 5}, {5, 3}};
             c.force_densities = Eigen::VectorXd{{1.0, 1.0, 0.1, 0.2, 0.7}};
         },
         {"free node 3"}}};
    for (const auto& [change, words] : cases) {
        Chain chain;
        change(chain);
        for (const char* word : words) {
            EXPECT_THAT([&] { (void)chain.form(); },
                        ThrowsMessage<std::invalid_argument>(HasSubstr(word)));
        }
    }
}

}  // namespace
}  // namespace taut
