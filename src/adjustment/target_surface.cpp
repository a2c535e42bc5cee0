// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/adjustment/target_surface.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <unsupported/Eigen/BVH>

namespace taut {

/// A point of a triangle, and the corners it lies between: one, two or all three.
struct TrianglePoint {
    Eigen::Vector3d place;
    std::array<bool, 3> between;
};

namespace {

/// Areas below this part of the longest side squared are rounding errors.
constexpr double smallest_area = 1e-12;
/// Nearer than this to an edge of the surface a point defines no direction [m].
constexpr double on_surface = 1e-6;

/// The nearest point of a triangle, by the part of the plane that the point projects to (C.
/// Ericson, Real-Time Collision Detection, Morgan Kaufmann 2005, section 5.1.5).
TrianglePoint nearest_of_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& c, const Eigen::Vector3d& point) {
    const Eigen::Vector3d ab = b - a;
    const Eigen::Vector3d ac = c - a;
    const double a_b = ab.dot(point - a);
    const double a_c = ac.dot(point - a);
    if (a_b <= 0.0 && a_c <= 0.0) {
        return {.place = a, .between = {true, false, false}};
    }
    const double b_b = ab.dot(point - b);
    const double b_c = ac.dot(point - b);
    if (b_b >= 0.0 && b_c <= b_b) {
        return {.place = b, .between = {false, true, false}};
    }
    const double of_c = a_b * b_c - b_b * a_c;  // twice the areas, times the triangle's
    if (of_c <= 0.0 && a_b >= 0.0 && b_b <= 0.0) {
        return {.place = a + a_b / (a_b - b_b) * ab, .between = {true, true, false}};
    }
    const double c_b = ab.dot(point - c);
    const double c_c = ac.dot(point - c);
    if (c_c >= 0.0 && c_b <= c_c) {
        return {.place = c, .between = {false, false, true}};
    }
    const double of_b = c_b * a_c - a_b * c_c;
    if (of_b <= 0.0 && a_c >= 0.0 && c_c <= 0.0) {
        return {.place = a + a_c / (a_c - c_c) * ac, .between = {true, false, true}};
    }
    const double of_a = b_b * c_c - c_b * b_c;
    if (of_a <= 0.0 && b_c - b_b >= 0.0 && c_b - c_c >= 0.0) {
        const double part = (b_c - b_b) / ((b_c - b_b) + (c_b - c_c));
        return {.place = b + part * (c - b), .between = {false, true, true}};
    }
    const double sum = of_a + of_b + of_c;
    return {.place = a + of_b / sum * ab + of_c / sum * ac, .between = {true, true, true}};
}

/// Adds the normal of a face whose orientation need not agree: on the side of the first.
void add_to_normal(Eigen::Vector3d& sum, const Eigen::Vector3d& normal) {
    sum += sum.dot(normal) < 0.0 ? Eigen::Vector3d(-normal) : normal;
}

}  // namespace

class TargetSurface::Search {
public:
    Search(const Points& vertices, const std::vector<std::array<int, 3>>& triangles) {
        weld(vertices);
        for (const std::array<int, 3>& triangle : triangles) {
            add(triangle);
        }
        if (m_triangles.empty()) {
            throw std::invalid_argument(
                triangles.empty()
                    ? std::string("the surface has no triangle, expected at least one")
                    : fmt::format("none of the {} triangles of the surface has an area",
                                  triangles.size()));
        }
        find_border();
        std::vector<int> indices(m_triangles.size());
        std::vector<Eigen::AlignedBox3d> boxes(m_triangles.size());
        for (size_t i = 0; i < m_triangles.size(); ++i) {
            indices[i] = static_cast<int>(i);
            for (const int corner : m_triangles[i]) {
                boxes[i].extend(m_places[static_cast<size_t>(corner)]);
            }
        }
        m_tree = {indices.begin(), indices.end(), boxes.begin(), boxes.end()};
    }

    [[nodiscard]] SurfacePoint nearest(const Eigen::Vector3d& point) const {
        Nearest search{.of = this, .point = &point};
        Eigen::BVMinimize(m_tree, search);
        SurfacePoint result{.place = search.found.place,
                            .normal = m_face_normals[static_cast<size_t>(search.triangle)]};
        const Eigen::Vector3d away = point - result.place;
        result.distance = away.norm();
        const std::array<bool, 3>& between = search.found.between;
        const auto corners = std::ranges::count(between, true);
        if (corners == 3) {
            return result;
        }
        const Feature& feature = feature_of(search.triangle, between);
        if (feature.is_border || result.distance < on_surface) {
            result.normal = feature.normal.normalized();
        } else {
            result.normal = away / result.distance;
        }
        if (feature.is_border) {
            result.beyond_border = (away - result.normal.dot(away) * result.normal).norm();
        }
        return result;
    }

    [[nodiscard]] int triangle_count() const { return static_cast<int>(m_triangles.size()); }
    [[nodiscard]] int left_out() const { return m_left_out; }

private:
    /// An edge or a corner of faces.
    struct Feature {
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of its faces, by their angles there
        bool is_border = false;
        int faces = 0;
    };

    /// The functor of Eigen::BVMinimize.
    struct Nearest {
        using Scalar = double;
        const Search* of;
        const Eigen::Vector3d* point;
        int triangle = -1;
        double squared_distance = std::numeric_limits<double>::infinity();
        TrianglePoint found{};

        // NOLINTNEXTLINE(readability-identifier-naming)
        [[nodiscard]] double minimumOnVolume(const Eigen::AlignedBox3d& box) const {
            return box.squaredExteriorDistance(*point);
        }
        // NOLINTNEXTLINE(readability-identifier-naming)
        double minimumOnObject(int index) {
            const std::array<int, 3>& corners = of->m_triangles[static_cast<size_t>(index)];
            const TrianglePoint here = nearest_of_triangle(
                of->place(corners[0]), of->place(corners[1]), of->place(corners[2]), *point);
            const double squared = (here.place - *point).squaredNorm();
            if (squared < squared_distance || triangle < 0) {
                squared_distance = squared;
                triangle = index;
                found = here;
            }
            return squared;
        }
    };

    [[nodiscard]] const Eigen::Vector3d& place(int corner) const {
        return m_places[static_cast<size_t>(corner)];
    }

    void weld(const Points& vertices) {
        std::map<std::array<double, 3>, int> known;
        m_corner_of.reserve(static_cast<size_t>(vertices.cols()));
        for (Eigen::Index i = 0; i < vertices.cols(); ++i) {
            if (!vertices.col(i).allFinite()) {
                throw std::invalid_argument(
                    fmt::format("vertex {} of the surface is not finite", i));
            }
            // + 0.0 turns -0 into 0.
            const auto [it, is_new] = known.try_emplace(
                {vertices(0, i) + 0.0, vertices(1, i) + 0.0, vertices(2, i) + 0.0},
                static_cast<int>(m_places.size()));
            if (is_new) {
                m_places.emplace_back(vertices.col(i));
            }
            m_corner_of.push_back(it->second);
        }
        m_corners.resize(m_places.size());
    }

    void add(const std::array<int, 3>& triangle) {
        std::array<int, 3> corners{};
        for (size_t k = 0; k < 3; ++k) {
            if (triangle[k] < 0 || triangle[k] >= std::ssize(m_corner_of)) {
                throw std::invalid_argument(
                    fmt::format("a triangle of the surface has vertex {} of {}", triangle[k],
                                m_corner_of.size()));
            }
            corners[k] = m_corner_of[static_cast<size_t>(triangle[k])];
        }
        const Eigen::Vector3d ab = place(corners[1]) - place(corners[0]);
        const Eigen::Vector3d ac = place(corners[2]) - place(corners[0]);
        const Eigen::Vector3d area = ab.cross(ac);
        const double longest =
            std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
        if (!(area.norm() > smallest_area * longest)) {
            ++m_left_out;
            return;
        }
        const Eigen::Vector3d normal = area.normalized();
        m_triangles.push_back(corners);
        m_face_normals.push_back(normal);
        for (size_t k = 0; k < 3; ++k) {
            const int here = corners[k];
            const int next = corners[(k + 1) % 3];
            Feature& edge = m_edges[std::minmax(here, next)];
            add_to_normal(edge.normal, normal);
            ++edge.faces;
            const Eigen::Vector3d u = place(next) - place(here);
            const Eigen::Vector3d v = place(corners[(k + 2) % 3]) - place(here);
            const double angle = std::atan2(u.cross(v).norm(), u.dot(v));
            add_to_normal(m_corners[static_cast<size_t>(here)].normal, angle * normal);
        }
    }

    void find_border() {
        for (auto& [ends, edge] : m_edges) {
            edge.is_border = edge.faces == 1;
            if (edge.is_border) {
                m_corners[static_cast<size_t>(ends.first)].is_border = true;
                m_corners[static_cast<size_t>(ends.second)].is_border = true;
            }
        }
    }

    [[nodiscard]] const Feature& feature_of(int triangle,
                                            const std::array<bool, 3>& between) const {
        const std::array<int, 3>& corners = m_triangles[static_cast<size_t>(triangle)];
        std::array<int, 2> named{-1, -1};
        size_t count = 0;
        for (size_t k = 0; k < 3; ++k) {
            if (between[k]) {
                named[count++] = corners[k];
            }
        }
        return count == 1 ? m_corners[static_cast<size_t>(named[0])]
                          : m_edges.at(std::minmax(named[0], named[1]));
    }

    std::vector<Eigen::Vector3d> m_places;
    std::vector<int> m_corner_of;  ///< place of each vertex
    std::vector<std::array<int, 3>> m_triangles;
    std::vector<Eigen::Vector3d> m_face_normals;
    std::vector<Feature> m_corners;
    std::map<std::pair<int, int>, Feature> m_edges;
    Eigen::KdBVH<double, 3, int> m_tree;
    int m_left_out = 0;
};

TargetSurface::TargetSurface(const Points& vertices,
                             const std::vector<std::array<int, 3>>& triangles)
    : m_search(std::make_unique<const Search>(vertices, triangles)) {}
TargetSurface::~TargetSurface() = default;
TargetSurface::TargetSurface(TargetSurface&&) noexcept = default;
TargetSurface& TargetSurface::operator=(TargetSurface&&) noexcept = default;

SurfacePoint TargetSurface::nearest(const Eigen::Vector3d& point) const {
    return m_search->nearest(point);
}

int TargetSurface::triangle_count() const {
    return m_search->triangle_count();
}

int TargetSurface::left_out() const {
    return m_search->left_out();
}

}  // namespace taut
