// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "taut/export/adjustment.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The point of a surface that is nearest to another point.
struct SurfacePoint {
    Eigen::Vector3d place;  ///< on the surface [m]
    /// Unit normal of the surface there, on either side: of the face; at an edge or corner of faces
    /// the direction to the other point, or the mean of the faces where that is on the surface, or
    /// beyond its border.
    Eigen::Vector3d normal;
    double distance = 0.0;       ///< to it [m]
    double beyond_border = 0.0;  ///< how far the other point is beyond the border, across `normal`
};

/// A surface of triangles, to be searched for its nearest points. Vertices at the same place are
/// one; the sides of faces need not agree. One object serves several threads at once. Once moved
/// from, it may only be assigned to or destroyed.
class TAUT_ADJUSTMENT_EXPORT TargetSurface {
public:
    /// @param vertices 3 x v [m]
    /// @param triangles three vertices each; those without area are left out
    /// @throws std::invalid_argument for a coordinate that is not finite, a vertex out of range,
    ///   and where no triangle is left
    TargetSurface(const Points& vertices, const std::vector<std::array<int, 3>>& triangles);
    ~TargetSurface();
    TargetSurface(const TargetSurface&) = delete;
    TargetSurface& operator=(const TargetSurface&) = delete;
    /// Leaves the other one without triangles.
    TargetSurface(TargetSurface&&) noexcept;
    /// Leaves the other one without triangles.
    TargetSurface& operator=(TargetSurface&&) noexcept;

    /// The point of the surface that is nearest to another.
    /// @param point finite, not checked [m]
    [[nodiscard]] SurfacePoint nearest(const Eigen::Vector3d& point) const;

    /// Those with an area, at least one.
    [[nodiscard]] int triangle_count() const;
    /// Triangles without area, which were left out.
    [[nodiscard]] int left_out() const;

private:
    class Search;
    std::unique_ptr<const Search> m_search;
};

}  // namespace taut
