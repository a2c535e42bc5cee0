// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/net/cable_net.hpp"

/// @file
/// What is given for edges and nodes of a plan in files. All throw InputError with the line, for a
/// name that is not of the net or comes twice, a number that is none, and an empty file. The header
/// may be left out.
namespace taut {

/// How far an edge may be turned.
struct StrokeRange {
    int edge = 0;           ///< index in the net
    double shortest = 0.0;  ///< 0 or less [m]
    double longest = 0.0;   ///< 0 or more [m]
};

/// edge,shortest,longest in m; edges that are not named may not be turned.
/// @return in the order of the file, at least one
/// @throws InputError as of all, and for a range that does not hold 0
[[nodiscard]] TAUT_IO_EXPORT std::vector<StrokeRange> parse_stroke_ranges(
    const CableNet& net, std::string_view text, const std::string& file_name);

/// id,x,y,z in N, one node a line; 3 x n, 0 for nodes that are not named [N].
/// @throws InputError as parse_stroke_ranges()
[[nodiscard]] TAUT_IO_EXPORT Points parse_loads(const CableNet& net, std::string_view text,
                                                const std::string& file_name);

/// Weights of the squares of a node's deviations.
struct NodeWeights {
    int node = 0;             ///< index of a free node
    double normal = 0.0;      ///< of the deviation along the normal, 0 or more
    double tangential = 0.0;  ///< of the deviation across it, 0 or more
};

/// id,normal,tangential: free nodes, weights of 0 or more.
/// @return in the order of the file, at least one
/// @throws InputError as parse_stroke_ranges(), and for a support or a negative weight
[[nodiscard]] TAUT_IO_EXPORT std::vector<NodeWeights> parse_node_weights(
    const CableNet& net, std::string_view text, const std::string& file_name);

}  // namespace taut
