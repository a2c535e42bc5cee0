// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "design/form_found_net.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

constexpr double roof_length = 4.26;  // m, of the rectangle
constexpr double roof_width = 1.96;   // m
constexpr double roof_height = 1.0;   // m, of the rectangle above the touch-downs
constexpr double radius = 0.66;       // m, of the largest circle

using LatticePoint = std::array<int, 2>;
constexpr std::array<LatticePoint, 4> directions{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

struct Circle {
    Eigen::Vector2d centre;
    double radius;
    Eigen::Vector2d inward;  ///< from the border on which the centre lies into the rectangle
};

const std::array<Circle, 5>& circles() {
    static const std::array<Circle, 5> all{
        {{{0.55 * roof_length, 0.0}, radius, {0, 1}},
         {{0.27 * roof_length, roof_width}, 0.80 * radius, {0, -1}},
         {{0.70 * roof_length, roof_width}, 0.80 * radius, {0, -1}},
         {{0.0, 0.40 * roof_width}, 0.85 * radius, {1, 0}},
         {{roof_length, 0.62 * roof_width}, 0.90 * radius, {-1, 0}}}};
    return all;
}

/// A lattice point in plan: the lattice is turned by 45 degrees about the middle of the rectangle.
/// Its offset is a quarter of the spacing in both directions, which gives the paper's counts; three
/// quarters in one direction does not.
Eigen::Vector2d in_plan(LatticePoint p) {
    const Eigen::Vector2d middle(0.5 * roof_length, 0.5 * roof_width);
    const Eigen::Vector2d q = lattice_spacing * Eigen::Vector2d(p[0] + 0.25, p[1] + 0.25);
    return middle + std::numbers::sqrt2 / 2.0 * Eigen::Vector2d(q.x() - q.y(), q.x() + q.y());
}

bool in_outline(const Eigen::Vector2d& p) {
    return p.x() >= 0.0 && p.x() <= roof_length && p.y() >= 0.0 && p.y() <= roof_width &&
           std::ranges::all_of(circles(), [&](const Circle& circle) {
               return (p - circle.centre).norm() >= circle.radius;
           });
}

/// Free nodes and their indices: lattice points in the outline, after repeated removal of those
/// with fewer than two neighbours.
std::map<LatticePoint, int> free_lattice_points() {
    std::map<LatticePoint, int> points;
    const int reach = static_cast<int>(std::ceil((roof_length + roof_width) / lattice_spacing));
    for (int i = -reach; i <= reach; ++i) {
        for (int j = -reach; j <= reach; ++j) {
            if (in_outline(in_plan({i, j}))) {
                points.emplace(LatticePoint{i, j}, 0);
            }
        }
    }
    const auto is_loose = [&](const auto& point) {
        const LatticePoint& at = point.first;
        return std::ranges::count_if(directions, [&](LatticePoint d) {
                   return points.contains({at[0] + d[0], at[1] + d[1]});
               }) < 2;
    };
    while (std::erase_if(points, is_loose) > 0) {
    }
    int index = 0;
    for (auto& [point, node] : points) {
        node = index++;
    }
    return points;
}

/// Height of the rigid frame: roof height on the rectangle. Along a circle it descends to the
/// ground at the middle of the arc, horizontal there and at roof height.
double frame_height(const Circle* circle, const Eigen::Vector2d& p) {
    if (circle == nullptr) {
        return roof_height;
    }
    const double cosine = (p - circle->centre).normalized().dot(circle->inward);
    return roof_height * (1.0 - std::pow(std::max(0.0, cosine), 2));
}

/// Where the edge from a free node in a direction (unit vector) leaves the outline: by a circle, or
/// by the rectangle; at least half the spacing away.
Eigen::Vector3d support_on_outline(const Eigen::Vector2d& from, const Eigen::Vector2d& direction) {
    const Circle* cut_by = nullptr;
    double distance = 2.0 * lattice_spacing;
    const auto shorten = [&](double d, const Circle* circle) {
        if (d >= 0.0 && d < distance) {
            distance = d;
            cut_by = circle;
        }
    };
    for (int axis = 0; axis < 2; ++axis) {
        const double limit = direction(axis) > 0.0 ? (axis == 0 ? roof_length : roof_width) : 0.0;
        shorten((limit - from(axis)) / direction(axis), nullptr);
    }
    for (const Circle& circle : circles()) {
        // |from + d direction - centre|^2 = radius^2, the smaller root.
        const Eigen::Vector2d offset = from - circle.centre;
        const double b = offset.dot(direction);
        const double discriminant = b * b - offset.squaredNorm() + circle.radius * circle.radius;
        if (discriminant >= 0.0) {
            shorten(-b - std::sqrt(discriminant), &circle);
        }
    }
    const Eigen::Vector2d p = from + std::max(distance, 0.5 * lattice_spacing) * direction;
    return {p.x(), p.y(), frame_height(cut_by, p)};
}

}  // namespace

CableNet hilo_quarter() {
    const auto free = free_lattice_points();
    std::vector<Eigen::Vector3d> nodes(free.size(), Eigen::Vector3d::Zero());
    std::vector<int> supports;
    std::vector<Edge> edges;
    for (const auto& [point, node] : free) {
        for (const LatticePoint& d : directions) {
            const LatticePoint other{point[0] + d[0], point[1] + d[1]};
            if (const auto neighbour = free.find(other); neighbour != free.end()) {
                if (node < neighbour->second) {
                    edges.push_back({node, neighbour->second});
                }
                continue;
            }
            const Eigen::Vector2d from = in_plan(point);
            const auto support = static_cast<int>(nodes.size());
            nodes.push_back(support_on_outline(from, (in_plan(other) - from).normalized()));
            supports.push_back(support);
            edges.push_back({node, support});
        }
    }
    const Points points =
        Eigen::Map<const Points>(nodes.front().data(), 3, static_cast<Eigen::Index>(nodes.size()));
    return form_found_net("hilo-quarter", points, supports, edges);
}

}  // namespace taut
