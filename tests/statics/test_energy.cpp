// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against an energy that is not that of its formula, or not convex. Its derivatives:
// test_tension_laws.cpp.
#include "taut/statics/energy.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/random_nets.hpp"
#include "support/small_nets.hpp"

namespace taut {
namespace {

TEST(Energy, IsThatComputedByHand) {
    // Node 0 in the middle of four edges of l_0 = 1 / 1.25 = 0.8 m, then moved 0.75 m upwards, so
    // that all are 1.25 m long: 4 * 100 kN / (2 * 0.8 m) * (0.45 m)^2 - 200 N * 0.75 m.
    CableNetData data = test::cross_data(0.25);
    data.loads = Points::Zero(3, 5);
    data.loads(2, 0) = 200.0;
    data.loads(2, 1) = 1e6;  // on a support: does no work
    const CableNet net(std::move(data));
    Points form = net.nodes();
    EXPECT_DOUBLE_EQ(potential_energy(net, net.unstressed_lengths(), form), 4.0 * 62.5e3 * 0.04);
    form(2, 0) = 0.75;
    EXPECT_DOUBLE_EQ(potential_energy(net, net.unstressed_lengths(), form),
                     4.0 * 62.5e3 * 0.2025 - 150.0);
    // 4 edges of 100 kN * (1.25 / 0.8 - 1), inclined by 0.75 / 1.25.
    const Eigen::Vector3d forces = out_of_balance_forces(net, net.unstressed_lengths(), form);
    EXPECT_TRUE(forces.isApprox(Eigen::Vector3d(0.0, 0.0, 4.0 * 56.25e3 * 0.6 - 200.0), 1e-14));
}

RC_GTEST_PROP(Energy, IsConvex, ()) {
    test::Random random = test::any_random();
    const CableNet net = test::random_net(random);
    const Points a = test::uniform_points(random, net.node_count(), 3.0);
    const Points b = test::uniform_points(random, net.node_count(), 3.0);
    // Supports move along, too: V is convex in all coordinates.
    const double s = test::uniform(random, 0.0, 1.0);
    const double v_a = potential_energy(net, net.unstressed_lengths(), a);
    const double v_b = potential_energy(net, net.unstressed_lengths(), b);
    const double between = potential_energy(net, net.unstressed_lengths(), (1.0 - s) * a + s * b);
    RC_ASSERT(between <= (1.0 - s) * v_a + s * v_b + 1e-12 * (std::abs(v_a) + std::abs(v_b)));
}

}  // namespace
}  // namespace taut
