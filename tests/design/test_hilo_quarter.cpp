// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a built-in net with other counts than the paper's, or another shape than the roof:
// the whole study depends on it.
#include <gmock/gmock.h>
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
    EXPECT_EQ(net.adjustable_edges(), edges_at_supports(net.edges(), net.supports()));
    for (int node = 0; node < net.node_count(); ++node) {
        EXPECT_EQ(net.edges_at(node).size(), net.free_index(node) >= 0 ? 4U : 1U) << node;
    }
}

TEST(HiloQuarter, IsInEquilibriumAtSomeTwoPercentOfStrain) {
    const CableNet net = hilo_quarter();
    EXPECT_LT(imbalance_of(net, net.unstressed_lengths(), net.nodes()).share(), 1e-10);
    const Eigen::ArrayXd strain =
        edge_lengths(net, net.nodes()).array() / net.unstressed_lengths().array() - 1.0;
    EXPECT_GT(strain.minCoeff(), 0.01);
    EXPECT_LT(strain.maxCoeff(), 0.05);
    EXPECT_NEAR(strain.mean(), 0.022, 0.001);
}

TEST(HiloQuarter, LiesInItsRectangleBetweenGroundAndRoof) {
    const Points nodes = hilo_quarter().nodes();
    EXPECT_GE(nodes.minCoeff(), -1e-12);
    EXPECT_LE(nodes.row(0).maxCoeff(), length + 1e-12);
    EXPECT_LE(nodes.row(1).maxCoeff(), width + 1e-12);
    EXPECT_LE(nodes.row(2).maxCoeff(), 1.0);
}

TEST(HiloQuarter, HasSupportsOnTheGroundAtFivePlacesAndElseAtRoofHeight) {
    const CableNet net = hilo_quarter();
    std::array<double, 5> lowest{};
    lowest.fill(1.0);
    int on_rectangle = 0;
    for (const int support : net.supports()) {
        const Eigen::Vector3d point = net.nodes().col(support);
        const auto circle = std::ranges::find_if(circles, [&](auto& c) { return is_in(c, point); });
        if (circle == circles.end()) {
            ++on_rectangle;
            EXPECT_EQ(point.z(), 1.0) << "support " << support;
        } else {
            double& height = lowest[circle - circles.begin()];
            height = std::min(height, point.z());
        }
    }
    EXPECT_GT(on_rectangle, 30);
    EXPECT_THAT(lowest, testing::Each(testing::Lt(0.02)));
}

}  // namespace
}  // namespace taut
