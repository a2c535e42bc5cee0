// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against edges under pressure, and against slack edges other than those without tension.
#include "taut/statics/tensions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/random_nets.hpp"
#include "support/small_nets.hpp"

namespace taut {
namespace {

using ::testing::ElementsAre;

/// The cross with its node moved by 0.25 m along x, l_0 = 0.8 m.
struct MovedCross {
    CableNet net{test::cross_data(0.25)};
    Points form = net.nodes();

    MovedCross() { form(0, 0) = 0.25; }
};

TEST(EdgeLengths, AreTheDistancesOfTheEnds) {
    const MovedCross cross;
    const double across = std::sqrt(1.0 + 0.25 * 0.25);
    EXPECT_TRUE(edge_lengths(cross.net, cross.form)
                    .isApprox(Eigen::Vector4d(0.75, 1.25, across, across), 1e-15));
}

TEST(Tensions, AreStiffnessTimesStrainAndZeroInSlackEdges) {
    const MovedCross cross;
    const Eigen::VectorXd result =
        tensions_of(cross.net, cross.net.unstressed_lengths(), cross.form);
    EXPECT_EQ(result(0), 0.0);
    EXPECT_NEAR(result(1), 100e3 * (1.25 / 0.8 - 1.0), 1e-9);
    EXPECT_NEAR(result(2), 100e3 * (std::sqrt(1.0625) / 0.8 - 1.0), 1e-9);
    EXPECT_EQ(result(2), result(3));
}

TEST(Tensions, AreZeroInAnEdgeExactlyAsLongAsUnstressed) {
    const CableNet net(test::cross_data(0.0));
    EXPECT_TRUE(tensions_of(net, net.unstressed_lengths(), net.nodes()).isZero(0.0));
    EXPECT_THAT(slack_edges(net, net.unstressed_lengths(), net.nodes()), ElementsAre(0, 1, 2, 3));
}

RC_GTEST_PROP(Tensions, AreNeverNegativeAndZeroInSlackEdgesAlone, ()) {
    test::Random random = test::any_random();
    const CableNet net = test::random_net(random);
    const Points form = test::uniform_points(random, net.node_count(), 2.0);
    const Eigen::VectorXd result = tensions_of(net, net.unstressed_lengths(), form);
    std::vector<int> without_tension;
    for (int e = 0; e < net.edge_count(); ++e) {
        RC_ASSERT(result(e) >= 0.0);
        if (result(e) == 0.0) {
            without_tension.push_back(e);
        }
    }
    RC_ASSERT(slack_edges(net, net.unstressed_lengths(), form) == without_tension);
}

}  // namespace
}  // namespace taut
