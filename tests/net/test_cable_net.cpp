// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against lists in another order than promised (free nodes, interior edges, coordinates):
// what is computed with them is then right in itself, and wrong for the net.
#include "taut/net/cable_net.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/small_nets.hpp"

namespace taut {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

TEST(CableNet, KeepsWhatItIsMadeFrom) {
    const CableNetData data = test::two_node_net_data();
    const CableNet net(data);
    EXPECT_EQ(net.name(), data.name);
    EXPECT_EQ(net.nodes(), data.nodes);
    EXPECT_EQ(net.supports(), data.supports);
    EXPECT_EQ(net.edges(), data.edges);
    EXPECT_EQ(net.axial_stiffness(), data.axial_stiffness);
    EXPECT_EQ(net.unstressed_lengths(), data.unstressed_lengths);
    EXPECT_EQ(net.loads(), data.loads);
    EXPECT_EQ(net.data().node_ids, data.node_ids);
    EXPECT_EQ(net.data().edge_ids, data.edge_ids);
}

TEST(CableNet, CountsItsNodesAndEdges) {
    const CableNet net(test::two_node_net_data());
    EXPECT_EQ(net.node_count(), 6);
    EXPECT_EQ(net.edge_count(), 5);
    EXPECT_EQ(net.free_node_count(), 2);
    EXPECT_EQ(net.interior_edge_count(), 3);
}

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
    const CableNet net(test::two_node_net_data());
    EXPECT_THAT(net.adjustable_edges(), ElementsAre(0, 4));
    EXPECT_THAT(net.data().adjustable, ElementsAre(0, 4));
    EXPECT_THAT(net.interior_edges(), ElementsAre(1, 2, 3));
}

TEST(CableNet, HasOnlyInteriorEdgesWhereNoneIsAdjustable) {
    CableNetData data = test::two_node_net_data();
    data.adjustable.clear();
    const CableNet net(std::move(data));
    EXPECT_THAT(net.adjustable_edges(), IsEmpty());
    EXPECT_THAT(net.interior_edges(), ElementsAre(0, 1, 2, 3, 4));
}

TEST(CableNet, FillsInLoadsOfZero) {
    CableNetData data = test::two_node_net_data();
    data.loads.resize(3, 0);
    const CableNet net(std::move(data));
    EXPECT_EQ(net.loads(), Points::Zero(3, 6));
    EXPECT_EQ(net.data().loads, Points::Zero(3, 6));
}

// By the drawn distance, a net that is not drawn in its form would hang otherwise.
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

TEST(CableNet, NamesNodesAndEdges) {
    const CableNet net(test::two_node_net_data());
    EXPECT_EQ(net.node_id(3), "b");
    EXPECT_EQ(net.edge_id(4), "bD");
}

TEST(CableNet, NamesNodesAndEdgesByIndexWhereItHasNoNames) {
    CableNetData data = test::two_node_net_data();
    data.node_ids.clear();
    data.edge_ids.clear();
    const CableNet net(std::move(data));
    EXPECT_EQ(net.node_id(3), "3");
    EXPECT_EQ(net.edge_id(4), "4");
}

TEST(EdgesAtSupports, AreThoseWithASupportAtEitherEnd) {
    EXPECT_THAT(edges_at_supports({{0, 1}, {1, 2}, {2, 0}, {3, 1}}, {3, 0}), ElementsAre(0, 2, 3));
    EXPECT_THAT(edges_at_supports({{0, 1}, {1, 2}}, {}), IsEmpty());
}

TEST(CableNet, RefusesIndicesBeyondItsNodesAndEdges) {
    const CableNet net(test::two_node_net_data());
    for (const int node : {-1, net.node_count(), 100000}) {
        EXPECT_THROW((void)net.free_index(node), std::out_of_range) << node;
        EXPECT_THROW((void)net.node_id(node), std::out_of_range) << node;
    }
    for (const int edge : {-1, net.edge_count(), 100000}) {
        EXPECT_THROW((void)net.tension_law(edge), std::out_of_range) << edge;
        EXPECT_THROW((void)net.edge_id(edge), std::out_of_range) << edge;
    }
    EXPECT_THAT([&] { (void)net.free_index(100000); },
                ThrowsMessage<std::out_of_range>(HasSubstr("node 100000, expected 0 to")));
}

TEST(FreeCoordinates, StandNodeByNodeInTheOrderOfTheFreeNodes) {
    const CableNet net(test::two_node_net_data());
    Eigen::VectorXd expected(6);
    expected << 0.0, 0.0, 0.1, 1.0, 0.1, 0.2;
    EXPECT_EQ(free_coordinates(net, net.nodes()), expected);
}

TEST(FreeCoordinates, ComeBackAsTheFormWithTheSupportsOfTheNet) {
    const CableNet net(test::two_node_net_data());
    const Eigen::VectorXd coordinates = Eigen::VectorXd::LinSpaced(6, 10.0, 15.0);
    const Points form = with_free_coordinates(net, coordinates);
    EXPECT_EQ(form.col(0), Eigen::Vector3d(10.0, 11.0, 12.0));
    EXPECT_EQ(form.col(3), Eigen::Vector3d(13.0, 14.0, 15.0));
    for (const int support : net.supports()) {
        EXPECT_EQ(form.col(support), net.nodes().col(support));
    }
    EXPECT_EQ(free_coordinates(net, form), coordinates);
}

TEST(FreeCoordinates, RefuseWrongSizes) {
    const CableNet net(test::two_node_net_data());
    EXPECT_THAT([&] { (void)free_coordinates(net, Points::Zero(3, 5)); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("5 points, expected 6")));
    EXPECT_THAT([&] { (void)with_free_coordinates(net, Eigen::VectorXd::Zero(2)); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("2 entries, expected 6")));
}

TEST(WithLengthDeviations, AddsThemToTheInteriorEdgesAlone) {
    const CableNet net(test::two_node_net_data());
    const Eigen::VectorXd lengths = with_length_deviations(net, Eigen::Vector3d(0.1, 0.2, 0.3));
    Eigen::VectorXd expected = net.unstressed_lengths();
    expected(1) += 0.1;
    expected(2) += 0.2;
    expected(3) += 0.3;
    EXPECT_EQ(lengths, expected);
}

TEST(WithLengthDeviations, RefusesAWrongSize) {
    const CableNet net(test::two_node_net_data());
    EXPECT_THAT([&] { (void)with_length_deviations(net, Eigen::VectorXd::Zero(5)); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("5 entries, expected 3")));
}

TEST(InteriorIndex, IsThePlaceAmongTheUncertainEdges) {
    const CableNet net(test::two_node_net_data());
    for (int k = 0; k < net.interior_edge_count(); ++k) {
        EXPECT_EQ(net.interior_index(net.interior_edges()[k]), k);
    }
    for (const int edge : net.adjustable_edges()) {
        EXPECT_EQ(net.interior_index(edge), -1);
    }
    EXPECT_THROW((void)net.interior_index(-1), std::out_of_range);
    EXPECT_THROW((void)net.interior_index(net.edge_count()), std::out_of_range);
}

// A net is valid by construction: one that is empty would be a crash later.
TEST(CableNet, IsANetAlsoAfterItWasMovedFrom) {
    CableNet net(test::two_node_net_data());
    const CableNet other = std::move(net);
    EXPECT_EQ(net.fingerprint(), other.fingerprint());  // NOLINT(bugprone-use-after-move)
    EXPECT_EQ(net.node_count(), other.node_count());
}

}  // namespace
}  // namespace taut
