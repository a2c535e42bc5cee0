// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <numbers>

#include "taut/design/builtin_nets.hpp"
#include "taut/design/force_density.hpp"
#include "taut/design/unstressed_lengths.hpp"

/// A roof of steel cables that replaces the real one of hilo_roof.hpp, which is not part of this
/// repository: equally stiff, under the weight of its concrete, and with dozens of slack edges if
/// its lengths deviate by 5 mm.
namespace taut::test {

constexpr double steel_young = 205e9;                            ///< [Pa]
constexpr std::array<double, 3> steel_diameters{2.2, 2.5, 2.7};  ///< of edges 0, 1, 2, 0, ... [mm]
constexpr double steel_force_density = 15e3;                     ///< [N/m]
constexpr double steel_node_weight = 20.0;                       ///< [N]

/// The lattice of the built-in net with EA of 0.8 to 1.2 MN, in equilibrium at some 2 kN: strains
/// of 0.2 %.
inline CableNet steel_lattice() {
    const CableNet lattice = hilo_quarter();
    CableNetData data = lattice.data();
    data.name = "steel roof";
    std::ranges::sort(data.edges);  // as readers of files that sort their keys have them
    data.adjustable = edges_at_supports(data.edges, data.supports);
    const auto m = static_cast<Eigen::Index>(data.edges.size());
    data.loads = Points::Zero(3, data.nodes.cols());
    for (const int node : lattice.free_nodes()) {
        data.loads(2, node) = -steel_node_weight;
    }
    data.nodes =
        form_from_force_densities(data.nodes, data.supports, data.edges,
                                  Eigen::VectorXd::Constant(m, steel_force_density), data.loads);
    Eigen::VectorXd lengths(m);
    for (Eigen::Index e = 0; e < m; ++e) {
        const auto [s, t] = data.edges[e];
        const double diameter = 1e-3 * steel_diameters[e % 3];
        lengths(e) = (data.nodes.col(s) - data.nodes.col(t)).norm();
        data.axial_stiffness(e) = steel_young * std::numbers::pi * diameter * diameter / 4.0;
    }
    data.unstressed_lengths =
        unstressed_lengths_for(lengths, steel_force_density * lengths, data.axial_stiffness);
    return CableNet(std::move(data));
}

/// The same as a designer's file: a COMPAS graph with force densities in kN/m and diameters in mm,
/// without EA, lengths and loads.
inline nlohmann::json steel_roof_compas() {
    using nlohmann::json;
    const CableNet net = steel_lattice();
    json nodes = json::object();
    json edges = json::object();
    for (int i = 0; i < net.node_count(); ++i) {
        const Eigen::Vector3d place = net.nodes().col(i);
        nodes[fmt::format("{:03}", i)] = {{"x", place.x()},
                                          {"y", place.y()},
                                          {"z", place.z()},
                                          {"is_anchor", net.free_index(i) < 0}};
    }
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto [s, t] = net.edges()[e];
        edges[fmt::format("{:03}", s)][fmt::format("{:03}", t)] = {
            {"q", 1e-3 * steel_force_density}, {"size", steel_diameters[e % 3]}};
    }
    return {{"dtype", "compas.datastructures/Graph"},
            {"data",
             {{"attributes", {{"name", net.name()}}},
              {"default_node_attributes", json::object()},
              {"default_edge_attributes", json::object()},
              {"node", nodes},
              {"edge", edges}}}};
}

}  // namespace taut::test
