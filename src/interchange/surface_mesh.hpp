// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// A surface of flat faces, as another program wrote it.
struct SurfaceMesh {
    Points vertices;                            ///< 3 x v, in the unit of the file
    std::vector<std::array<int, 3>> triangles;  ///< faces, those of more corners cut into triangles
    int faces = 0;                              ///< before they were cut
};

/// Whether the name of a file ends as that of a surface does: .obj, .ply, in capitals too.
[[nodiscard]] TAUT_IO_EXPORT bool is_surface_mesh_name(const std::filesystem::path& path);

/// Reads the vertices and faces of an OBJ (text) or PLY file (text, or binary of either byte
/// order), whichever it is; coordinates to full double precision. Everything else that it holds is
/// passed over.
/// @param file_name for messages
/// @throws InputError with the line, or the element, for a file that is neither, is cut, holds a
///   coordinate that is not finite, a face of a vertex that is not there, or no face
[[nodiscard]] TAUT_IO_EXPORT SurfaceMesh parse_surface_mesh(std::string_view content,
                                                            const std::string& file_name);

}  // namespace taut
