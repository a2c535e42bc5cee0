// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "design/form_found_net.hpp"

#include "taut/design/force_density.hpp"
#include "taut/design/unstressed_lengths.hpp"

namespace taut {
namespace {

constexpr double cable_stiffness = 200e3;  // N
constexpr double cable_force_density =
    4e3 / lattice_spacing;  // N/m: 4 kN in an edge of this length

}  // namespace

CableNet form_found_net(std::string name, const Points& nodes, const std::vector<int>& supports,
                        const std::vector<Edge>& edges) {
    const auto m = static_cast<Eigen::Index>(edges.size());
    CableNetData data;
    data.name = std::move(name);
    data.nodes = form_from_force_densities(nodes, supports, edges,
                                           Eigen::VectorXd::Constant(m, cable_force_density));
    data.supports = supports;
    data.edges = edges;
    data.axial_stiffness.setConstant(m, cable_stiffness);
    Eigen::VectorXd lengths(m);
    for (Eigen::Index e = 0; e < m; ++e) {
        const auto [s, t] = edges[e];
        lengths(e) = (data.nodes.col(s) - data.nodes.col(t)).norm();
    }
    data.unstressed_lengths =
        unstressed_lengths_for(lengths, cable_force_density * lengths, data.axial_stiffness);
    data.adjustable = edges_at_supports(edges, supports);
    return CableNet(std::move(data));
}

}  // namespace taut
