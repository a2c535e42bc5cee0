// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "taut/adjustment/form_target.hpp"
#include "taut/adjustment/limits.hpp"
#include "taut/adjustment/tension_target.hpp"
#include "taut/export/io.hpp"
#include "taut/net/cable_net.hpp"

/// @file
/// What is given for edges and nodes of a plan in files. All throw InputError, with the line for a
/// name that is not of the net or comes twice, a number that is none, and an empty file. The header
/// may be left out.
namespace taut {

/// edge,shortest,longest in m; edges that are not named may not be turned.
/// @return in the order of the file, at least one
/// @throws InputError as of all, and for a range that does not hold 0
[[nodiscard]] TAUT_IO_EXPORT std::vector<StrokeRange> parse_stroke_ranges(
    const CableNet& net, std::string_view text, const std::string& file_name);

/// id,x,y,z in N, one node a line; 3 x n, 0 for nodes that are not named [N].
/// @throws InputError as parse_stroke_ranges()
[[nodiscard]] TAUT_IO_EXPORT Points parse_loads(const CableNet& net, std::string_view text,
                                                const std::string& file_name);

/// id,normal,tangential: free nodes, weights of 0 or more.
/// @return in the order of the file, at least one
/// @throws InputError as parse_stroke_ranges(), and for a support or a negative weight
[[nodiscard]] TAUT_IO_EXPORT std::vector<NodeWeights> parse_node_weights(
    const CableNet& net, std::string_view text, const std::string& file_name);

/// edge,tension[,tolerance] in N, one edge a line, all above 0; without tolerance that of
/// GivenTension.
/// @return in the order of the file, at least one
/// @throws InputError as parse_stroke_ranges(), and for a tension or tolerance that is not positive
[[nodiscard]] TAUT_IO_EXPORT std::vector<GivenTension> parse_target_tensions(
    const CableNet& net, std::string_view text, const std::string& file_name);

/// The target of a plan: a form, as read_form(), or a surface of
/// triangles, .obj or .ply.
/// @param file its name; empty: the net's own nodes
/// @param unit of a surface's coordinates [m]
/// @throws InputError as these
/// @throws RequestError for the unit of a form, which is always m
[[nodiscard]] TAUT_IO_EXPORT GivenTarget read_target(const CableNet& net,
                                                     const std::filesystem::path& file,
                                                     double unit = 1.0);

}  // namespace taut
