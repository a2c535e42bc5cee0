// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>
#include <vector>

#include "taut/net/cable_net.hpp"

/// Small nets made by hand.
namespace taut::test {

/// Two free nodes (0 and 3) between four supports, in an order that mixes them:
///
///        2         5
///        |1        |4
///   1----0----2----3----3----4      (edges: 0, 2, 3 along the line)
///     0
///
/// Edges 4 and 0 are adjustable, 1 to 3 interior. Every list is filled, and no two values agree.
inline CableNetData two_node_net_data() {
    CableNetData data;
    data.name = "two nodes";
    data.nodes.resize(3, 6);
    data.nodes.col(0) << 0.0, 0.0, 0.1;
    data.nodes.col(1) << -1.0, 0.0, 0.0;
    data.nodes.col(2) << 0.0, 1.5, 0.0;
    data.nodes.col(3) << 1.0, 0.1, 0.2;
    data.nodes.col(4) << 2.0, 0.0, 0.0;
    data.nodes.col(5) << 1.0, 1.25, 0.5;
    data.supports = {1, 2, 4, 5};
    data.edges = {{0, 1}, {2, 0}, {0, 3}, {3, 4}, {5, 3}};
    data.axial_stiffness = Eigen::VectorXd::LinSpaced(5, 100e3, 140e3);
    data.unstressed_lengths.resize(5);
    data.unstressed_lengths << 0.98, 1.45, 0.97, 0.99, 1.125;
    data.adjustable = {4, 0};
    data.loads = Points::Zero(3, 6);
    data.loads.col(0) << 0.0, 10.0, -500.0;
    data.loads.col(3) << 20.0, 0.0, -400.0;
    data.node_ids = {"a", "A", "B", "b", "C", "D"};
    data.edge_ids = {"aA", "aB", "ab", "bC", "bD"};
    return data;
}

inline CableNet two_node_net() {
    return CableNet(two_node_net_data());
}

/// A free node (0) at the origin between four supports, at 1 m along x, -x, y and -y: unstressed
/// lengths 1 m / (1 + strain), EA = 100 kN.
inline CableNetData cross_data(double strain) {
    CableNetData data;
    data.name = "cross";
    data.nodes.resize(3, 5);
    data.nodes.col(0).setZero();
    data.nodes.rightCols(4) << 1.0, -1.0, 0.0, 0.0,  //
        0.0, 0.0, 1.0, -1.0,                         //
        0.0, 0.0, 0.0, 0.0;
    data.supports = {1, 2, 3, 4};
    data.edges = {{0, 1}, {0, 2}, {0, 3}, {0, 4}};
    data.axial_stiffness.setConstant(4, 100e3);
    data.unstressed_lengths.setConstant(4, 1.0 / (1.0 + strain));
    data.adjustable = {0, 1, 2, 3};
    return data;
}

/// The tense cross with a node (5) that hangs at node 0 by an edge longer than its distance.
inline CableNetData cross_with_a_loose_node_data() {
    CableNetData data = cross_data(0.02);
    data.nodes.conservativeResize(3, 6);
    data.nodes.col(5) << 0.1, 0.2, 0.3;
    data.edges.push_back({0, 5});
    data.axial_stiffness.setConstant(5, 100e3);
    data.unstressed_lengths.conservativeResize(5);
    data.unstressed_lengths(4) = 0.5;
    return data;
}

/// A chain of `edge_count` edges of 1 m between supports at x = 0 and x = `span`, with a weight at
/// every free node: nodes on a straight line, so that with span < edge_count all edges are slack.
inline CableNetData chain_data(int edge_count, double span, double weight) {
    CableNetData data;
    data.name = "chain";
    data.nodes = Points::Zero(3, edge_count + 1);
    data.nodes.row(0) = Eigen::RowVectorXd::LinSpaced(edge_count + 1, 0.0, span);
    data.supports = {0, edge_count};
    for (int e = 0; e < edge_count; ++e) {
        data.edges.push_back({e, e + 1});
    }
    data.axial_stiffness.setConstant(edge_count, 100e3);
    data.unstressed_lengths.setConstant(edge_count, 1.0);
    data.adjustable = edges_at_supports(data.edges, data.supports);
    data.loads = Points::Zero(3, edge_count + 1);
    data.loads.row(2).setConstant(-weight);
    return data;
}

/// A node (0) 1 m below a support (1) by an edge of l_0 = 1 m and EA = 100 kN, with a weight of
/// 1 kN: at rest it is 10 mm lower.
inline CableNetData hanging_node_data() {
    CableNetData data;
    data.nodes = Points::Zero(3, 2);
    data.nodes(2, 0) = -1.0;
    data.supports = {1};
    data.edges = {{0, 1}};
    data.axial_stiffness.setConstant(1, 100e3);
    data.unstressed_lengths.setConstant(1, 1.0);
    data.loads = Points::Zero(3, 2);
    data.loads(2, 0) = -1000.0;
    return data;
}

/// 0, 1, ..., m - 1.
inline std::vector<int> all_edges(const CableNet& net) {
    std::vector<int> edges(net.edge_count());
    std::iota(edges.begin(), edges.end(), 0);
    return edges;
}

}  // namespace taut::test
