// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Built-in nets with struts. Each has one state of self-stress, which follows from the balance of
// its nodes in closed form.
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "taut/design/builtin_nets.hpp"
#include "taut/design/unstressed_lengths.hpp"

namespace taut {
namespace {

/// A net that is put together member by member, each with the force density of the self-stress.
class Assembly {
public:
    explicit Assembly(std::string name) { m_data.name = std::move(name); }

    int add_node(double x, double y, double z) {
        m_nodes.emplace_back(x, y, z);
        return static_cast<int>(m_nodes.size()) - 1;
    }
    void add_cable(const char* group, int s, int t, double density, double stiffness) {
        add_edge(group, EdgeKind::cable, s, t, density, stiffness);
    }
    void add_strut(const char* group, int s, int t, double density, double stiffness) {
        add_edge(group, EdgeKind::strut, s, t, density, stiffness);
    }
    /// @param stiffness in x, y and z [N/m]
    void add_elastic_support(int node, const Eigen::Vector3d& stiffness) {
        m_data.elastic_supports.push_back(
            {.node = node, .stiffness = stiffness.asDiagonal(), .place = m_nodes[node]});
    }

    /// @param adjustable names of groups
    CableNet finish(std::vector<int> supports, std::initializer_list<const char*> adjustable) {
        CableNetData data = m_data;
        const auto m = static_cast<Eigen::Index>(data.edges.size());
        data.nodes.resize(3, std::ssize(m_nodes));
        for (size_t i = 0; i < m_nodes.size(); ++i) {
            data.nodes.col(static_cast<Eigen::Index>(i)) = m_nodes[i];
        }
        data.supports = std::move(supports);
        data.axial_stiffness.resize(m);
        Eigen::VectorXd lengths(m);
        Eigen::VectorXd forces(m);
        for (Eigen::Index e = 0; e < m; ++e) {
            const auto [s, t] = data.edges[e];
            data.axial_stiffness(e) = m_stiffnesses[e];
            lengths(e) = (m_nodes[s] - m_nodes[t]).norm();
            forces(e) = m_densities[e] * lengths(e);
        }
        data.unstressed_lengths = unstressed_lengths_for(lengths, forces, data.axial_stiffness);
        for (const char* const group : adjustable) {
            const std::vector<int>& edges = data.groups.at(group);
            data.adjustable.insert(data.adjustable.end(), edges.begin(), edges.end());
        }
        return CableNet(std::move(data));
    }

private:
    void add_edge(const char* group, EdgeKind kind, int s, int t, double density,
                  double stiffness) {
        m_data.groups[group].push_back(static_cast<int>(m_data.edges.size()));
        m_data.edges.push_back({s, t});
        m_data.kind.push_back(kind);
        m_densities.push_back(density);
        m_stiffnesses.push_back(stiffness);
    }

    CableNetData m_data;
    std::vector<Eigen::Vector3d> m_nodes;
    std::vector<double> m_densities;    ///< force over length, of compressed struts negative [N/m]
    std::vector<double> m_stiffnesses;  ///< [N]
};

constexpr double steel_strand = 12e6;  // EA of a strand of 12 to 16 mm [N]
constexpr double steel_tube = 120e6;   // EA of a tube of 76 x 2.5 mm [N]

}  // namespace

CableNet cable_dome() {
    constexpr int sectors = 12;
    struct Ring {
        double radius;  // [m]
        double top;     // heights of the ends of its struts [m]
        double bottom;
    };
    constexpr std::array<Ring, 3> rings{{{0.0, 2.0, 0.6}, {3.5, 1.6, -0.2}, {7.0, 0.9, -1.2}}};
    constexpr double support_radius = 10.5;
    constexpr double first_density = 6e3;  // of the innermost ridge cables [N/m]

    Assembly dome("cable-dome");
    std::array<std::vector<int>, 3> tops;
    std::array<std::vector<int>, 3> bottoms;
    std::vector<int> supports;
    for (int k = 0; k < sectors; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / sectors;
        const double x = std::cos(angle);
        const double y = std::sin(angle);
        for (size_t r = 0; r < rings.size(); ++r) {
            if (r == 0 && k > 0) {
                tops[0].push_back(tops[0][0]);
                bottoms[0].push_back(bottoms[0][0]);
                continue;
            }
            const auto& [radius, top, bottom] = rings.at(r);
            tops.at(r).push_back(dome.add_node(radius * x, radius * y, top));
            bottoms.at(r).push_back(dome.add_node(radius * x, radius * y, bottom));
        }
        supports.push_back(dome.add_node(support_radius * x, support_radius * y, 0.0));
    }
    double ridge = first_density;
    for (size_t r = 0; r < rings.size(); ++r) {
        const bool is_last = r + 1 == rings.size();
        const Ring& ring = rings.at(r);
        const double next_top = is_last ? 0.0 : rings.at(r + 1).top;
        const double next_radius = is_last ? support_radius : rings.at(r + 1).radius;
        // Of the ridge cables inside of a ring and the diagonals below them nothing vertical is
        // left.
        const double strut =
            (r == 0 ? sectors : 1) * ridge * (next_top - ring.top) / (ring.top - ring.bottom);
        const double diagonal = ridge * (ring.top - next_top) / (next_top - ring.bottom);
        const double hoop =
            r == 0 ? 0.0
                   : diagonal * (next_radius - ring.radius) /
                         (2.0 * ring.radius * (1.0 - std::cos(2.0 * std::numbers::pi / sectors)));
        for (int k = 0; k < sectors; ++k) {
            const int next = is_last ? supports[k] : tops.at(r + 1)[k];
            dome.add_cable("ridge", tops.at(r)[k], next, ridge, steel_strand);
            dome.add_cable("diagonal", bottoms.at(r)[k], next, diagonal, steel_strand);
            if (r > 0) {
                dome.add_cable("hoop", bottoms.at(r)[k], bottoms.at(r)[(k + 1) % sectors], hoop,
                               3.0 * steel_strand);
            }
            if (r > 0 || k == 0) {
                dome.add_strut("strut", tops.at(r)[k], bottoms.at(r)[k], strut, steel_tube);
            }
        }
        if (!is_last) {
            const Ring& outer = rings.at(r + 1);
            const double beyond = r + 2 == rings.size() ? support_radius : rings.at(r + 2).radius;
            ridge = (ridge + diagonal) * (outer.radius - ring.radius) / (beyond - outer.radius);
        }
    }
    // Turnbuckles at the ring beam.
    CableNetData data = dome.finish(supports, {}).data();
    data.adjustable = edges_at_supports(data.edges, data.supports);
    return CableNet(std::move(data));
}

CableNet spoke_wheel() {
    constexpr int spokes = 24;
    constexpr double radius = 15.0;
    constexpr double half_mast = 1.8;
    constexpr double density = 2e3;  // of the spokes [N/m]
    constexpr double rim_stiffness = 2e9;
    Assembly wheel("spoke-wheel");
    const int top = wheel.add_node(0.0, 0.0, half_mast);
    const int bottom = wheel.add_node(0.0, 0.0, -half_mast);
    std::vector<int> rim;
    for (int k = 0; k < spokes; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / spokes;
        rim.push_back(wheel.add_node(radius * std::cos(angle), radius * std::sin(angle), 0.0));
    }
    const double of_rim = -density / (1.0 - std::cos(2.0 * std::numbers::pi / spokes));
    for (int k = 0; k < spokes; ++k) {
        wheel.add_cable("upper", top, rim[k], density, steel_strand);
        wheel.add_cable("lower", bottom, rim[k], density, steel_strand);
        wheel.add_strut("rim", rim[k], rim[(k + 1) % spokes], of_rim, rim_stiffness);
        wheel.add_elastic_support(rim[k], {2e5, 2e5, 5e7});  // a column that leans
    }
    wheel.add_strut("mast", top, bottom, -0.5 * spokes * density, steel_tube);
    return wheel.finish({}, {"lower"});
}

CableNet tensegrity_simplex() {
    constexpr double strut = 70390e6 * 364.4e-6;      // EA [N]
    constexpr double horizontal = 71750e6 * 50.3e-6;  // EA [N]
    constexpr double vertical = 72190e6 * 50.3e-6;    // EA [N]
    constexpr double side = 2.0438;                   // of the triangles [m]
    constexpr double height = 1.95;                   // [m]
    constexpr double force = 6e3;                     // in each strut [N]
    constexpr double held = 1e8;                      // [N/m]
    constexpr double sliding = 10.0;                  // [N/m]
    Assembly simplex("tensegrity-simplex");
    // The upper triangle is turned by 30 degrees, where the simplex has its self-stress: -1, 0.393
    // and 0.681 of the force in a strut, as published.
    const double radius = side / std::numbers::sqrt3;
    constexpr double third = 2.0 * std::numbers::pi / 3.0;
    std::array<int, 6> nodes{};
    for (int k = 0; k < 6; ++k) {
        const double angle = third * k + (k < 3 ? 0.0 : std::numbers::pi / 6.0);
        nodes.at(k) = simplex.add_node(radius * std::cos(angle), radius * std::sin(angle),
                                       k < 3 ? 0.0 : height);
    }
    const double strut_length =
        std::sqrt(height * height + 2.0 * radius * radius * (1.0 + std::sqrt(0.75)));
    const double density = force / strut_length;
    for (int k = 0; k < 3; ++k) {
        simplex.add_strut("strut", nodes.at(k), nodes.at(3 + (k + 1) % 3), -density, strut);
    }
    for (const int first : {0, 3}) {
        for (int k = 0; k < 3; ++k) {
            simplex.add_cable("horizontal", nodes.at(first + k), nodes.at(first + (k + 1) % 3),
                              density / std::numbers::sqrt3, horizontal);
        }
    }
    for (int k = 0; k < 3; ++k) {
        simplex.add_cable("vertical", nodes.at(k), nodes.at(3 + k), density, vertical);
    }
    // On the floor: one foot is held, one slides along x, the third in any direction.
    simplex.add_elastic_support(nodes[1], {sliding, sliding, held});
    simplex.add_elastic_support(nodes[2], {sliding, held, held});
    return simplex.finish({nodes[0]}, {"vertical"});
}

}  // namespace taut
