// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <array>
#include <vector>

#include "taut/design/builtin_nets.hpp"
#include "taut/design/force_density.hpp"
#include "taut/design/unstressed_lengths.hpp"

namespace taut {

CableNet sliding_ridge() {
    constexpr int stations = 7;  // nodes along each cable
    constexpr double spacing = 2.0;
    constexpr std::array masts{1, 5};       // stations where the ridge runs over one
    constexpr double friction = 0.1;        // of steel on a greased saddle
    constexpr double ridge_tension = 30e3;  // [N]
    constexpr double valley_density = 5e3;  // [N/m]
    constexpr double cross_density = 4e3;
    constexpr double ridge_stiffness = 6e6;  // strand of 8 mm [N]
    constexpr double other_stiffness = 2e6;  // strand of 5 mm [N]

    CableNetData data;
    data.name = "sliding-ridge";
    std::vector<Eigen::Vector3d> nodes;
    std::vector<double> densities;
    std::vector<double> stiffnesses;
    const auto add_node = [&](double x, double y, double z) {
        nodes.emplace_back(x, y, z);
        return static_cast<int>(nodes.size()) - 1;
    };
    const auto add_support = [&](double x, double y, double z) {
        data.supports.push_back(add_node(x, y, z));
        return data.supports.back();
    };
    const auto add_edge = [&](const char* group, int s, int t, double density, double stiffness) {
        data.groups[group].push_back(static_cast<int>(data.edges.size()));
        data.edges.push_back({s, t});
        densities.push_back(density);
        stiffnesses.push_back(stiffness);
    };
    /// Nodes of a cable along x between two supports, and its edges.
    const auto add_cable = [&](const char* group, double y, double end_height, double density,
                               double stiffness, bool has_masts) {
        std::vector<int> line;
        for (int i = 0; i < stations; ++i) {
            const bool is_mast = has_masts && (i == masts[0] || i == masts[1]);
            const double x = spacing * (i + 1);
            line.push_back(is_mast ? add_support(x, y, 5.0) : add_node(x, y, 0.0));
        }
        int last = add_support(0.0, y, end_height);
        for (const int node : line) {
            add_edge(group, last, node, density, stiffness);
            last = node;
        }
        add_edge(group, last, add_support(spacing * (stations + 1), y, end_height), density,
                 stiffness);
        return line;
    };
    const std::vector<int> ridge =
        add_cable("ridge", 0.0, 2.0, ridge_tension / spacing, ridge_stiffness, true);
    data.runs = {{.name = "ridge",
                  .edges = data.groups.at("ridge"),
                  .slides_at = ridge,
                  .friction = friction}};
    data.adjustable = {data.runs[0].edges.front(), data.runs[0].edges.back()};
    for (const double side : {-1.0, 1.0}) {
        const std::vector<int> valley =
            add_cable("valley", 2.5 * side, 1.0, valley_density, other_stiffness, false);
        for (int i = 0; i < stations; ++i) {
            add_edge("cross", ridge[i], valley[i], cross_density, other_stiffness);
            data.adjustable.push_back(static_cast<int>(data.edges.size()));
            add_edge("hold-down", valley[i], add_support(spacing * (i + 1), 6.0 * side, 0.0),
                     cross_density, other_stiffness);
        }
    }
    data.nodes = Eigen::Map<const Points>(nodes.front().data(), 3, std::ssize(nodes));
    const auto m = std::ssize(data.edges);
    Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(densities.data(), m);
    data.axial_stiffness = Eigen::Map<const Eigen::VectorXd>(stiffnesses.data(), m);
    // Where the ridge slides it has one tension.
    constexpr int rounds = 100;
    Eigen::VectorXd lengths(m);
    for (int round = 0; round < rounds; ++round) {
        data.nodes = form_from_force_densities(data.nodes, data.supports, data.edges, q);
        for (Eigen::Index e = 0; e < m; ++e) {
            const auto [s, t] = data.edges[e];
            lengths(e) = (data.nodes.col(s) - data.nodes.col(t)).norm();
        }
        const auto& edges = data.runs[0].edges;
        q(edges) = ridge_tension * lengths(edges).cwiseInverse();
    }
    data.unstressed_lengths =
        unstressed_lengths_for(lengths, q.cwiseProduct(lengths), data.axial_stiffness);
    return CableNet(std::move(data));
}

}  // namespace taut
