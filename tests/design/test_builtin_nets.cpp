// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against names that give another net, and against names that are read in part
// ("hypar:3x4x5").
#include "taut/design/builtin_nets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "support/balance.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Hypar, IsAGridWithASupportAtBothEndsOfEveryLineAndInEquilibrium) {
    for (const auto& [rows, columns] :
         {std::pair{1, 1}, {1, 4}, {3, 1}, {2, 3}, {7, 5}, {40, 30}}) {
        const CableNet net = hypar(rows, columns);
        SCOPED_TRACE(net.name());
        EXPECT_EQ(net.name(), "hypar:" + std::to_string(rows) + "x" + std::to_string(columns));
        EXPECT_EQ(net.free_node_count(), rows * columns);
        EXPECT_EQ(net.supports().size(), 2 * (rows + columns));
        EXPECT_EQ(net.interior_edge_count(), rows * (columns - 1) + columns * (rows - 1));
        EXPECT_EQ(net.adjustable_edges(), edges_at_supports(net.edges(), net.supports()));
        EXPECT_EQ(net.adjustable_edges().size(), 2 * (rows + columns));
        EXPECT_TRUE(slack_edges(net, net.unstressed_lengths(), net.nodes()).empty());
        EXPECT_LT(imbalance_of(net, net.unstressed_lengths(), net.nodes()).share(), 1e-10);
    }
}

TEST(SteelRoof, IsTautAndInEquilibriumUnderItsLoads) {
    const CableNet net = builtin_net("steel-roof");
    EXPECT_TRUE(slack_edges(net, net.unstressed_lengths(), net.nodes()).empty());
    EXPECT_LT(imbalance_of(net, net.unstressed_lengths(), net.nodes()).share(), 1e-10);
    EXPECT_FALSE(net.is_linear());
    EXPECT_EQ(net.data().groups.at("carrying").size() + net.data().groups.at("bracing").size(),
              static_cast<size_t>(net.edge_count()));
    // Cladding of 1.2 kN a node, and the weight of the strands.
    const double cladding = 1200.0 * net.free_node_count();
    const double weight = -net.loads()(2, net.free_nodes()).sum();
    EXPECT_GT(weight, 1.02 * cladding);
    EXPECT_LT(weight, 1.1 * cladding);
}

TEST(SteelRoof, HasStrandsOnBothSlopesOfTheirLaws) {
    const CableNet net = builtin_net("steel-roof");
    const Eigen::ArrayXd strains =
        edge_lengths(net, net.nodes()).array() / net.unstressed_lengths().array() - 1.0;
    EXPECT_GT((strains < 0.0022).count(), 20);
    EXPECT_GT((strains > 0.00286).count(), 20);
    const Eigen::ArrayXd stretch =
        edge_lengths(net, net.nodes()).array() - net.unstressed_lengths().array();
    EXPECT_GT(stretch.minCoeff(), 0.002);
    EXPECT_LT(stretch.maxCoeff(), 0.02);
}

TEST(NetsWithStruts, AreInEquilibriumAndTautWithPressedStruts) {
    for (const char* const name : {"cable-dome", "spoke-wheel", "tensegrity-simplex"}) {
        const CableNet net = builtin_net(name);
        const Eigen::VectorXd tension = tensions_of(net, net.unstressed_lengths(), net.nodes());
        for (int e = 0; e < net.edge_count(); ++e) {
            EXPECT_EQ(tension(e) < 0.0, net.is_strut(e)) << name << ' ' << e;
        }
        EXPECT_LT(imbalance_of(net, net.unstressed_lengths(), net.nodes()).share(), 1e-10) << name;
        EXPECT_EQ(solve_equilibrium(net).status, EquilibriumStatus::converged) << name;
        EXPECT_EQ(net.name(), name);
    }
}

TEST(SlidingRidge, IsInEquilibriumWithoutSlidingAnyFurther) {
    const CableNet net = builtin_net("sliding-ridge");
    EXPECT_EQ(net.name(), "sliding-ridge");
    const Equilibrium e = solve_equilibrium(net);
    EXPECT_EQ(e.status, EquilibriumStatus::converged);
    EXPECT_LT((e.form - net.nodes()).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_LT((e.unstressed_lengths - net.unstressed_lengths()).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_TRUE(e.slack_edges.empty());
    EXPECT_EQ(net.sliding_nodes().size(), 7U);
}

TEST(TensegritySimplex, HasThePublishedSelfStress) {
    const CableNet net = tensegrity_simplex();
    const Eigen::VectorXd tension = tensions_of(net, net.unstressed_lengths(), net.nodes());
    const auto of = [&](const char* group) {
        return tension(net.data().groups.at(group).back()) / -tension(0);
    };
    EXPECT_NEAR(of("strut"), -1.0, 1e-9);
    EXPECT_NEAR(of("horizontal"), 0.393, 1e-3);
    EXPECT_NEAR(of("vertical"), 0.681, 1e-3);
}

TEST(Hypar, TakesItsLargestSize) {
    EXPECT_EQ(hypar(1000, 1).free_node_count(), 1000);
    EXPECT_EQ(hypar(1, 1000).free_node_count(), 1000);
}

TEST(Hypar, RefusesSizesOutOfRange) {
    for (const auto& [rows, columns] :
         {std::pair{0, 5}, {5, 0}, {1001, 5}, {5, 1001}, {-1, 5}, {5, -7}}) {
        const auto make = [r = rows, c = columns] { (void)hypar(r, c); };
        const std::string size = std::to_string(rows) + " x " + std::to_string(columns);
        EXPECT_THAT(make, ThrowsMessage<std::invalid_argument>(
                              AllOf(HasSubstr(size), HasSubstr("1 to 1000"))));
    }
}

TEST(Hypar, IsASaddleWithAlternatelyHighAndLowCorners) {
    const CableNet net = hypar(9, 9);
    // Near the four corners, by their place in plan: two diagonally opposite ones are the highest.
    const auto height_near = [&](double x, double y) {
        Eigen::Index nearest = 0;
        (net.nodes().topRows<2>().colwise() - Eigen::Vector2d(x, y))
            .colwise()
            .squaredNorm()
            .minCoeff(&nearest);
        return net.nodes()(2, nearest);
    };
    const double side = 10 * 0.132;
    const double middle = height_near(0.5 * side, 0.5 * side);
    EXPECT_GT(height_near(0.0, 0.0), middle + 0.05);
    EXPECT_GT(height_near(side, side), middle + 0.05);
    EXPECT_LT(height_near(0.0, side), middle - 0.05);
    EXPECT_LT(height_near(side, 0.0), middle - 0.05);
}

TEST(BuiltinNet, GivesTheNetOfItsName) {
    EXPECT_EQ(builtin_net("hilo-quarter").fingerprint(), hilo_quarter().fingerprint());
    EXPECT_EQ(builtin_net("hypar:2x3").fingerprint(), hypar(2, 3).fingerprint());
    EXPECT_NE(builtin_net("hypar:3x2").fingerprint(), hypar(2, 3).fingerprint());
}

TEST(BuiltinNet, RefusesOtherNamesAndListsItsOwn) {
    for (const char* name :
         {"", "hilo", "hilo-quarter ", "HILO-QUARTER", "hypar", "hypar:", "hypar:3", "hypar:3x",
          "hypar:x3", "hypar:x", "hypar:-1x3", "hypar:3x-1", "hypar:+3x3", "hypar:3x4x5",
          "hypar:3 x4", "hypar:3.5x4", "hypar:3X4", "hypar:99999999999x3", "hypar:3x4\n"}) {
        EXPECT_THAT([&] { (void)builtin_net(name); },
                    ThrowsMessage<std::invalid_argument>(
                        AllOf(HasSubstr("'" + std::string(name) + "'"), HasSubstr("hilo-quarter"),
                              HasSubstr("hypar:RxC"))))
            << name;
    }
}

}  // namespace
}  // namespace taut
