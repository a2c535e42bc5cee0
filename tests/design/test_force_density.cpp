// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against forms that do not balance, and against nets for which no form exists being given
// one that is made of rounding errors.
#include "taut/design/force_density.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "support/random_nets.hpp"

namespace taut {
namespace {

using ::testing::AllOf;
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

TEST(ForceDensities, GiveTheFormComputedByHand) {
    // 3 r1 - 2 r3 = r0 and -2 r1 + 4 r3 = 2 r2: r1 = (r0 + r2) / 2, r3 = r0 / 4 + 3 r2 / 4.
    const Chain chain;
    const Points form = chain.form();
    EXPECT_TRUE(form.col(1).isApprox(Eigen::Vector3d(3.0, 4.0, 2.0), 1e-14));
    EXPECT_TRUE(form.col(3).isApprox(Eigen::Vector3d(4.0, 6.0, 2.0), 1e-14));
    EXPECT_EQ(form.col(0), chain.nodes.col(0));
    EXPECT_EQ(form.col(2), chain.nodes.col(2));
}

TEST(ForceDensities, GiveTheFormUnderLoadsComputedByHand) {
    // With p at node 1, solved as above: r1 = ... + p / 2 and r3 = ... + p / 4.
    Chain chain;
    chain.loads = Points::Zero(3, 4);
    chain.loads.col(1) << 0.0, 0.4, -2.0;
    chain.loads.col(0) << 9.0, 9.0, 9.0;  // on a support: goes into the frame
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

/// Breaks the chain in one way, and expects a refusal with words.
template <typename Break>
void expect_chain_refused(Break&& break_it, const char* word, const char* other) {
    Chain chain;
    break_it(chain);
    EXPECT_THAT([&] { (void)chain.form(); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(word), HasSubstr(other))));
}

TEST(ForceDensities, RefuseAnotherNumberThanOfEdges) {
    expect_chain_refused([](Chain& c) { c.force_densities.setOnes(2); }, "2 entries", "expected 3");
}

TEST(ForceDensities, RefuseAnotherNumberOfLoadsThanOfNodes) {
    expect_chain_refused([](Chain& c) { c.loads.setZero(3, 3); }, "3 columns", "expected 4");
}

TEST(ForceDensities, RefuseValuesThatAreNotPositiveAndFinite) {
    for (const auto& [value, text] : {std::pair{0.0, "is 0"},
                                      {-1.0, "is -1"},
                                      {std::numeric_limits<double>::quiet_NaN(), "is nan"},
                                      {std::numeric_limits<double>::infinity(), "is inf"}}) {
        expect_chain_refused([v = value](Chain& c) { c.force_densities(1) = v; }, text,
                             "positive and finite");
    }
}

TEST(ForceDensities, RefuseSupportsAndLoadsThatAreNotFinite) {
    static constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
    expect_chain_refused([](Chain& c) { c.nodes(2, 2) = not_a_number; }, "(5, 8, nan) at support 2",
                         "finite");
    expect_chain_refused([](Chain& c) { c.loads.setConstant(3, 4, not_a_number); }, "loads",
                         "not finite");
    Chain chain;
    chain.nodes.col(1).setConstant(not_a_number);  // of a free node: not used
    EXPECT_TRUE(chain.form().allFinite());
}

TEST(ForceDensities, RefuseNodesOutOfRange) {
    expect_chain_refused([](Chain& c) { c.supports[1] = 4; }, "supports", "node 4");
    expect_chain_refused([](Chain& c) { c.supports[0] = -1; }, "supports", "node -1");
    expect_chain_refused([](Chain& c) { c.edges[2] = {3, 4}; }, "edges", "node 4");
    expect_chain_refused([](Chain& c) { c.edges[0] = {-2, 1}; }, "edges", "node -2");
}

TEST(ForceDensities, RefuseAFreeNodeWithoutEdges) {
    expect_chain_refused([](Chain& c) { c.edges = {{0, 1}, {1, 2}, {2, 0}}; }, "free node 3",
                         "no support");
}

TEST(ForceDensities, RefuseAPartWithoutSupport) {
    // A triangle with force densities in tenths: its pivots cancel but for rounding errors.
    Chain chain;
    chain.nodes = Points::Zero(3, 6);
    chain.edges = {{0, 1}, {1, 2}, {3, 4}, {4, 5}, {5, 3}};
    chain.force_densities.resize(5);
    chain.force_densities << 1.0, 1.0, 0.1, 0.2, 0.7;
    EXPECT_THAT([&] { (void)chain.form(); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("free node 3")));
}

}  // namespace
}  // namespace taut
