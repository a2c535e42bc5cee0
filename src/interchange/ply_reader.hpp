// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace taut {

/// What a PLY file holds of a surface (G. Turk, The PLY Polygon File Format, Stanford 1994).
struct PlyContent {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::vector<int>> faces;  ///< corners, from 0; not checked against the vertices
};

/// @param content of a file that begins with "ply"; text, or binary of either byte order
/// @throws InputError with the line, or the element, for what breaks the format, is cut or goes on
///   behind its end, for vertices without x, y, z or a coordinate that is not finite
[[nodiscard]] PlyContent read_ply(std::string_view content, const std::string& file_name);

}  // namespace taut
