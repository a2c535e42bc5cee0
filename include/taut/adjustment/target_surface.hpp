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
    /// Unit normal of the surface there, on either side. Within a face it is that of the face. At
    /// an edge or corner it is the direction to the other point; where that lies on the surface, or
    /// beyond its border, the mean of the faces.
    Eigen::Vector3d normal;
    double distance = 0.0;       ///< to the other point [m]
    double beyond_border = 0.0;  ///< of the other point, across `normal`; 0 inside [m]
};

/// A surface of triangles, searched for its nearest points. Vertices at the same place are one, and
/// the orientations of faces need not agree. One object serves several threads at once. A
/// moved-from object may only be assigned to or destroyed.
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
    TargetSurface(TargetSurface&&) noexcept;             ///< moves
    TargetSurface& operator=(TargetSurface&&) noexcept;  ///< moves

    /// The point of the surface that is nearest to another.
    /// @param point finite, not checked [m]
    [[nodiscard]] SurfacePoint nearest(const Eigen::Vector3d& point) const;

    /// Triangles with an area, at least one.
    [[nodiscard]] int triangle_count() const;
    /// Triangles without area, which were left out.
    [[nodiscard]] int left_out() const;

private:
    class Search;
    std::unique_ptr<const Search> m_search;
};

}  // namespace taut
