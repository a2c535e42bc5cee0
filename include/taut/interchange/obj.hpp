// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "taut/export/io.hpp"
#include "taut/interchange/imported_structure.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Reads the vertices (v), lines (l) and faces (f) of an OBJ file as nodes and edges; a vertex is
/// named by its number, from 1. The points (p) of a group "supports" are supports. Other groups,
/// normals, textures and materials mean nothing here.
/// @param file_name for messages
/// @throws InputError with the line
[[nodiscard]] TAUT_IO_EXPORT ImportedStructure parse_obj(std::string_view text,
                                                         const std::string& file_name);

/// A form as OBJ: a vertex a node, a line an edge, the supports as points of the group "supports".
/// What OBJ has no place for stands in comments: names, tensions, force densities, unstressed
/// lengths and axial stiffnesses.
/// @param form 3 x n [m]
/// @throws std::invalid_argument for another size, a coordinate that is not finite, and an edge of
///   no length
[[nodiscard]] TAUT_IO_EXPORT std::string form_to_obj(const CableNet& net, const Points& form);

}  // namespace taut
