// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "taut/design/builtin_nets.hpp"
#include "taut/design/force_density.hpp"

namespace taut {
namespace {

constexpr double half_length = 18.0;  // m, of the ellipse in plan
constexpr double half_width = 12.0;   // m
constexpr double spacing = 2.0;       // m, of the cables
constexpr double ring_rise = 2.4;     // m, of the ring: high at the ends of the length
constexpr double shortest = 0.4;      // of the spacing: from a node to the ring

constexpr double cladding = 300.0;         // N/m2
constexpr double steel_density = 7850.0;   // kg/m3
constexpr double steel_expansion = 12e-6;  // 1/K

/// The cables of one direction: spiral strands.
struct Family {
    const char* name;
    double force_density;  ///< [N/m]
    double diameter;       ///< [m]
};
constexpr std::array<Family, 2> families{{{"carrying", 16e3, 0.016}, {"bracing", 5e3, 0.012}}};

/// Share of a strand's circumscribed circle that is metal.
constexpr double fill = 0.77;

double area(const Family& family) {
    return fill * std::numbers::pi * family.diameter * family.diameter / 4.0;
}

/// A strand that beds in: 50 GPa up to 110 MPa, a constructional stretch of 0.066 % there,
/// then 72.5 GPa.
TensionLaw law_of(const Family& family) {
    constexpr double bedding_stress = 110e6;
    constexpr double bedding = 0.00066;
    constexpr double last_strain = 0.02;
    const double first = bedding_stress / 50e9;
    const Eigen::VectorXd strain{{0.0, first, first + bedding, last_strain}};
    const double last_stress = bedding_stress + 72.5e9 * (last_strain - first - bedding);
    return {.name = family.name,
            .strain = strain,
            .tension =
                area(family) * Eigen::VectorXd{{0.0, bedding_stress, bedding_stress, last_stress}}};
}

using RoofPoint = std::array<int, 2>;

Eigen::Vector2d lattice_place(RoofPoint p) {
    return spacing * Eigen::Vector2d(p[0] + 0.5, p[1] + 0.5);
}

/// Coordinate along an axis at which the line through a point inside the ring meets the ring [m].
double ring_ahead(const Eigen::Vector2d& p, int axis) {
    const std::array half{half_length, half_width};
    const double across = p(1 - axis) / half[1 - axis];
    return half[axis] * std::sqrt(std::max(0.0, 1.0 - across * across));
}

bool is_inside(const Eigen::Vector2d& p) {
    return std::abs(p.x()) + shortest * spacing <= ring_ahead(p, 0) &&
           std::abs(p.y()) + shortest * spacing <= ring_ahead(p, 1);
}

/// The plan: free nodes first, then supports on the ring; edges of both directions.
struct Plan {
    std::vector<Eigen::Vector3d> nodes;
    std::vector<int> supports;
    std::vector<Edge> edges;
    std::array<std::vector<int>, 2> family;  ///< edges of either direction
};

Plan plan_of_ring() {
    Plan plan;
    std::map<RoofPoint, int> free;
    const int reach = static_cast<int>(half_length / spacing);
    for (int i = -reach; i < reach; ++i) {
        for (int j = -reach; j < reach; ++j) {
            if (const Eigen::Vector2d p = lattice_place({i, j}); is_inside(p)) {
                free[{i, j}] = static_cast<int>(plan.nodes.size());
                plan.nodes.emplace_back(p.x(), p.y(), 0.0);
            }
        }
    }
    const auto add_edge = [&plan](int s, int t, int axis) {
        plan.family[axis].push_back(static_cast<int>(plan.edges.size()));
        plan.edges.push_back({s, t});
    };
    const auto add_support = [&plan](Eigen::Vector2d p, int axis, double side) {
        p(axis) = side * ring_ahead(p, axis);
        const Eigen::Vector2d on_ring(p.x() / half_length, p.y() / half_width);
        plan.supports.push_back(static_cast<int>(plan.nodes.size()));
        plan.nodes.emplace_back(
            p.x(), p.y(), ring_rise * (on_ring.x() * on_ring.x() - on_ring.y() * on_ring.y()));
        return plan.supports.back();
    };
    for (const auto& [point, node] : free) {
        for (int axis = 0; axis < 2; ++axis) {
            RoofPoint next = point;
            RoofPoint before = point;
            ++next[axis];
            --before[axis];
            if (!free.contains(before)) {
                add_edge(add_support(lattice_place(point), axis, -1.0), node, axis);
            }
            const auto neighbour = free.find(next);
            add_edge(node,
                     neighbour != free.end() ? neighbour->second
                                             : add_support(lattice_place(point), axis, 1.0),
                     axis);
        }
    }
    return plan;
}

}  // namespace

CableNet steel_roof() {
    const Plan plan = plan_of_ring();
    const auto n = static_cast<Eigen::Index>(plan.nodes.size());
    const auto m = static_cast<Eigen::Index>(plan.edges.size());
    CableNetData data;
    data.name = "steel-roof";
    data.nodes = Eigen::Map<const Points>(plan.nodes.front().data(), 3, n);
    data.supports = plan.supports;
    data.edges = plan.edges;
    data.adjustable = edges_at_supports(data.edges, data.supports);
    data.axial_stiffness.resize(m);
    data.tension_law.resize(m);
    data.mass.resize(m);
    data.expansion = Eigen::VectorXd::Constant(m, steel_expansion);
    data.loads = Points::Zero(3, n);
    const int free_count = static_cast<int>(n - std::ssize(plan.supports));
    data.loads.row(2).head(free_count).setConstant(-cladding * spacing * spacing);

    Eigen::VectorXd force_densities(m);
    for (int f = 0; f < 2; ++f) {
        const Family& family = families[f];
        data.tension_laws.push_back(law_of(family));
        data.groups[family.name] = plan.family[f];
        for (const int e : plan.family[f]) {
            force_densities(e) = family.force_density;
            data.axial_stiffness(e) = data.tension_laws[f].steepest();
            data.tension_law[e] = f;
            data.mass(e) = steel_density * area(family);
        }
    }
    // The self-weight depends on the lengths, and these on the form: iterate.
    data.unstressed_lengths = Eigen::VectorXd::Constant(m, spacing);
    constexpr int rounds = 10;
    for (int round = 0; round < rounds; ++round) {
        const Points loads = CableNet(data).loads();
        data.nodes = form_from_force_densities(data.nodes, data.supports, data.edges,
                                               force_densities, loads);
        for (Eigen::Index e = 0; e < m; ++e) {
            const auto [s, t] = data.edges[e];
            const double length = (data.nodes.col(s) - data.nodes.col(t)).norm();
            data.unstressed_lengths(e) =
                length / (1.0 + data.tension_laws[data.tension_law[e]].strain_at(
                                    force_densities(e) * length));
        }
    }
    return CableNet(std::move(data));
}

}  // namespace taut
