// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a built-in net that no longer is the paper's in its counts, or no longer looks
// like the roof: the whole study rests on it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "support/balance.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

constexpr double length = 4.26;
constexpr double width = 1.96;

struct Circle {
    Eigen::Vector2d centre;
    double radius;
};

/// The five touch-downs.
const std::array<Circle, 5> circles{{{{0.55 * length, 0.0}, 0.66},
                                     {{0.27 * length, width}, 0.66 * 0.8},
                                     {{0.70 * length, width}, 0.66 * 0.8},
                                     {{0.0, 0.40 * width}, 0.66 * 0.85},
                                     {{length, 0.62 * width}, 0.66 * 0.9}}};

bool is_in(const Circle& circle, const Eigen::Vector3d& point) {
    return (point.head<2>() - circle.centre).norm() <= circle.radius + 1e-9;
}

TEST(HiloQuarter, HasTheCountsOfThePrototype) {
    const CableNet net = hilo_quarter();
    EXPECT_EQ(net.name(), "hilo-quarter");
    EXPECT_EQ(net.free_node_count(), 300);
    EXPECT_EQ(net.interior_edge_count(), 536);
    EXPECT_EQ(net.adjustable_edges().size(), 128);
    EXPECT_EQ(net.supports().size(), 128);
}

TEST(HiloQuarter, AdjustsTheEdgesAtItsSupports) {
    const CableNet net = hilo_quarter();
    EXPECT_EQ(net.adjustable_edges(), edges_at_supports(net.edges(), net.supports()));
}

TEST(HiloQuarter, HasFourEdgesAtEveryFreeNode) {
    const CableNet net = hilo_quarter();
    Eigen::VectorXi degree = Eigen::VectorXi::Zero(net.node_count());
    for (const auto& [s, t] : net.edges()) {
        ++degree(s);
        ++degree(t);
    }
    for (const int node : net.free_nodes()) {
        EXPECT_EQ(degree(node), 4) << "node " << node;
    }
    for (const int support : net.supports()) {
        EXPECT_EQ(degree(support), 1) << "support " << support;
    }
}

TEST(HiloQuarter, IsInEquilibrium) {
    const CableNet net = hilo_quarter();
    EXPECT_LT(test::largest_imbalance(net, net.unstressed_lengths(), net.nodes()),
              1e-10 * test::mean_tension(net, net.unstressed_lengths(), net.nodes()));
}

TEST(HiloQuarter, IsTautEverywhereAtSomeTwoPercentOfStrain) {
    const CableNet net = hilo_quarter();
    const Eigen::ArrayXd strain =
        edge_lengths(net, net.nodes()).array() / net.unstressed_lengths().array() - 1.0;
    EXPECT_GT(strain.minCoeff(), 0.01);
    EXPECT_LT(strain.maxCoeff(), 0.05);
    EXPECT_NEAR(strain.mean(), 0.022, 0.001);
}

TEST(HiloQuarter, LiesInItsRectangleBetweenGroundAndRoof) {
    const Points nodes = hilo_quarter().nodes();
    EXPECT_GE(nodes.row(0).minCoeff(), -1e-12);
    EXPECT_LE(nodes.row(0).maxCoeff(), length + 1e-12);
    EXPECT_GE(nodes.row(1).minCoeff(), -1e-12);
    EXPECT_LE(nodes.row(1).maxCoeff(), width + 1e-12);
    EXPECT_GE(nodes.row(2).minCoeff(), 0.0);
    EXPECT_LE(nodes.row(2).maxCoeff(), 1.0);
}

TEST(HiloQuarter, TouchesTheGroundAtFivePlaces) {
    const CableNet net = hilo_quarter();
    for (const Circle& circle : circles) {
        double lowest = 1.0;
        for (const int support : net.supports()) {
            if (is_in(circle, net.nodes().col(support))) {
                lowest = std::min(lowest, net.nodes()(2, support));
            }
        }
        EXPECT_LT(lowest, 0.02) << "around " << circle.centre.transpose();
    }
}

TEST(HiloQuarter, HasSupportsOnTheRectangleAtRoofHeight) {
    const CableNet net = hilo_quarter();
    int on_rectangle = 0;
    for (const int support : net.supports()) {
        const Eigen::Vector3d point = net.nodes().col(support);
        if (std::ranges::none_of(circles, [&](const Circle& c) { return is_in(c, point); })) {
            ++on_rectangle;
            EXPECT_EQ(point.z(), 1.0) << "support " << support;
        }
    }
    EXPECT_GT(on_rectangle, 30);
}

}  // namespace
}  // namespace taut
