// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against lists in another order than promised (free nodes, interior edges, coordinates):
// results are then consistent in themselves, and wrong for the net.
#include "taut/net/cable_net.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "support/random_nets.hpp"
#include "support/small_nets.hpp"

namespace taut {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

TEST(CableNet, ListsFreeNodesInAscendingOrder) {
    CableNetData data = test::two_node_net_data();
    data.supports = {5, 2, 4, 1};
    const CableNet net(std::move(data));
    EXPECT_THAT(net.free_nodes(), ElementsAre(0, 3));
    EXPECT_EQ(net.free_index(0), 0);
    EXPECT_EQ(net.free_index(3), 1);
    for (const int support : net.supports()) {
        EXPECT_EQ(net.free_index(support), -1);
    }
}

TEST(CableNet, ListsInteriorAndAdjustableEdgesInAscendingOrder) {
    CableNetData data = test::two_node_net_data();
    const CableNet net(data);
    EXPECT_THAT(net.adjustable_edges(), ElementsAre(0, 4));
    EXPECT_THAT(net.interior_edges(), ElementsAre(1, 2, 3));
    EXPECT_EQ(net.interior_index(0), -1);
    EXPECT_EQ(net.interior_index(1), 0);
    EXPECT_EQ(net.interior_index(3), 2);
    EXPECT_EQ(net.interior_index(4), -1);
    data.adjustable.clear();
    EXPECT_THAT(CableNet(std::move(data)).interior_edges(), ElementsAre(0, 1, 2, 3, 4));
}

TEST(CableNet, FillsInLoadsOfZero) {
    CableNetData data = test::two_node_net_data();
    data.loads.resize(3, 0);
    const CableNet net(std::move(data));
    EXPECT_EQ(net.loads(), Points::Zero(3, 6));
    EXPECT_EQ(net.data().loads, Points::Zero(3, 6));
}

// With the weight of the drawn lengths, a net that is not drawn in its form would sag too far.
TEST(CableNet, WeighsAsMuchAsItsUnstressedLengthsWhereverNodesAreDrawn) {
    CableNetData data = test::two_node_net_data();
    data.mass = Eigen::VectorXd::LinSpaced(5, 1.0, 3.0);
    const CableNet net(data);
    const Eigen::VectorXd weight = gravity * data.mass.cwiseProduct(data.unstressed_lengths);
    EXPECT_NEAR((data.loads - net.loads()).row(2).sum(), weight.sum(), 1e-9);
    EXPECT_NEAR(net.loads()(2, 3), -400.0 - 0.5 * (weight(2) + weight(3) + weight(4)), 1e-9);
    data.nodes.col(3).x() += 50.0;
    EXPECT_EQ(CableNet(std::move(data)).loads(), net.loads());
}

TEST(CableNet, SagsByItsMassesAcrossTheChordOfCablesWithoutATensionLaw) {
    CableNetData data = test::two_node_net_data();
    data.nodes.col(3).z() += 3.0;
    data.mass = Eigen::VectorXd::LinSpaced(5, 1.0, 3.0);
    const auto& [s, t] = data.edges[3];
    const Eigen::Vector3d chord = data.nodes.col(s) - data.nodes.col(t);
    EXPECT_NEAR(sag_weights_by_mass(data)(3), 2.5 * gravity * chord.head<2>().norm() / chord.norm(),
                1e-9);
    data.tension_law = {-1, -1, 0, -1, -1};
    data.kind.assign(5, EdgeKind::cable);
    data.kind[1] = EdgeKind::strut;
    EXPECT_EQ(sag_weights_by_mass(data)(1), 0.0);
    EXPECT_EQ(equal_sag_weights(data, 3.0), Eigen::VectorXd({{3.0, 0.0, 0.0, 3.0, 3.0}}));
    data.mass.resize(0);
    EXPECT_THROW((void)sag_weights_by_mass(data), std::invalid_argument);
}

TEST(CableNet, FindsNodesAndEdgesByTheirNames) {
    const CableNet net(test::two_node_net_data());
    EXPECT_EQ(net.node_id(3), "b");
    EXPECT_EQ(net.edge_id(4), "bD");
    for (int node = 0; node < net.node_count(); ++node) {
        EXPECT_EQ(net.find_node(net.node_id(node)), node);
    }
    for (int edge = 0; edge < net.edge_count(); ++edge) {
        EXPECT_EQ(net.find_edge(net.edge_id(edge)), edge);
    }
    for (const char* other : {"", "3", "aa", "z"}) {
        EXPECT_EQ(net.find_node(other), -1) << other;
        EXPECT_EQ(net.find_edge(other), -1) << other;
    }
}

TEST(CableNet, FindsNodesAndEdgesByIndexIfItHasNoNames) {
    CableNetData data = test::two_node_net_data();
    data.node_ids.clear();
    data.edge_ids.clear();
    const CableNet net(std::move(data));
    EXPECT_EQ(net.node_id(3), "3");
    EXPECT_EQ(net.edge_id(4), "4");
    EXPECT_EQ(net.find_node("3"), 3);
    EXPECT_EQ(net.find_edge("0"), 0);
    EXPECT_EQ(net.find_node("6"), -1);
    EXPECT_EQ(net.find_edge("5"), -1);
    for (const char* other : {"", "a", "-1", "+1", "01", "1 ", "1.0", "99999999999"}) {
        EXPECT_EQ(net.find_node(other), -1) << other;
    }
}

RC_GTEST_PROP(CableNet, ListsTheEdgesAndNeighboursOfEachNode, ()) {
    test::Random random = test::any_random();
    const CableNet net = test::random_net(random);
    for (int node = 0; node < net.node_count(); ++node) {
        std::vector<int> edges;
        std::vector<int> neighbours;
        for (int edge = 0; edge < net.edge_count(); ++edge) {
            const auto [s, t] = net.edges()[edge];
            if (s == node || t == node) {
                edges.push_back(edge);
                neighbours.push_back(s == node ? t : s);
            }
        }
        RC_ASSERT(std::ranges::equal(net.edges_at(node), edges));
        RC_ASSERT(std::ranges::equal(net.neighbours(node), neighbours));
    }
}

TEST(EdgesAtSupports, AreThoseWithASupportAtEitherEnd) {
    EXPECT_THAT(edges_at_supports({{0, 1}, {1, 2}, {2, 0}, {3, 1}}, {3, 0}), ElementsAre(0, 2, 3));
    EXPECT_THAT(edges_at_supports({{0, 1}, {1, 2}}, {}), IsEmpty());
}

TEST(CableNet, RefusesIndicesOutOfRange) {
    const CableNet net(test::two_node_net_data());
    for (const int node : {-1, net.node_count(), 100000}) {
        EXPECT_THROW((void)net.free_index(node), std::out_of_range) << node;
        EXPECT_THROW((void)net.node_id(node), std::out_of_range) << node;
        EXPECT_THROW((void)net.edges_at(node), std::out_of_range) << node;
        EXPECT_THROW((void)net.neighbours(node), std::out_of_range) << node;
    }
    for (const int edge : {-1, net.edge_count(), 100000}) {
        EXPECT_THROW((void)net.tension_law(edge), std::out_of_range) << edge;
        EXPECT_THROW((void)net.interior_index(edge), std::out_of_range) << edge;
        EXPECT_THROW((void)net.edge_id(edge), std::out_of_range) << edge;
    }
    EXPECT_THAT([&] { (void)net.free_index(100000); },
                ThrowsMessage<std::out_of_range>(HasSubstr("node 100000, expected 0 to")));
}

TEST(FreeCoordinates, AreThoseOfTheFreeNodesAndComeBackAsTheForm) {
    const CableNet net(test::two_node_net_data());
    const Eigen::VectorXd expected{{0.0, 0.0, 0.1, 1.0, 0.1, 0.2}};
    EXPECT_EQ(free_coordinates(net, net.nodes()), expected);
    const Eigen::VectorXd coordinates = Eigen::VectorXd::LinSpaced(6, 10.0, 15.0);
    Points form = net.nodes();
    form.col(0) << 10.0, 11.0, 12.0;
    form.col(3) << 13.0, 14.0, 15.0;
    EXPECT_EQ(with_free_coordinates(net, coordinates), form);
}

TEST(WithLengthDeviations, AddsThemToTheInteriorEdgesAlone) {
    const CableNet net(test::two_node_net_data());
    const Eigen::VectorXd deviations =
        with_length_deviations(net, Eigen::Vector3d(0.1, 0.2, 0.3)) - net.unstressed_lengths();
    EXPECT_TRUE(deviations.isApprox(Eigen::VectorXd{{0.0, 0.1, 0.2, 0.3, 0.0}}, 1e-14));
}

TEST(FreeCoordinatesAndDeviations, RefuseWrongSizes) {
    const CableNet net(test::two_node_net_data());
    EXPECT_THAT([&] { (void)free_coordinates(net, Points::Zero(3, 5)); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("5 points, expected 6")));
    EXPECT_THAT([&] { (void)with_free_coordinates(net, Eigen::VectorXd::Zero(2)); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("2 entries, expected 6")));
    EXPECT_THAT([&] { (void)with_length_deviations(net, Eigen::VectorXd::Zero(5)); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("5 entries, expected 3")));
}

// A net is valid by construction: an empty one would cause a crash later.
TEST(CableNet, StaysValidAfterItWasMovedFrom) {
    CableNet net(test::two_node_net_data());
    const CableNet other = std::move(net);
    EXPECT_EQ(net.fingerprint(), other.fingerprint());  // NOLINT(bugprone-use-after-move)
    EXPECT_EQ(net.node_count(), other.node_count());
}

}  // namespace
}  // namespace taut
