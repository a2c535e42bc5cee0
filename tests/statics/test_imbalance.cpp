// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against tensions at a form whose nodes do not balance.
#include "taut/statics/imbalance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/small_nets.hpp"

namespace taut {
namespace {

TEST(Imbalance, IsTheLargestNodalForceAndTheMeanTensionOfTheTautEdges) {
    CableNetData data = test::cross_data(0.01);
    data.loads = Points::Zero(3, 5);
    data.loads.col(0) << 30.0, 0.0, -40.0;
    data.unstressed_lengths(3) = 1.25;  // slack
    const CableNet net(std::move(data));
    const Imbalance found = imbalance_of(net, net.unstressed_lengths(), net.nodes());
    // Three edges of 1 kN, of which the one along y has none opposite.
    EXPECT_NEAR(found.mean_tension, 1000.0, 1e-6);
    EXPECT_NEAR(found.largest, std::hypot(30.0, 1000.0, 40.0), 1e-6);
    EXPECT_NEAR(found.share(), found.largest / 1000.0, 1e-9);
}

TEST(Imbalance, HasNoShareOfATensionThatIsNotThere) {
    EXPECT_EQ((Imbalance{.largest = 0.0, .mean_tension = 0.0}).share(), 0.0);
    EXPECT_TRUE(std::isinf((Imbalance{.largest = 1.0, .mean_tension = 0.0}).share()));
}

}  // namespace
}  // namespace taut
