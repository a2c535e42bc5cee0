// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace taut {

/// Faces of more corners than this are refused [-].
inline constexpr size_t most_corners = 256;

/// Cuts a polygon, all but flat and without crossings, into triangles, ears first that leave the
/// shortest side (G. H. Meisters, Polygons have ears, 1975): a warped quadrilateral along its
/// shorter diagonal, and one that is not convex along the one inside.
/// @param corners 3 x c, 3 <= c, in their order round
/// @return c - 2 triples of corners
[[nodiscard]] std::vector<std::array<int, 3>> triangles_of_polygon(const Eigen::Matrix3Xd& corners);

}  // namespace taut
